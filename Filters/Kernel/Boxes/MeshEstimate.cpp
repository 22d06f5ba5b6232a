// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/MeshEstimate.h"

#include "Base/Error.h"
#include "Boxes/IntersectedBoxes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace cartesian
{

namespace
{

// Bytes. What several stages take, with the arrays that VTK holds, measured on one to 16 threads; the peak of a
// mesh is that of one of these stages.
constexpr double OfAnyMesh = 14.3e6;
constexpr double OfAThread = 8e4; // except the first
constexpr double OfATriangle = 115;

// Of each box, of each that is intersected, and of each corner of a patch.
struct BytesOfAStage
{
  double box;
  double intersected;
  double corner;
};

constexpr BytesOfAStage Cutting{ 110, 1000, 60 };
constexpr BytesOfAStage Editing{ 150, 6300, 0 };
constexpr BytesOfAStage EditingExact{ 150, 300, 800 };
constexpr BytesOfAStage Writing{ 220, 1600, 44 };
constexpr BytesOfAStage WritingExact{ 220, 1940, 125 };
constexpr BytesOfAStage Layering{ 730, 2900, 510 };
constexpr double OfALayersCorner = 315;
constexpr double OfALayersExactCorner = 465;

// A surface leaves about this many times 4^d boxes inside a box of depth d.
constexpr double BoxesBesideUnits = 0.4;

// For each octant that the surface requires: boxes of its transition, a layer. 4 where surfaces bend, 8 along edges.
constexpr double BoxesOfATransitionLayer = 8;

// Walls close to each other share units: more than these are rarely intersected, of all in a box, and of 4^d.
constexpr double MostUnits = 0.7;
constexpr double MostLayersOfUnits = 2;

// Corners of exact patches for each piece of a triangle and for each box.
constexpr double CornersOfAPiece = 3.3;
constexpr double CornersOfAnExactBox = 2.5;
constexpr double CornersOfABox = 5; // of other patches

// Pieces of as many triangles as pass through a global box, in the units of it that the surface passes through.
double piecesIn(double units, double triangles)
{
  constexpr double OnSides = 1.4;
  return units > 1 ? triangles + units + OnSides * std::sqrt(triangles * units) : triangles;
}

// The number of boxes that a triangle passes through, from the spacing around its centroid.
double boxesOfTriangle(const Corners& c, const Meshlines& planes)
{
  std::array<double, 3> u;
  std::array<double, 3> v;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double h = spacing(planes[axis], (double(c[0][axis]) + c[1][axis] + c[2][axis]) / 3);
    u[axis] = (double(c[1][axis]) - c[0][axis]) / h;
    v[axis] = (double(c[2][axis]) - c[0][axis]) / h;
  }
  double sum = 0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::size_t b = (a + 1) % 3;
    sum += std::abs(u[a] * v[b] - u[b] * v[a]) / 2;
  }
  return sum;
}

}

double MeshEstimate::bytes(const MemoryLimit& limit) const
{
  const double corners = limit.exact ? CornersOfAPiece * pieces + CornersOfAnExactBox * intersected
                                     : CornersOfABox * intersected;
  return bytes(limit, { corners, corners });
}

double MeshEstimate::bytes(const MemoryLimit& limit, const PatchCorners& corners) const
{
  const auto of = [&](const BytesOfAStage& stage, double count) {
    return stage.box * boxes() + stage.intersected * intersected + stage.corner * count;
  };
  double most =
    std::max(of(Cutting, corners.all), of(limit.exact ? WritingExact : Writing, corners.kept));
  if (limit.edits)
  {
    most = std::max(most, of(limit.exact ? EditingExact : Editing, corners.kept));
  }
  if (limit.layers > 0)
  {
    const double ofACorner = limit.exact ? OfALayersExactCorner : OfALayersCorner;
    most = std::max(most, of(Layering, corners.kept) + limit.layers * ofACorner * corners.kept);
  }
  return OfAnyMesh + OfAThread * (limit.threads - 1) + OfATriangle * triangles + most;
}

void MeshEstimate::add(const MeshEstimate& part)
{
  inside += part.inside;
  intersected += part.intersected;
  pieces += part.pieces;
}

std::vector<float> areasInBoxes(
  const Surface& surface, const Meshlines& planes, const Shoeboxes& shoeboxes)
{
  std::vector<float> areas(surface.triangles.size());
  for (const std::uint32_t t : shoeboxes.triangle)
  {
    ++areas[t];
  }
  for (std::size_t t = 0; t < areas.size(); ++t)
  {
    if (areas[t] > 0)
    {
      areas[t] = static_cast<float>(boxesOfTriangle(surface.corners(t), planes)) / areas[t];
    }
  }
  return areas;
}

MeshEstimate estimateBox(BoxStatus status, const Depths& depths,
  const std::vector<TouchedPart>& touched, int transitionLayers, const TriangleRange& triangles,
  const std::vector<float>& areas)
{
  const auto passing = static_cast<double>(triangles.second - triangles.first);
  const double area = depths.deepest() == 0
    ? 0
    : std::accumulate(triangles.first, triangles.second, 0.0,
        [&](double sum, std::uint32_t t) { return sum + double(areas[t]); });
  const auto wholly = [&](int allowed, int forced) -> MeshEstimate {
    const double forcedBoxes = std::pow(8, forced);
    if (status != BoxStatus::Intersected)
    {
      return { forcedBoxes };
    }
    const double layer = std::pow(4, allowed);
    const double units = allowed == 0
      ? 1
      : std::clamp(
          area * layer, 1., std::min(MostLayersOfUnits * layer, MostUnits * std::pow(8, allowed)));
    const double beside = allowed == 0 ? 0 : BoxesBesideUnits * layer;
    return { std::max(forcedBoxes - units, beside), units, piecesIn(units, passing) };
  };
  MeshEstimate result = wholly(depths.allowed, depths.forced);
  if (depths.sized > 0)
  {
    // Octants that the surface requires, and those that contain them; the rest of the latter are empty or inside.
    const auto octants = static_cast<double>(depths.octants);
    const double units = result.intersected + octants;
    const double around = BoxesOfATransitionLayer * (transitionLayers - 1) * octants;
    result = { result.inside + units + around, status == BoxStatus::Intersected ? units : 0,
      piecesIn(units, passing) };
  }
  for (const auto& [depth, share] : touched)
  {
    const MeshEstimate with = wholly(std::max(depths.allowed, depth), depth);
    const auto mixed = [part = share](double without, double within) {
      return without + part * std::max(0.0, within - without);
    };
    result = { mixed(result.inside, with.inside), mixed(result.intersected, with.intersected),
      mixed(result.pieces, with.pieces) };
  }
  return result;
}

MeshEstimate estimateOf(double boxes, double intersected, double triangles)
{
  return { std::max(0.0, boxes - intersected), intersected, piecesIn(intersected, triangles),
    triangles };
}

MeshEstimate estimateMesh(const Surface& surface, const Meshlines& planes)
{
  double intersected = 0;
  Bounds bounds = Bounds::none();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners c = surface.corners(t);
    intersected += boxesOfTriangle(c, planes);
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds.include(axis, c[0][axis]);
      bounds.include(axis, c[1][axis]);
      bounds.include(axis, c[2][axis]);
    }
  }
  double all = 1;
  double extent = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    all *= static_cast<double>(planes[axis].size() - 1);
    extent *= std::max(2.0, bounds.high[axis] - bounds.low[axis]) * surface.lattice.step();
  }
  const double inside =
    surface.around.inside() ? all : all * std::min(1.0, std::abs(volumeOf(surface)) / extent);
  return estimateOf(
    inside + intersected, intersected, static_cast<double>(surface.triangles.size()));
}

std::vector<MeshEstimate> estimateLayers(
  const Shoeboxes& shoeboxes, const Boxes& boxes, Execution& execution)
{
  std::vector<MeshEstimate> layers(boxes.allLayers().end);
  execution.forEach(layers.size(), 1, [&](std::size_t k, std::size_t) {
    const std::size_t last = boxes.rowStart[boxes.row(0, k + 1)];
    for (std::size_t g = boxes.rowStart[boxes.row(0, k)]; g < last; ++g)
    {
      const GlobalBox& global = boxes.globals[g];
      const PackedBox* const begin = boxes.packed.data() + global.firstBox;
      const PackedBox* const end = boxes.packed.data() + boxes.globals[g + 1].firstBox;
      const double intersected = countIntersected(begin, end);
      const TriangleRange triangles = intersected == 0
        ? TriangleRange{ nullptr, nullptr }
        : shoeboxes.triangles(boxes.row(global.index[1], global.index[2]), global.index[0]);
      layers[k].add({ static_cast<double>(end - begin) - intersected, intersected,
        piecesIn(intersected, static_cast<double>(triangles.second - triangles.first)) });
    }
  });
  return layers;
}

void checkMemory(const MeshEstimate& estimate, const MemoryLimit& limit)
{
  checkMemory(estimate.boxes(), estimate.bytes(limit), limit);
}

void checkMemory(double boxes, double bytes, const MemoryLimit& limit)
{
  constexpr double GiB = 1024.0 * 1024 * 1024;
  if (bytes > limit.bytes)
  {
    std::array<char, 300> text;
    std::snprintf(text.data(), text.size(),
      "The mesh would have about %.4g boxes and take about %.4g GiB, more than the Memory Limit of "
      "%.4g GiB: choose a larger Cell Size or less refinement, or raise the limit.",
      boxes, bytes / GiB, limit.bytes / GiB);
    throw Error(Fault::TooManyBoxes, text.data());
  }
}

}

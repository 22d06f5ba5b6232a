// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/MeshEstimate.h"

#include "Base/Error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cartesian
{

namespace
{

// Peak memory of all stages, with the arrays that VTK holds, where there are threads for all slabs.
constexpr double BytesOfAnyMesh = 3.8e6;
constexpr double BytesOfABox = 260;
constexpr double BytesOfATriangle = 150;
constexpr double BytesOfACorner = 145; // of a patch
constexpr double BytesOfAnIntersectedBox = 1800;
constexpr double BytesOfAShapedBox = 4900; // where few patches are exact, on very many threads

// A surface passes through about this many times 4^d units of a box of depth d, and leaves about this many
// times 4^d boxes inside.
constexpr double UnitsAcrossABox = 1.1;
constexpr double BoxesBesideUnits = 0.4;

// Exact patches have so many corners for each piece of a triangle and for each box.
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
  return bytes(limit,
    limit.exact ? CornersOfAPiece * pieces + CornersOfAnExactBox * intersected
                : CornersOfABox * intersected);
}

double MeshEstimate::bytes(const MemoryLimit& limit, double corners) const
{
  const bool shapes = limit.shapes && !limit.exact;
  return BytesOfAnyMesh + boxes() * BytesOfABox + triangles * BytesOfATriangle +
    corners * BytesOfACorner + intersected * (shapes ? BytesOfAShapedBox : BytesOfAnIntersectedBox);
}

void MeshEstimate::add(const MeshEstimate& part)
{
  inside += part.inside;
  intersected += part.intersected;
  pieces += part.pieces;
}

MeshEstimate estimateBox(BoxStatus status, const Depths& depths, const TriangleRange& triangles)
{
  const auto passing = static_cast<double>(triangles.second - triangles.first);
  const auto wholly = [&](int allowed, int forced) -> MeshEstimate {
    const double forcedBoxes = std::pow(8, forced);
    if (status != BoxStatus::Intersected)
    {
      return { forcedBoxes, 0, 0, 0 };
    }
    const double layer = std::pow(4, allowed);
    const double units = allowed == 0 ? 1 : std::min(std::pow(8, allowed), UnitsAcrossABox * layer);
    const double beside = allowed == 0 ? 0 : BoxesBesideUnits * layer;
    return { std::max(forcedBoxes - units, beside), units, piecesIn(units, passing), 0 };
  };
  const MeshEstimate without = wholly(depths.allowed, depths.forced);
  if (depths.touched == 0)
  {
    return without;
  }
  // Where regions' borders pass, they touch half of the global boxes, more or less.
  const MeshEstimate with = wholly(depths.deepest(), depths.touched);
  return { (without.inside + with.inside) / 2, (without.intersected + with.intersected) / 2,
    (without.pieces + with.pieces) / 2, 0 };
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
  const auto triangles = static_cast<double>(surface.triangles.size());
  return { inside, intersected, piecesIn(intersected, triangles), triangles };
}

MeshEstimate estimateMesh(const Surface& surface, const Shoeboxes& shoeboxes, const Boxes& boxes)
{
  MeshEstimate sum;
  sum.triangles = static_cast<double>(surface.triangles.size());
  for (std::size_t g = 0; g + 1 < boxes.globals.size(); ++g)
  {
    const GlobalBox& global = boxes.globals[g];
    const auto begin = boxes.packed.begin() + global.firstBox;
    const auto end = boxes.packed.begin() + boxes.globals[g + 1].firstBox;
    const auto intersected = static_cast<double>(std::count_if(
      begin, end, [](const PackedBox& box) { return box.status == BoxStatus::Intersected; }));
    const TriangleRange triangles =
      shoeboxes.triangles(boxes.row(global.index[1], global.index[2]), global.index[0]);
    sum.add({ static_cast<double>(end - begin) - intersected, intersected,
      piecesIn(intersected, static_cast<double>(triangles.second - triangles.first)), 0 });
  }
  return sum;
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
      "%.4g GiB: choose a larger Cell Size, less refinement, or raise the limit.",
      boxes, bytes / GiB, limit.bytes / GiB);
    throw Error(Fault::TooManyBoxes, text.data());
  }
}

}

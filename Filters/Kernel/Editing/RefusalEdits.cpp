// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/RefusalEdits.h"

#include "Editing/Refusals.h"
#include "Editing/WallEdges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace cartesian
{

namespace
{

// In boxes.
constexpr double CutTolerance = 0.03;
constexpr double CoarseTolerance = 0.1; // of planes that meet more nodes
constexpr double ShortEdge = 0.02;      // not cut across
constexpr double SameOffset = 0.02;     // between planes that are one

constexpr double SameCosine = 0.995; // 6 degrees: between planes that are one
constexpr double BackCosine = -0.8;  // 143 degrees: between walls back to back
constexpr std::size_t MostOfWalls = 10;
constexpr std::size_t MostOfEdges = 14;
constexpr std::size_t MostCoarse = 3;
constexpr std::size_t MostMerges = 3;

bool isBad(const MeshView& mesh, std::uint32_t f, std::uint32_t c)
{
  return mesh.face(f).skew || isInvertedFrom(mesh, f, c);
}

// Planes, each once; those of the lowest rank come first.
class RankedPlanes
{
public:
  explicit RankedPlanes(double edge)
    : edge_(edge)
  {
  }

  void add(const Vector& through, const Vector& normal, double rank)
  {
    const bool isKnown = std::any_of(planes_.begin(), planes_.end(), [&](const auto& known) {
      return std::abs(dot(known.second.normal, normal)) > SameCosine &&
        std::abs(dot(minus(known.second.through, through), normal)) < SameOffset * edge_;
    });
    if (!isKnown)
    {
      planes_.push_back({ rank, { through, normal, CutTolerance * edge_, true } });
    }
  }

  void moveTo(std::vector<CutPlane>& planes, std::size_t most)
  {
    std::stable_sort(planes_.begin(), planes_.end(),
      [](const auto& x, const auto& y) { return x.first < y.first; });
    for (std::size_t i = 0; i < std::min(most, planes_.size()); ++i)
    {
      planes.push_back(planes_[i].second);
    }
    planes_.clear();
  }

private:
  double edge_;
  std::vector<std::pair<double, CutPlane>> planes_;
};

// Whether an inverted wall of the cell looks the other way.
bool isBackToBack(const MeshView& mesh, std::uint32_t f, std::uint32_t c)
{
  const Vector normal = unit(mesh.face(f).area);
  const Items faces = mesh.facesOf(c);
  return mesh.isSurface(f) && std::any_of(faces.begin(), faces.end(), [&](std::uint32_t g) {
    return mesh.isSurface(g) && isInvertedFrom(mesh, g, c) &&
      dot(unit(mesh.face(g).area), normal) < BackCosine;
  });
}

// In the planes of the cell's faces: those that are refused, walls back to back with them, other walls, inner faces.
void addPlanesOfFaces(const MeshView& mesh, std::uint32_t c, std::vector<CutPlane>& planes)
{
  enum
  {
    Bad,
    Back,
    Wall,
    Inner,
    Kinds
  };
  const double edge = mesh.cell(c).edge;
  const auto kindOf = [&](std::uint32_t f) {
    return isBad(mesh, f, c)     ? Bad
      : isBackToBack(mesh, f, c) ? Back
      : mesh.isSurface(f)        ? Wall
                                 : Inner;
  };
  RankedPlanes ranked(edge);
  for (int kind = 0; kind < Kinds; ++kind)
  {
    for (const std::uint32_t f : mesh.facesOf(c))
    {
      const EditFace& face = mesh.face(f);
      const double area = norm(face.area);
      if (area > 0 && kindOf(f) == kind)
      {
        ranked.add(face.centre, unit(face.area), kind * 1e3 - area / (edge * edge));
      }
    }
  }
  ranked.moveTo(planes, MostOfWalls);
}

// Across the edges of refused walls and along them, at the rim and through the middle, straight and oblique.
void addPlanesAcross(const MeshView& mesh, std::uint32_t c, std::vector<CutPlane>& planes)
{
  const double edge = mesh.cell(c).edge;
  RankedPlanes ranked(edge);
  for (const std::uint32_t f : mesh.facesOf(c))
  {
    const EditFace& face = mesh.face(f);
    if (!isBad(mesh, f, c) || !mesh.isSurface(f) || !(norm(face.area) > 0))
    {
      continue;
    }
    const Vector normal = unit(face.area);
    for (std::size_t i = 0; i < face.corners.size; ++i)
    {
      const Vector& p = mesh.corner(f, i);
      const Vector& q = mesh.corner(f, (i + 1) % face.corners.size);
      const double length = norm(minus(p, q));
      if (length < ShortEdge * edge)
      {
        continue;
      }
      const Vector along = scaled(minus(q, p), 1 / length);
      const Vector aside = unit(cross(along, normal));
      const Vector middle = scaled(plus(p, q), 0.5);
      ranked.add(middle, aside, -length);
      ranked.add(face.centre, aside, 1e3 - length);
      ranked.add(face.centre, along, 2e3 - length);
      ranked.add(middle, unit(plus(aside, normal)), 3e3 - length);
      ranked.add(middle, unit(minus(aside, normal)), 3e3 - length);
    }
  }
  ranked.moveTo(planes, MostOfEdges);
}

// A refused face goes to a neighbour, becomes part of another face between the same cells, or of the wall beside it.
void addPassesAndJoins(const MeshView& mesh, std::uint32_t c, std::vector<RefusalEdit>& edits)
{
  for (const std::uint32_t g : mesh.facesOf(c))
  {
    for (std::size_t i = 0; isBad(mesh, g, c) && i < mesh.facesOf(c).size(); ++i)
    {
      const std::uint32_t f = mesh.facesOf(c)[i];
      if (f == g)
      {
        continue;
      }
      if (mesh.beyond(g, c) == mesh.beyond(f, c))
      {
        if (!mesh.isSurface(f) || (couldJoin(mesh, f, g, c) && sharpnessBetween(mesh, f, g) == 0))
        {
          edits.push_back({ RefusalEdit::Kind::Join, f, g });
        }
      }
      else if (!mesh.isSurface(f))
      {
        edits.push_back({ RefusalEdit::Kind::Pass, f, g, c });
        if (!mesh.isSurface(g) && mesh.face(g).skew)
        {
          edits.push_back({ RefusalEdit::Kind::Pass, g, f, c });
        }
      }
    }
  }
}

}

std::vector<RefusalEdit> editsOfRefused(const MeshView& mesh, std::uint32_t c)
{
  std::vector<RefusalEdit> edits;
  addPassesAndJoins(mesh, c, edits);
  std::vector<CutPlane> planes;
  addPlanesOfFaces(mesh, c, planes);
  addPlanesAcross(mesh, c, planes);
  const std::size_t fine = planes.size();
  for (std::size_t i = 0; i < std::min(fine, MostCoarse); ++i)
  {
    planes.push_back(planes[i]);
    planes.back().tolerance = CoarseTolerance * mesh.cell(c).edge;
  }
  for (const CutPlane& plane : planesThroughMiddle(mesh, c))
  {
    planes.push_back(plane);
  }
  for (const CutPlane& plane : planes)
  {
    edits.push_back({ RefusalEdit::Kind::Cut, c, 0, 0, plane });
  }
  const Neighbours neighbours = largestNeighbours(mesh, c);
  for (std::size_t i = 0; i < std::min(MostMerges, neighbours.size()); ++i)
  {
    edits.push_back({ RefusalEdit::Kind::Merge, neighbours[i], c });
  }
  return edits;
}

std::vector<CutPlane> planesThroughMiddle(const MeshView& mesh, std::uint32_t c)
{
  return planesAcross(mesh, c, { 0 });
}

std::vector<CutPlane> planesAcross(
  const MeshView& mesh, std::uint32_t c, std::initializer_list<double> places)
{
  const EditCell& cell = mesh.cell(c);
  std::array<std::pair<double, std::size_t>, 3> extents; // negative: the longest comes first
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const std::uint32_t f : mesh.facesOf(c))
    {
      for (const std::uint32_t n : mesh.cornersOf(f))
      {
        low = std::min(low, mesh.node(n).at[axis]);
        high = std::max(high, mesh.node(n).at[axis]);
      }
    }
    extents[axis] = { low - high, axis };
  }
  std::sort(extents.begin(), extents.end());
  std::vector<CutPlane> planes;
  for (const double place : places)
  {
    for (const auto& [extent, axis] : extents)
    {
      Vector through = cell.centre;
      through[axis] -= place * extent;
      Vector normal{};
      normal[axis] = 1;
      planes.push_back({ through, normal, CutTolerance * cell.edge, true });
    }
  }
  return planes;
}

}

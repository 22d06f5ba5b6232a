// SPDX-License-Identifier: BSD-3-Clause
// The triangulated surface on the lattice (sections 4.1, 4.2; steps 2 and 3).
#pragma once

#include "Base/Execution.h"
#include "Lattice/Crossing.h"
#include "Lattice/Vector.h"
#include "Surface/FeatureEdgeTags.h"
#include "Surface/Walls.h"
#include "Surface/Winding.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace cartesian
{

// The caller's triangles in user units, borrowed. They may be oriented either way.
struct SurfaceView
{
  const double* points = nullptr; // x, y, z of each point
  std::size_t pointCount = 0;
  const std::uint32_t* triangles = nullptr; // three points each
  std::size_t triangleCount = 0;
  const std::int32_t* boundary = nullptr; // boundary index of each triangle; null: all 0
  const long long* cells = nullptr; // the user's number of each triangle, for messages, or null
  const std::int32_t* region =
    nullptr; // of each triangle, from FirstRegion; null: there is only one
  const std::vector<std::string>* regionNames = nullptr; // in order, for messages; null: none
  const std::uint32_t* sharpEdges = nullptr; // two points each; points at the same place are one
  std::size_t sharpEdgeCount = 0;
  const std::uint8_t* knowsEdges =
    nullptr; // of each triangle; 1: of its edges only those are sharp; null: all 0
  const std::uint8_t* isSheet =
    nullptr; // of each triangle; 1: of a sheet (OpenSheets.h), whatever its rim is; null: all 0

  std::array<Vector, 3> corners(std::size_t triangle) const
  {
    std::array<Vector, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double* p = points + 3 * std::size_t(triangles[3 * triangle + i]);
      corners[i] = { p[0], p[1], p[2] };
    }
    return corners;
  }
};

// The bounds of all points that triangles use. Throws Error: EmptySurface, BadCoordinate (with the
// point's id), BadParameter (a triangle refers to a point that does not exist).
Bounds boundsOf(const SurfaceView& view, Execution& execution);
Bounds boundsOf(const SurfaceView& view); // on one thread

struct Surface
{
  Lattice lattice;
  double rounding = 1;         // how far off the file's precision puts vertices, in levels
  std::vector<Point> vertices; // distinct
  std::vector<std::array<std::uint32_t, 3>>
    triangles;                        // oriented either way until orient() (Orientation.h)
  std::vector<std::int32_t> boundary; // of each triangle
  std::vector<std::int32_t> region; // of each triangle, until separateRegions(); empty: one region
  Walls walls;                      // from then on
  Winding around;                   // of what is far from the surface (FlowDomain.h)
  EndBoundaries ends = NoEnds;      // where the grid cuts the domain
  std::vector<std::uint32_t>
    given; // of each triangle, its number in the view; none: it closes a hole
  std::vector<std::uint8_t> ofSheet; // of the first triangles, 1: of a sheet (ThinSheets.h)
  std::vector<std::uint8_t>
    byParity; // of each triangle; 1: no consistent orientation (Winding.h); empty: all 0
  std::shared_ptr<const FeatureEdgeTags> knownEdges; // of the triangles given; null: of none

  Corners corners(std::size_t triangle) const
  {
    const auto& t = triangles[triangle];
    return { vertices[t[0]], vertices[t[1]], vertices[t[2]] };
  }

  // Whether a triangle is known to be of a sheet.
  bool isOfSheet(std::size_t triangle) const
  {
    return triangle < ofSheet.size() && ofSheet[triangle] != 0;
  }

  // What is known of the edge between two triangles.
  Known knownBetween(std::size_t a, std::size_t b) const
  {
    return knownEdges && std::max(a, b) < given.size() ? knownEdges->between(given[a], given[b])
                                                       : Known::Nothing;
  }

  // On the same lattice, with the same vertices.
  Surface withoutTriangles() const
  {
    Surface empty;
    empty.lattice = lattice;
    empty.rounding = rounding;
    empty.vertices = vertices;
    return empty;
  }

  // Those of another surface instead, with what is known of each; not whether they are of sheets.
  void takeTriangles(Surface& from)
  {
    triangles.swap(from.triangles);
    boundary.swap(from.boundary);
    given.swap(from.given);
    region.swap(from.region);
  }

  // With a triangle of another surface of the same vertices, which has a number in the view and a region.
  void append(const Surface& from, std::size_t triangle)
  {
    triangles.push_back(from.triangles[triangle]);
    boundary.push_back(from.boundary[triangle]);
    given.push_back(from.given[triangle]);
    region.push_back(from.region[triangle]);
  }

  // How the winding changes on a path that crosses a triangle; `up`: its normal points along the
  // path.
  Winding crossing(std::size_t triangle, bool up) const
  {
    if (walls.any())
    {
      const std::int32_t back = walls.front(boundary[triangle]) - walls.behind(boundary[triangle]);
      return { up ? back : -back, false };
    }
    return !byParity.empty() && byParity[triangle] != 0 ? Winding{ 0, true }
                                                        : Winding{ up ? -1 : 1, false };
  }
};

// Places a surface on the lattice. Points that share all three levels become one vertex. Vertices are
// in order of their places, each triangle starts from its lowest vertex, and triangles are in order of their
// vertices: nothing later depends on the order in which the view lists them, down to the rounding of sums.
Surface onLattice(const SurfaceView& view, const Lattice& lattice, Execution& execution);

// Some triangles of a surface, in their order, with the vertices that they use.
Surface partOf(const Surface& surface, const std::vector<std::uint32_t>& triangles);

// The user's number of each triangle, or -1: it closes a hole. `cells`: of the view's triangles.
template <class Id>
std::vector<Id> cellsOf(const Surface& surface, const std::vector<Id>& cells)
{
  std::vector<Id> result(surface.triangles.size(), -1);
  for (std::size_t t = 0; t < surface.given.size(); ++t)
  {
    result[t] = cells[surface.given[t]];
  }
  return result;
}

// In square and cubic user units.
double areaOf(const Surface& surface);

// What all regions enclose together; where parts overlap, each counts. Of one turned inside out: negative.
double volumeOf(const Surface& surface);

}

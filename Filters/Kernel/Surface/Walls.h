// SPDX-License-Identifier: BSD-3-Clause
// The regions on either side of a surface's triangles, if there are several.
#pragma once

#include "Base/BoundaryIndex.h"

#include <array>
#include <vector>

namespace cartesian
{

// The region of a vertex or a cell: 0 is outside, regions are numbered from 1.
constexpr std::int32_t OutsideRegion = 0;
constexpr std::int32_t FirstRegion = 1;

// Boundary indices of the grid's ends: low x, high x, low y, ...
using EndBoundaries = std::array<std::int32_t, 6>;
constexpr EndBoundaries NoEnds = { NoBoundary, NoBoundary, NoBoundary, NoBoundary, NoBoundary,
  NoBoundary };

// Triangles with the same regions and boundaries on either side. Normals point from behind to the front.
struct Wall
{
  std::int32_t behind;          // region, never outside
  std::int32_t front;           // region, or outside
  std::int32_t boundary;        // of the region behind
  std::int32_t boundaryInFront; // of the region in front, or NoBoundary

  bool isInterface() const { return front != OutsideRegion; }
};

// Of a surface with several regions, whose boundary indices are indices of walls up to the mesh that is written;
// empty: there is one region, and boundary indices are the user's. So everything that preserves borders between
// boundaries also preserves those between regions.
struct Walls
{
  std::vector<Wall> all;
  std::vector<std::int32_t>
    given; // of each region here, the user's that it is a part of; empty: the same

  std::int32_t givenOf(std::int32_t region) const
  {
    return given.empty() || region == OutsideRegion
      ? region
      : given[static_cast<std::size_t>(region - FirstRegion)];
  }

  // Whether a wall is a baffle: both its sides are of the same region.
  bool isBaffle(std::int32_t boundary) const
  {
    return isInterface(boundary) && givenOf(behind(boundary)) == givenOf(front(boundary));
  }

  bool any() const { return !all.empty(); }

  std::int32_t behind(std::int32_t boundary) const
  {
    return all.empty() ? FirstRegion : at(boundary).behind;
  }
  std::int32_t front(std::int32_t boundary) const
  {
    return all.empty() ? OutsideRegion : at(boundary).front;
  }
  bool isInterface(std::int32_t boundary) const
  {
    return !all.empty() && boundary != NoBoundary && at(boundary).isInterface();
  }

  // Whether two walls are between the same regions.
  bool areAlike(std::int32_t a, std::int32_t b) const
  {
    return behind(a) == behind(b) && front(a) == front(b);
  }

  // Whether a wall belongs to this boundary of the user's, on either side.
  bool isOf(std::int32_t wall, std::int32_t boundary) const
  {
    return all.empty() || wall == NoBoundary
      ? wall == boundary
      : at(wall).boundary == boundary || at(wall).boundaryInFront == boundary;
  }

  // The user's boundary, of the region in front.
  std::int32_t boundaryInFront(std::int32_t boundary) const { return at(boundary).boundaryInFront; }

  // The user's boundary, of the region behind.
  std::int32_t boundary(std::int32_t boundary) const
  {
    return all.empty() || boundary == NoBoundary ? boundary : at(boundary).boundary;
  }

private:
  const Wall& at(std::int32_t boundary) const { return all[static_cast<std::size_t>(boundary)]; }
};

}

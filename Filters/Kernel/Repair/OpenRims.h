// SPDX-License-Identifier: BSD-3-Clause
// The rims that the open edges of a surface form, and what is near along them.
#pragma once

#include "Surface/Surface.h"

#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace cartesian
{

// An edge that an odd number of triangles use, and one of these.
struct OpenEdge
{
  std::uint32_t triangle;
  std::uint32_t lower;
  std::uint32_t upper;

  bool operator<(const OpenEdge& other) const
  {
    return std::tie(triangle, lower, upper) < std::tie(other.triangle, other.lower, other.upper);
  }
};

std::vector<OpenEdge> openEdgesOf(const Surface& surface, Execution& execution);

// Where corners go: those that are not listed stay.
using CornerMoves = std::map<std::uint32_t, std::uint32_t>;

std::uint32_t goalOf(const CornerMoves& moves, std::uint32_t corner);

// Borrows the surface.
class OpenRims
{
public:
  OpenRims(const Surface& surface, std::vector<OpenEdge> edges);

  const std::vector<OpenEdge>& edges() const { return edges_; } // by triangle

  // Those of a triangle.
  std::pair<const OpenEdge*, const OpenEdge*> of(std::uint32_t triangle) const;

  // Each corner of a rim, in order.
  std::vector<std::uint32_t> corners() const;

  // Each triangle with an open edge, in order.
  std::vector<std::uint32_t> triangles() const;

  // Whether two are corners of one triangle with an open edge, as are those of a narrow strip.
  bool areOfOneTriangle(std::uint32_t a, std::uint32_t b) const;

  // The corners at most `length` levels along rims from one, which is among them; in order.
  std::vector<std::uint32_t> near(std::uint32_t corner, double length) const;

private:
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  const Surface& surface_;
  std::vector<OpenEdge> edges_;
  Pairs ends_;    // of edges, from either
  Pairs besides_; // corners of one triangle with an open edge
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Is the surface closed and consistently oriented? (section 2: what the preprocessor ensures)
#pragma once

#include "Surface/SurfaceEdges.h"

namespace cartesian
{

struct SurfaceCheck
{
  std::size_t openEdges = 0;         // used by an odd number of triangles
  std::size_t nonManifoldEdges = 0;  // used by more than two triangles
  std::size_t inconsistentEdges = 0; // used an even number of times, not half in each direction

  // The first few flawed edges, in order of their vertices: what is wrong, the edge's two ends
  // and a triangle that uses it.
  struct FlawedEdge
  {
    const char* what;
    std::array<std::uint32_t, 2> edge;
    std::uint32_t triangle;
  };
  static constexpr std::size_t MostPlaces = 5;
  std::vector<FlawedEdge> places;

  // Then every line through the domain enters it as often as it leaves it.
  bool closed() const { return openEdges == 0; }
  bool oriented() const { return closed() && inconsistentEdges == 0; }
};

SurfaceCheck check(const SurfaceEdges& edges, Execution& execution);

}

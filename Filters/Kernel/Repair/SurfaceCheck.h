// SPDX-License-Identifier: BSD-3-Clause
// Whether the surface is closed and consistently oriented, which section 2 leaves to a preprocessor.
#pragma once

#include "Surface/SurfaceEdges.h"

namespace cartesian
{

struct SurfaceCheck
{
  std::size_t openEdges = 0;         // used by an odd number of triangles
  std::size_t nonManifoldEdges = 0;  // used by more than two triangles
  std::size_t inconsistentEdges = 0; // used an even number of times, not half in each direction

  // The first few flawed edges, in order of their vertices.
  struct FlawedEdge
  {
    const char* what;                  // is wrong
    std::array<std::uint32_t, 2> edge; // its two ends
    std::uint32_t triangle;            // one that uses it
  };
  static constexpr std::size_t MostPlaces = 5;
  std::vector<FlawedEdge> places;

  // If so, every line enters the domain as often as it leaves it.
  bool closed() const { return openEdges == 0; }
  bool oriented() const { return closed() && inconsistentEdges == 0; }
};

SurfaceCheck check(const SurfaceEdges& edges, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// Edges of the user's triangles that are known to be sharp or smooth, as CAD systems know them: no angle is asked there.
#pragma once

#include "Base/Execution.h"

#include <array>
#include <cstdint>
#include <vector>

namespace cartesian
{

struct Surface;
struct SurfaceView;

enum class Known : std::uint8_t
{
  Nothing, // the angle decides
  Smooth,
  Sharp
};

// Is asked by the numbers of triangles in the view (Surface::given), so it holds however the surface is repaired.
class FeatureEdgeTags
{
public:
  using Line = std::array<std::uint32_t, 2>; // vertices

  // `surface`: the triangles of the view in the order of onLattice(). Of triangles at the same place, either all know
  // their edges or none. `sharp`: in any order; those that are no edges of triangles do not count.
  FeatureEdgeTags(
    const SurfaceView& view, const Surface& surface, std::vector<Line> sharp, Execution& execution);

  // Of the edge that two triangles of the view share. If only one of them knows its edges, a smooth one is unknown;
  // so is an edge that repair has made, between triangles that share none.
  Known between(std::uint32_t a, std::uint32_t b) const;

private:
  std::vector<std::array<std::uint32_t, 3>> vertices_; // of each triangle
  std::vector<std::uint8_t>
    bits_; // bit i: its edge from corner i to the next is sharp; bit 3: it knows its edges
};

}

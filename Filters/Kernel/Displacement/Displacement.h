// SPDX-License-Identifier: BSD-3-Clause
// The surface moved inwards, so that boundary layers fit between it and the surface as it was.
#pragma once

#include "Displacement/WallLayerSpec.h"
#include "Repair/TriangleTree.h"

#include <memory>

namespace cartesian
{

struct Displacement
{
  WallLayerSpec spec;
  double thickness = 0;           // of all layers, in levels
  std::vector<Point> original;    // of each vertex, where it was
  std::vector<Vector> directions; // of each vertex by the full thickness, in levels
  std::vector<double> parts;      // of its direction that each vertex moved, from 0 to 1

  bool hasLayers(std::int32_t boundary) const;
};

// Moves the vertices of a surface that is closed and oriented. `thickness` is in levels.
// - A vertex moves to where the displaced planes of its facets meet, at most twice the thickness; if it
//   belongs to boundaries without layers too, within the planes of these. A vertex of such boundaries
//   alone stays.
// - At most a third of the way to what lies opposite; along an edge the parts change no faster than the
//   edge is long.
// - Where the surface then folds or crosses itself it moves half as far, round by round; in the last not
//   at all.
// The result does not depend on the order of triangles or threads.
Displacement displace(
  Surface& surface, const WallLayerSpec& spec, double thickness, Execution& execution);

// As `before`, which was on that surface, but not at these triangles and so many rings of others around them.
Displacement displaceAgain(Surface& surface, const Displacement& before,
  std::vector<std::uint32_t> notAt, int rings, Execution& execution);

}

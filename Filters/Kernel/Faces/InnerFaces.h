// SPDX-License-Identifier: BSD-3-Clause
// Generation of Inner Faces (section 4.9): the faces on the common sides of boxes.
//
// The region of a side that is inside is bounded by the edges of patches that lie on the side, and by
// the inside pieces of its border. Its loops become faces: holes are joined to the loop around them, and
// faces without a star triangulation are split. Each side is computed once for both its boxes.
//
// Method: chords and pieces of the border are walked; of those that leave a node, the next to the left is taken, by exact predicates
// (Lattice/Plane.h). Source: section 4.9, step 9; holes and star polygons are ours.
// Limits: a side where chords do not close has no faces and is called flawed, and its boxes are rebuilt (BoxRebuilding.h).
#pragma once

#include "Boxes/Sides.h"
#include "Faces/Nodes.h"
#include "Patches/Patches.h"

namespace cartesian
{

struct InnerFaces
{
  RawVector<std::size_t> start;       // first node of each face, and the end
  RawVector<std::uint32_t> nodes;     // counter-clockwise seen from above the side
  std::vector<std::size_t> sideStart; // first face of each side, and the end
  std::vector<std::uint8_t> flawed;   // 1: the surface does not close at this side; no faces
  std::vector<std::int32_t> region;   // of each face of a side; empty: one region

  std::size_t size() const { return start.size() - 1; }
  std::int32_t regionOf(std::size_t face) const
  {
    return region.empty() ? FirstRegion : region[face];
  }
};

InnerFaces generateInnerFaces(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, Execution& execution);

}

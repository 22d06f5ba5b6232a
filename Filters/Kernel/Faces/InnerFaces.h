// SPDX-License-Identifier: BSD-3-Clause
// Generation of Inner Faces (section 4.9): the faces on the common sides of boxes.
//
// The inside region of a side is bounded by the edges of patches that lie on it and by those
// pieces of its border that are inside. Its loops become faces: holes are joined to the loop
// around them, and what has no star triangulation is split. Each side is computed once and handed
// to both its boxes, so they can't disagree.
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
  std::vector<std::uint8_t> flawed;   // 1: the surface has a hole at this side, it has no faces

  std::size_t size() const { return start.size() - 1; }
};

InnerFaces generateInnerFaces(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// The triangles near a box of a divided global box, found layer by layer and row by row in its node.
//
// In a block, boxes come in order of z, then y, so that each list serves many boxes. Without the lists,
// each of the hundreds of boxes in a node would look at all triangles of that.
#pragma once

#include "Boxes/NodeTriangles.h"

namespace cartesian
{

class NearTriangles
{
public:
  NearTriangles(const Surface& surface, const Boxes& boxes, const NodeTriangles& ofNodes);

  // Those of its node's triangles whose bounds reach the box along y and z, in the same order. Valid until the
  // next call.
  TriangleRange of(const Box& box);

private:
  // The triangles that reach boxes of this offset, and of this list's level, along an axis.
  struct List
  {
    std::uint32_t node = None;
    Offset offset{};
    std::vector<std::uint32_t> triangles;

    TriangleRange range() const
    {
      return { triangles.data(), triangles.data() + triangles.size() };
    }
  };
  using ByLevel = std::array<List, DeepestLevel + 1>;

  void fill(List& list, const Box& box, std::uint32_t node, std::size_t axis,
    const TriangleRange& from) const;

  const Surface& surface_;
  const Boxes& boxes_;
  const NodeTriangles& ofNodes_;
  ByLevel layers_;                             // by level along z
  std::array<ByLevel, DeepestLevel + 1> rows_; // by level along z, then y
};

}

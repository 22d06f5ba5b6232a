// SPDX-License-Identifier: BSD-3-Clause
// The triangles near a box of a divided global box, found layer by layer and row by row.
//
// Boxes come in order of z, then y, so that each list serves many boxes. Without the lists, each of
// the thousands of boxes of a finely divided global box would look at all triangles of that.
#pragma once

#include "Boxes/UnitStatuses.h"

namespace cartesian
{

class NearTriangles
{
public:
  NearTriangles(const Surface& surface, const Boxes& boxes);

  // Those of its global box's triangles whose bounds reach the box along y and z, in the same order.
  // Valid until the next call.
  TriangleRange of(const Box& box, const TriangleRange& ofGlobal);

private:
  // The triangles that reach boxes of this offset, and of this list's level, along an axis.
  struct List
  {
    std::uint32_t global = None;
    std::array<std::uint16_t, 3> offset{};
    std::vector<std::uint32_t> triangles;

    TriangleRange range() const
    {
      return { triangles.data(), triangles.data() + triangles.size() };
    }
  };
  using ByLevel = std::array<List, DeepestLevel + 1>;

  // Of those of `all` that reach the box of this level along the axis that holds the given one.
  TriangleRange listOf(
    ByLevel& lists, const Box& box, std::size_t axis, int level, const TriangleRange& all);
  void fill(List& list, std::size_t axis, int level, const TriangleRange& from) const;

  const Surface& surface_;
  const Boxes& boxes_;
  ByLevel layers_;                             // by level along z
  std::array<ByLevel, DeepestLevel + 1> rows_; // by level along z, then y
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Cuts a triangle into pieces by rows of the global mesh: the basis of Shoeboxes (4.3) and In/Out
// Status (4.4).
//
// A row is the space between two neighbouring planes of the `outer` axis and two of the `middle`
// axis; it runs along the third. Rows below the first plane have the index -1, beyond the last of N
// planes, N - 1.
#pragma once

#include "Lattice/ExactFit.h"
#include "Lattice/Meshlines.h"

#include <algorithm>

namespace cartesian
{

struct RowAxes
{
  int outer;
  int middle;
  int along;
};

// By the axis that rows run along.
constexpr std::array<RowAxes, 3> RowsAlong = { RowAxes{ 2, 1, 0 }, RowAxes{ 2, 0, 1 },
  RowAxes{ 1, 0, 2 } };

inline std::pair<Level, Level> rangeOf(const Fragment& f, int axis)
{
  Level least = f.corner[0][axis];
  Level most = least;
  for (int i = 1; i < f.size; ++i)
  {
    least = std::min(least, f.corner[i][axis]);
    most = std::max(most, f.corner[i][axis]);
  }
  return { least, most };
}

// Calls visit(interval, piece) for the pieces of `fragment` between the planes of `axis`. No plane
// of that axis has cut it yet: all its levels along the axis are odd.
template <class Visitor>
void forEachSlice(const Corners& triangle, const Fragment& fragment, int axis,
  const std::vector<Level>& planes, Visitor&& visit)
{
  const auto [least, most] = rangeOf(fragment, axis);
  const std::int64_t first = intervalOf(planes, least);
  const std::int64_t last = intervalOf(planes, most);
  Fragment rest = fragment;
  Fragment piece;
  Fragment above;
  for (std::int64_t i = first; i < last; ++i)
  {
    split(triangle, rest, axis, planes[i + 1], &piece, &above);
    visit(i, piece);
    rest = above;
  }
  visit(last, rest);
}

// Calls visit(middle, outer, piece) for the pieces of a triangle in each row along axes.along.
template <class Visitor>
void forEachRowPiece(
  const Corners& triangle, const RowAxes& axes, const Meshlines& planes, Visitor&& visit)
{
  forEachSlice(triangle, Fragment::whole(triangle), axes.outer, planes[axes.outer],
    [&](std::int64_t outer, const Fragment& slice) {
      forEachSlice(triangle, slice, axes.middle, planes[axes.middle],
        [&](std::int64_t middle, const Fragment& piece) { visit(middle, outer, piece); });
    });
}

}

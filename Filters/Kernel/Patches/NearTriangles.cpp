// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/NearTriangles.h"

namespace cartesian
{

NearTriangles::NearTriangles(const Surface& surface, const Boxes& boxes)
  : surface_(surface)
  , boxes_(boxes)
{
}

TriangleRange NearTriangles::of(const Box& box, const TriangleRange& ofGlobal)
{
  if (boxes_.globalOf(box).depth == 0)
  {
    return ofGlobal;
  }
  const TriangleRange layer = listOf(layers_, box, 2, box.level[2], ofGlobal);
  return listOf(rows_[box.level[2]], box, 1, box.level[1], layer);
}

TriangleRange NearTriangles::listOf(
  ByLevel& lists, const Box& box, std::size_t axis, int level, const TriangleRange& all)
{
  // Lists of deeper boxes are taken from those of larger ones: else each of thousands of layers would look at all
  // triangles.
  constexpr int LevelsAtOnce = 3;
  std::array<std::uint16_t, 3> offset{};
  offset[2] = box.offset[2];
  offset[axis] = static_cast<std::uint16_t>(box.offset[axis] & -(FinePerBox >> level));
  List& list = lists[static_cast<std::size_t>(level)];
  if (list.global != box.global || list.offset != offset)
  {
    const TriangleRange from =
      level > LevelsAtOnce ? listOf(lists, box, axis, level - LevelsAtOnce, all) : all;
    list.global = box.global;
    list.offset = offset;
    fill(list, axis, level, from);
  }
  return list.range();
}

void NearTriangles::fill(List& list, std::size_t axis, int level, const TriangleRange& from) const
{
  const std::uint32_t i = boxes_.globals[list.global].index[axis];
  const Level low = planeAt(boxes_.planes, axis, i, list.offset[axis]);
  const Level high = planeAt(boxes_.planes, axis, i, list.offset[axis] + (FinePerBox >> level));
  list.triangles.clear();
  for (const std::uint32_t* t = from.first; t != from.second; ++t)
  {
    const Corners c = surface_.corners(*t);
    if (std::max({ c[0][axis], c[1][axis], c[2][axis] }) >= low &&
      std::min({ c[0][axis], c[1][axis], c[2][axis] }) <= high)
    {
      list.triangles.push_back(*t);
    }
  }
}

}

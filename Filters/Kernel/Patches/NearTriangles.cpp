// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/NearTriangles.h"

namespace cartesian
{

NearTriangles::NearTriangles(
  const Surface& surface, const Boxes& boxes, const NodeTriangles& ofNodes)
  : surface_(surface)
  , boxes_(boxes)
  , ofNodes_(ofNodes)
{
}

TriangleRange NearTriangles::of(const Box& box)
{
  const auto [triangles, node] = ofNodes_.of(box);
  if (boxes_.globalOf(box).depth == 0)
  {
    return triangles;
  }
  List& layer = layers_[box.level[2]];
  if (layer.node != node || layer.offset[2] != box.offset[2])
  {
    fill(layer, box, node, 2, triangles);
  }
  List& row = rows_[box.level[2]][box.level[1]];
  if (row.node != node || row.offset[2] != box.offset[2] || row.offset[1] != box.offset[1])
  {
    fill(row, box, node, 1, layer.range());
  }
  return row.range();
}

void NearTriangles::fill(
  List& list, const Box& box, std::uint32_t node, std::size_t axis, const TriangleRange& from) const
{
  list.node = node;
  list.offset = box.offset;
  list.triangles.clear();
  for (const std::uint32_t* t = from.first; t != from.second; ++t)
  {
    const Corners c = surface_.corners(*t);
    if (std::max({ c[0][axis], c[1][axis], c[2][axis] }) >= box.low[axis] &&
      std::min({ c[0][axis], c[1][axis], c[2][axis] }) <= box.high[axis])
    {
      list.triangles.push_back(*t);
    }
  }
}

}

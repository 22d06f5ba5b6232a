// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/WallMesh.h"

#include <algorithm>

namespace cartesian
{

std::array<CellKey, 2> cellsIn(
  const Boxes& boxes, const Sides& sides, const WallMesh& wall, SlabRange layers)
{
  const auto firstOf = [&](std::uint32_t layer) {
    const auto& polyhedral = sides.polyhedral;
    const auto at = std::lower_bound(polyhedral.begin(), polyhedral.end(), boxes.firstBoxOf(layer));
    return static_cast<CellKey>(wall.boxStart[static_cast<std::size_t>(at - polyhedral.begin())]);
  };
  return { firstOf(layers.begin), firstOf(layers.end) };
}

void lookBeside(const Boxes& boxes, const Sides& sides, const WallMesh& wall, std::uint32_t box,
  unsigned side, BesideHexahedron& beside)
{
  const bool upper = side % 2 == 1;
  const int axis = static_cast<int>(side / 2);
  const std::uint32_t other = facing(boxes, boxes.packed[box], axis, upper)[0];
  const std::uint32_t n = sides.polyhedralOrdinal(other);
  beside.box = other;
  beside.isPolyhedral = n != None;
  beside.faces.clear();
  const std::vector<std::uint32_t>& start = wall.faces.sideStart;
  for (std::size_t i = n == None ? 0 : sides.boxStart[n]; n != None && i < sides.boxStart[n + 1];
       ++i)
  {
    const std::size_t s = sides.ofBox[i].side;
    const Side& shared = sides.common[s];
    if ((upper ? shared.low : shared.high) == box && shared.axis == axis && start[s] < start[s + 1])
    {
      for (std::uint32_t f = start[s]; f < start[s + 1]; ++f)
      {
        beside.faces.emplace_back(f, !upper);
      }
      return;
    }
  }
}

}

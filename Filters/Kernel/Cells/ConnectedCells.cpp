// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/ConnectedCells.h"

namespace cartesian
{

DisjointSets unitedHexahedra(const Boxes& boxes, const Sides& sides, const WallMesh& wall)
{
  const auto isHexahedron = [&](std::uint32_t box) {
    return box != None && sides.polyhedralOrdinal(box) == None;
  };
  DisjointSets parts(boxes.packed.size() + wall.size());
  for (std::uint32_t b = 0; b < boxes.packed.size(); ++b)
  {
    for (int axis = 0; isHexahedron(b) && axis < 3; ++axis)
    {
      for (const std::uint32_t other : facing(boxes, boxes.packed[b], axis, true))
      {
        if (isHexahedron(other))
        {
          parts.unite(b, other);
        }
      }
    }
  }
  return parts;
}

std::vector<std::size_t> countParts(
  const Boxes& boxes, const Walls& walls, const Sides& sides, const WallMesh& wall)
{
  const auto cellsBegin = static_cast<std::uint32_t>(boxes.packed.size());
  DisjointSets parts = unitedHexahedra(boxes, sides, wall);
  const auto element = [&](CellKey key) {
    return isHexahedron(key) ? boxOfHexahedron(key) : cellsBegin + key;
  };
  for (std::size_t f = 0; f < wall.faces.size(); ++f)
  {
    const auto& [below, above] = wall.faces.cells[f];
    if (below != None && above != None && !wall.isRemoved(below) && !wall.isRemoved(above) &&
      !wall.isInterface(f) && !walls.isBaffle(wall.faces.boundary[f]))
    {
      parts.unite(element(below), element(above));
    }
  }
  std::vector<std::size_t> counts;
  const auto count = [&](std::uint32_t e, std::int32_t region) {
    const auto r = static_cast<std::size_t>(walls.givenOf(region) - FirstRegion);
    counts.resize(std::max(counts.size(), r + 1));
    counts[r] += parts.find(e) == e ? 1 : 0;
  };
  for (std::uint32_t b = 0; b < cellsBegin; ++b)
  {
    if (sides.polyhedralOrdinal(b) == None)
    {
      count(b, boxes.regionOf(b));
    }
  }
  for (std::uint32_t c = 0; c < wall.size(); ++c)
  {
    if (!wall.cells[c].removed)
    {
      count(cellsBegin + c, wall.cells[c].region);
    }
  }
  return counts;
}

}

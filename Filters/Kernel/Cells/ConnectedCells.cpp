// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/ConnectedCells.h"

#include <algorithm>
#include <functional>

namespace cartesian
{

namespace
{

constexpr std::size_t ItemsAChunk = 1 << 12;

using PartCounts = std::vector<std::size_t>; // of each region

// Calls each(item, counts) for all items.
template <class Each>
void addCounts(std::size_t items, PartCounts& sum, Each&& each, Execution& execution)
{
  std::vector<PartCounts> found(chunks(items, ItemsAChunk));
  execution.forEach(items, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i)
    {
      each(i, found[begin / ItemsAChunk]);
    }
  });
  for (const PartCounts& part : found)
  {
    sum.resize(std::max(sum.size(), part.size()));
    std::transform(part.begin(), part.end(), sum.begin(), sum.begin(), std::plus<>());
  }
}

}

ConcurrentSets unitedHexahedra(
  const Boxes& boxes, const Sides& sides, const WallMesh& wall, Execution& execution)
{
  const auto isHexahedron = [&](std::uint32_t box) {
    return box != None && sides.polyhedralOrdinal(box) == None;
  };
  const std::size_t count = boxes.packed.size();
  ConcurrentSets parts(count + wall.size(), execution);
  execution.forEach(count, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (auto b = static_cast<std::uint32_t>(begin); b < end; ++b)
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
  });
  return parts;
}

std::vector<std::size_t> countParts(const Boxes& boxes, const Walls& walls, const Sides& sides,
  const WallMesh& wall, Execution& execution)
{
  const auto cellsBegin = static_cast<std::uint32_t>(boxes.packed.size());
  ConcurrentSets parts = unitedHexahedra(boxes, sides, wall, execution);
  const auto element = [&](CellKey key) {
    return isHexahedron(key) ? boxOfHexahedron(key) : cellsBegin + key;
  };
  execution.forEach(wall.faces.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
    {
      const auto& [below, above] = wall.faces.cells[f];
      if (below != None && above != None && !wall.isRemoved(below) && !wall.isRemoved(above) &&
        !wall.isInterface(f) && !walls.isBaffle(wall.faces.boundary[f]))
      {
        parts.unite(element(below), element(above));
      }
    }
  });
  const auto add = [&](std::uint32_t e, std::int32_t region, PartCounts& counts) {
    const auto r = static_cast<std::size_t>(walls.givenOf(region) - FirstRegion);
    counts.resize(std::max(counts.size(), r + 1));
    counts[r] += parts.find(e) == e ? 1 : 0;
  };
  PartCounts counts;
  addCounts(
    cellsBegin, counts,
    [&](std::uint32_t b, PartCounts& ofChunk) {
      if (sides.polyhedralOrdinal(b) == None)
      {
        add(b, boxes.regionOf(b), ofChunk);
      }
    },
    execution);
  addCounts(
    wall.size(), counts,
    [&](std::uint32_t c, PartCounts& ofChunk) {
      if (!wall.cells[c].removed)
      {
        add(cellsBegin + c, wall.cells[c].region, ofChunk);
      }
    },
    execution);
  return counts;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Faces/Nodes.h"

#include "Lattice/Numbering.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t BoxesAChunk = 128;

// Grid nodes of a chunk of boxes, numbered in the chunk: one use for each point.
class ChunkNodes
{
public:
  ChunkNodes(const Boxes& boxes, std::vector<PointUse>& uses)
    : boxes_(boxes)
    , uses_(uses)
  {
    points_.clear();
  }

  std::uint32_t add(const FinePoint& fine)
  {
    Point p;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      p[axis] = planeAt(boxes_.planes, axis, fine[axis]);
    }
    const std::uint32_t local = points_.add(p);
    if (local == uses_.size())
    {
      const std::int64_t row = (fine[1] >> DeepestLevel) +
        (fine[2] >> DeepestLevel) * static_cast<std::int64_t>(boxes_.planes[1].size());
      uses_.push_back({ p, static_cast<std::uint32_t>(row), local });
    }
    return local;
  }

  // Appends the border of a side, counter-clockwise, with its hanging nodes. `global`: the global box of
  // one of its boxes.
  void addBorder(const Side& side, std::uint32_t global, std::vector<std::uint32_t>& border)
  {
    const std::size_t u = (side.axis + 1u) % 3;
    const std::size_t v = (side.axis + 2u) % 3;
    FinePoint corner{ side.corner[0], side.corner[1], side.corner[2] };
    addLine(corner, u, side.size(0), true, global, border);
    corner[u] += side.size(0);
    addLine(corner, v, side.size(1), true, global, border);
    corner[v] += side.size(1);
    addLine(corner, u, side.size(0), false, global, border);
    corner[u] -= side.size(0);
    addLine(corner, v, side.size(1), false, global, border);
  }

private:
  // Appends the nodes from a corner up or down one axis, without the end.
  void addLine(const FinePoint& from, std::size_t axis, std::int64_t length, bool up,
    std::uint32_t global, std::vector<std::uint32_t>& border)
  {
    border.push_back(add(from));
    if (boxes_.globals[global].nearDepth == 0)
    {
      return;
    }
    FinePoint low = from;
    low[axis] -= up ? 0 : length;
    hangingNodes(boxes_, static_cast<int>(axis), low, length, global, positions_);
    if (!up)
    {
      std::reverse(positions_.begin(), positions_.end());
    }
    for (const std::int64_t position : positions_)
    {
      low[axis] = position;
      border.push_back(add(low));
    }
  }

  const Boxes& boxes_;
  std::vector<PointUse>& uses_;
  LocalPoints points_;
  std::vector<std::int64_t> positions_;
};

// The nodes of a chunk of sides, or of a chunk of divided hexahedra, numbered in the chunk.
struct UseChunk
{
  std::vector<PointUse> uses;
  std::vector<std::uint32_t> nodes;
};

UseChunk sidesOf(const Boxes& boxes, const Sides& sides, std::size_t begin, std::size_t end,
  std::vector<std::size_t>& borderSizes)
{
  UseChunk chunk;
  ChunkNodes list(boxes, chunk.uses);
  for (std::size_t n = begin; n < end; ++n)
  {
    const std::uint32_t global = boxes.packed[sides.polyhedral[n]].global;
    for (std::size_t s = sides.ownStart[n]; s < sides.ownStart[n + 1]; ++s)
    {
      const std::size_t before = chunk.nodes.size();
      list.addBorder(sides.common[s], global, chunk.nodes);
      borderSizes[s] = chunk.nodes.size() - before;
    }
  }
  return chunk;
}

UseChunk hexahedraOf(const Boxes& boxes, const Sides& sides, std::size_t begin, std::size_t end)
{
  UseChunk chunk;
  ChunkNodes list(boxes, chunk.uses);
  for (std::size_t n = begin; n < end; ++n)
  {
    const PackedBox& box = boxes.packed[sides.divided[n]];
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      FinePoint fine = boxes.fineLow(box);
      for (int axis = 0; axis < 3; ++axis)
      {
        fine[static_cast<std::size_t>(axis)] += (corner >> axis & 1) * Boxes::fineSize(box, axis);
      }
      chunk.nodes.push_back(list.add(fine));
    }
  }
  return chunk;
}

}

Nodes findNodes(
  const Boxes& boxes, const Patches& patches, const Sides& sides, Execution& execution)
{
  const std::size_t count = sides.polyhedral.size();
  const std::size_t sideParts = chunks(count, BoxesAChunk);
  std::vector<UseChunk> ofChunk(sideParts + chunks(sides.divided.size(), BoxesAChunk));
  Nodes nodes;
  nodes.borderStart.assign(sides.common.size() + 1, 0);
  execution.nextLoop(0.9);
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    ofChunk[begin / BoxesAChunk] = sidesOf(boxes, sides, begin, end, nodes.borderStart);
  });
  execution.forEach(sides.divided.size(), BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    ofChunk[sideParts + begin / BoxesAChunk] = hexahedraOf(boxes, sides, begin, end);
  });

  std::vector<std::vector<PointUse>> uses(ofChunk.size());
  std::vector<std::size_t> firstSlot(ofChunk.size());
  std::vector<std::size_t> firstNode(ofChunk.size());
  for (std::size_t i = 0; i < ofChunk.size(); ++i)
  {
    firstSlot[i] = ofChunk[i].uses.size();
    firstNode[i] = ofChunk[i].nodes.size();
    uses[i].swap(ofChunk[i].uses);
  }
  scan(firstSlot);
  scan(firstNode);
  offsetSlots(uses);
  Numbering numbering = numberPoints(uses, pointRows(boxes.planes), execution);

  nodes.border.resize(scan(nodes.borderStart));
  nodes.ofDivided.resize(sides.divided.size());
  execution.forEach(ofChunk.size(), 1, [&](std::size_t i, std::size_t) {
    for (std::size_t n = 0; n < ofChunk[i].nodes.size(); ++n)
    {
      const auto node = static_cast<std::uint32_t>(
        patches.points.size() + numbering.ofSlot[firstSlot[i] + ofChunk[i].nodes[n]]);
      const std::size_t at = firstNode[i] + n;
      if (i < sideParts)
      {
        nodes.border[at] = node;
      }
      else
      {
        const std::size_t corner = at - nodes.border.size();
        nodes.ofDivided[corner / 8][corner % 8] = node;
      }
    }
  });
  nodes.patchPoints = patches.points.size();
  nodes.at.reserve(patches.points.size() + numbering.points.size());
  nodes.at = patches.points;
  nodes.at.insert(nodes.at.end(), numbering.points.begin(), numbering.points.end());
  nodes.kinds.reserve(nodes.at.size());
  nodes.kinds = patches.kinds;
  nodes.kinds.resize(nodes.at.size(), PointKind::OffSurface);
  nodes.grid.swap(numbering.points);
  nodes.rowStart.swap(numbering.rowStart);
  return nodes;
}

std::uint32_t nodeOfCorner(
  const Boxes& boxes, const Sides& sides, const Nodes& nodes, std::uint32_t box, unsigned corner)
{
  if (const std::uint32_t ordinal = sides.ordinal[box]; ordinal != None)
  {
    return nodes.ofDivided[ordinal & ~Sides::HexahedronBit][corner];
  }
  const VertexNode at = vertexAt(boxes, box, corner);
  const std::size_t row = at.j + at.k * boxes.planes[1].size();
  const Point p = cornerOf(boxes.box(box), corner);
  const auto begin = nodes.grid.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(nodes.rowStart[row + 1]);
  const auto found =
    std::lower_bound(begin + static_cast<std::ptrdiff_t>(nodes.rowStart[row]), end, p);
  return found != end && areSame(*found, p)
    ? static_cast<std::uint32_t>(nodes.patchPoints) + static_cast<std::uint32_t>(found - begin)
    : std::uint32_t(None);
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Sides.h"

#include "Base/Sorting.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t BoxesAChunk = 512;
constexpr std::size_t SidesAChunk = 1 << 12;

bool hasHangingNodes(const Boxes& boxes, const PackedBox& box, std::vector<std::int64_t>& scratch)
{
  if (boxes.globalOf(box).nearDepth == 0)
  {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool upper : { false, true })
    {
      const std::array<std::uint32_t, 4> across = facing(boxes, box, axis, upper);
      if (std::any_of(
            across.begin(), across.end(), [&](std::uint32_t other) { return other != across[0]; }))
      {
        return true;
      }
    }
    for (unsigned edge = 0; edge < 4; ++edge)
    {
      const int a = (axis + 1) % 3;
      const int b = (axis + 2) % 3;
      FinePoint from = boxes.fineLow(box);
      from[a] += (edge & 1) * Boxes::fineSize(box, a);
      from[b] += (edge >> 1) * Boxes::fineSize(box, b);
      hangingNodes(boxes, axis, from, Boxes::fineSize(box, axis), box.global, scratch);
      if (!scratch.empty())
      {
        return true;
      }
    }
  }
  return false;
}

// Calls visit(neighbour, side) for the rectangles into which the neighbours divide a side of a box.
template <class Visitor>
void forEachPart(const Boxes& boxes, std::uint32_t b, int axis, bool upper, Visitor&& visit)
{
  const PackedBox& box = boxes.packed[b];
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const std::array<std::uint32_t, 4> across = facing(boxes, box, axis, upper);
  FinePoint corner = boxes.fineLow(box);
  corner[axis] += upper ? Boxes::fineSize(box, axis) : 0;
  const std::int64_t halfU = Boxes::fineSize(box, u) / 2;
  const std::int64_t halfV = Boxes::fineSize(box, v) / 2;
  std::array<bool, 4> done{};
  for (unsigned quarter = 0; quarter < 4; ++quarter)
  {
    if (done[quarter])
    {
      continue;
    }
    const bool left = (quarter & 1) == 0;
    const bool lower = (quarter & 2) == 0;
    const bool wide = left && across[quarter + 1] == across[quarter];
    const bool tall = lower && across[quarter + 2] == across[quarter] &&
      (!wide || across[quarter + 3] == across[quarter]);
    for (unsigned other = quarter; other < 4; ++other)
    {
      const bool right = (other & 1) != (quarter & 1);
      const bool above = (other & 2) != (quarter & 2);
      done[other] = done[other] || ((!right || wide) && (!above || tall));
    }
    Side side;
    side.low = upper ? b : across[quarter];
    side.high = upper ? across[quarter] : b;
    side.axis = static_cast<std::uint8_t>(axis);
    FinePoint low = corner;
    low[u] += left ? 0 : halfU;
    low[v] += lower ? 0 : halfV;
    side.corner = { static_cast<std::uint32_t>(low[0]), static_cast<std::uint32_t>(low[1]),
      static_cast<std::uint32_t>(low[2]) };
    side.size[0] = static_cast<std::uint8_t>(wide ? Boxes::fineSize(box, u) : halfU);
    side.size[1] = static_cast<std::uint8_t>(tall ? Boxes::fineSize(box, v) : halfV);
    visit(across[quarter], side);
  }
}

// Visits the sides that a polyhedral box owns: all upper ones, and the lower ones across which
// there is no polyhedral box.
template <class Visitor>
void forEachOwnSide(const Boxes& boxes, const Sides& sides, std::uint32_t b, Visitor&& visit)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    forEachPart(boxes, b, axis, false, [&](std::uint32_t other, const Side& side) {
      if (sides.polyhedralOrdinal(other) == None)
      {
        visit(side);
      }
    });
    forEachPart(boxes, b, axis, true, [&](std::uint32_t, const Side& side) { visit(side); });
  }
}

enum class BoxKind : std::uint8_t
{
  Hexahedron,
  DividedHexahedron,
  Polyhedral,
  Intersected, // polyhedral too
};

BoxKind kindOf(const Boxes& boxes, const PackedBox& box, std::vector<std::int64_t>& scratch)
{
  if (box.status == BoxStatus::Intersected)
  {
    return BoxKind::Intersected;
  }
  if (boxes.units.empty()) // no box is divided
  {
    return BoxKind::Hexahedron;
  }
  if (hasHangingNodes(boxes, box, scratch))
  {
    return BoxKind::Polyhedral;
  }
  const bool divided = (box.level[0] | box.level[1] | box.level[2]) != 0;
  return divided ? BoxKind::DividedHexahedron : BoxKind::Hexahedron;
}

// How many boxes of each kind there are before a chunk of boxes.
struct KindCounts
{
  std::uint32_t polyhedral = 0;
  std::uint32_t intersected = 0;
  std::uint32_t divided = 0; // hexahedra

  void count(BoxKind kind)
  {
    polyhedral += kind >= BoxKind::Polyhedral ? 1 : 0;
    intersected += kind == BoxKind::Intersected ? 1 : 0;
    divided += kind == BoxKind::DividedHexahedron ? 1 : 0;
  }
};

void classify(const Boxes& boxes, Sides& result, Execution& execution)
{
  const std::size_t count = boxes.packed.size();
  RawVector<BoxKind> kinds(count);
  std::vector<KindCounts> before(chunks(count, BoxesAChunk) + 1);
  execution.nextLoop(0.1);
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    std::vector<std::int64_t> scratch;
    for (std::size_t b = begin; b < end; ++b)
    {
      kinds[b] = kindOf(boxes, boxes.packed[b], scratch);
      before[begin / BoxesAChunk + 1].count(kinds[b]);
    }
  });
  for (std::size_t i = 0; i + 1 < before.size(); ++i)
  {
    before[i + 1].polyhedral += before[i].polyhedral;
    before[i + 1].intersected += before[i].intersected;
    before[i + 1].divided += before[i].divided;
  }
  result.ordinal.resize(count);
  result.polyhedral.resize(before.back().polyhedral);
  result.patchBox.resize(before.back().polyhedral);
  result.divided.resize(before.back().divided);
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    KindCounts next = before[begin / BoxesAChunk];
    for (std::size_t b = begin; b < end; ++b)
    {
      const BoxKind kind = kinds[b];
      result.ordinal[b] = None;
      if (kind >= BoxKind::Polyhedral)
      {
        result.ordinal[b] = next.polyhedral;
        result.polyhedral[next.polyhedral] = static_cast<std::uint32_t>(b);
        result.patchBox[next.polyhedral] = kind == BoxKind::Intersected ? next.intersected : None;
      }
      else if (kind == BoxKind::DividedHexahedron)
      {
        result.ordinal[b] = next.divided | Sides::HexahedronBit;
        result.divided[next.divided] = static_cast<std::uint32_t>(b);
      }
      next.count(kind);
    }
  });
}

void listSidesOfBoxes(Sides& result, Execution& execution)
{
  Buckets<SideOfBox> ofBox = fillBuckets<SideOfBox>(
    result.common.size(), SidesAChunk, result.polyhedral.size(),
    [&](std::size_t begin, std::size_t end, auto&& add) {
      for (auto s = static_cast<std::uint32_t>(begin); s < end; ++s)
      {
        for (const bool upper : { true, false })
        {
          const Side& side = result.common[s];
          const std::uint32_t n = result.polyhedralOrdinal(upper ? side.low : side.high);
          if (n != None)
          {
            add(n, SideOfBox(s, upper));
          }
        }
      }
    },
    execution);
  result.boxStart = std::move(ofBox.start);
  result.ofBox = std::move(ofBox.items);
}

}

std::array<unsigned, 4> sideCorners(int axis, unsigned upper)
{
  const unsigned a = 1u << ((axis + 1) % 3);
  const unsigned b = 1u << ((axis + 2) % 3);
  const unsigned base = upper << axis;
  return { base, base | a, base | a | b, base | b };
}

void hangingNodes(const Boxes& boxes, int axis, const FinePoint& from, std::int64_t length,
  std::uint32_t near, std::vector<std::int64_t>& positions)
{
  positions.clear();
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  const std::int64_t end = from[axis] + length;
  const auto add = [&](std::int64_t position) {
    if (position > from[axis] && position < end)
    {
      positions.push_back(position);
    }
  };
  for (std::int64_t quadrant = 0; quadrant < 4; ++quadrant)
  {
    FinePoint at = from;
    at[a] -= quadrant & 1;
    at[b] -= quadrant >> 1;
    while (at[axis] < end)
    {
      std::int64_t step = 0;
      const std::uint32_t box = boxes.boxAt(at, near, step);
      if (step >= length)
      {
        break; // no box here is shorter than the line
      }
      if (box == None)
      {
        at[axis] = (at[axis] / step + 1) * step;
        continue;
      }
      const std::int64_t low = boxes.fineLow(boxes.packed[box])[axis];
      at[axis] = low + Boxes::fineSize(boxes.packed[box], axis);
      add(low);
      add(at[axis]);
    }
  }
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
}

Sides findSides(const Boxes& boxes, Execution& execution)
{
  Sides result;
  classify(boxes, result, execution);
  const std::size_t count = result.polyhedral.size();
  std::vector<std::vector<Side>> parts(chunks(count, BoxesAChunk));
  result.ownStart.assign(count + 1, 0);
  execution.nextLoop(0.1);
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    std::vector<Side>& part = parts[begin / BoxesAChunk];
    for (std::size_t n = begin; n < end; ++n)
    {
      const std::size_t before = part.size();
      forEachOwnSide(
        boxes, result, result.polyhedral[n], [&](const Side& side) { part.push_back(side); });
      result.ownStart[n] = part.size() - before;
    }
  });
  result.common.resize(scan(result.ownStart));
  execution.forEach(parts.size(), 1, [&](std::size_t i, std::size_t) {
    const std::size_t first = result.ownStart[i * BoxesAChunk];
    std::copy(parts[i].begin(), parts[i].end(), result.common.begin() + std::ptrdiff_t(first));
  });
  listSidesOfBoxes(result, execution);
  return result;
}

}

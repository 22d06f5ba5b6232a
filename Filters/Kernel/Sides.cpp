#include "Sides.h"

#include "Patches.h"

namespace cartesian
{

namespace
{

constexpr std::size_t BoxesAChunk = 1024;

std::uint32_t neighbour(const Boxes& boxes, const Box& box, int axis, int direction)
{
  std::array<std::int64_t, 3> at = { box.global[0], box.global[1], box.global[2] };
  at[axis] += direction;
  return boxAt(boxes, at[0], at[1], at[2]);
}

// The sides that an intersected box owns: all its upper ones, and those lower ones that face no
// other intersected box.
std::size_t ownSides(const Boxes& boxes, std::uint32_t b, Side* sides)
{
  const Box& box = boxes.boxes[b];
  std::size_t count = 0;
  for (std::uint8_t axis = 0; axis < 3; ++axis)
  {
    const std::uint32_t below = neighbour(boxes, box, axis, -1);
    if (below == None || boxes.boxes[below].status != BoxStatus::Intersected)
    {
      sides[count++] = { below, b, axis };
    }
    sides[count++] = { b, neighbour(boxes, box, axis, +1), axis };
  }
  return count;
}

}

std::array<unsigned, 4> sideCorners(int axis, unsigned upper)
{
  const unsigned a = 1u << ((axis + 1) % 3);
  const unsigned b = 1u << ((axis + 2) % 3);
  const unsigned base = upper << axis;
  return { base, base | a, base | a | b, base | b };
}

std::uint32_t boxAt(const Boxes& boxes, std::int64_t i, std::int64_t j, std::int64_t k)
{
  const auto nj = static_cast<std::int64_t>(boxes.planes[1].size()) - 1;
  const auto nk = static_cast<std::int64_t>(boxes.planes[2].size()) - 1;
  if (i < 0 || j < 0 || k < 0 || j >= nj || k >= nk)
  {
    return None;
  }
  const std::size_t row = boxes.row(static_cast<std::size_t>(j), static_cast<std::size_t>(k));
  const auto begin = boxes.boxes.begin() + static_cast<std::ptrdiff_t>(boxes.rowStart[row]);
  const auto end = boxes.boxes.begin() + static_cast<std::ptrdiff_t>(boxes.rowStart[row + 1]);
  const auto found = std::lower_bound(
    begin, end, i, [](const Box& box, std::int64_t x) { return box.global[0] < x; });
  return found != end && found->global[0] == i
    ? static_cast<std::uint32_t>(found - boxes.boxes.begin())
    : None;
}

Sides findSides(const Boxes& boxes, Execution& execution)
{
  Sides result;
  result.intersected = intersectedBoxes(boxes);
  const std::size_t count = result.intersected.size();
  result.ordinal.assign(boxes.boxes.size(), None);
  for (std::uint32_t n = 0; n < count; ++n)
  {
    result.ordinal[result.intersected[n]] = n;
  }

  std::vector<std::array<Side, 6>> own(count);
  result.ownStart.assign(count + 1, 0);
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      result.ownStart[n] = ownSides(boxes, result.intersected[n], own[n].data());
    }
  });
  result.sides.resize(scan(result.ownStart));
  result.ofBox.resize(count);
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      for (std::size_t s = result.ownStart[n]; s < result.ownStart[n + 1]; ++s)
      {
        const Side side = own[n][s - result.ownStart[n]];
        const auto id = static_cast<std::uint32_t>(s);
        result.sides[s] = side;
        // Each box and direction has one side: no two threads write the same place.
        if (side.low != None && result.ordinal[side.low] != None)
        {
          result.ofBox[result.ordinal[side.low]][2 * side.axis + 1] = id;
        }
        if (side.high != None && result.ordinal[side.high] != None)
        {
          result.ofBox[result.ordinal[side.high]][2 * side.axis] = id;
        }
      }
    }
  });
  return result;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Boxes.h"

#include <algorithm>

namespace cartesian
{

namespace
{

std::uint32_t unitIndex(const GlobalBox& global, const std::array<std::int64_t, 3>& offset)
{
  const int shift = DeepestLevel - global.depth;
  const std::int64_t x = offset[0] >> shift;
  const std::int64_t y = offset[1] >> shift;
  const std::int64_t z = offset[2] >> shift;
  return static_cast<std::uint32_t>(x | y << global.depth | z << 2 * global.depth);
}

}

std::uint32_t Boxes::globalAt(std::int64_t i, std::int64_t j, std::int64_t k) const
{
  const auto nj = static_cast<std::int64_t>(planes[1].size()) - 1;
  const auto nk = static_cast<std::int64_t>(planes[2].size()) - 1;
  if (i < 0 || j < 0 || k < 0 || j >= nj || k >= nk)
  {
    return None;
  }
  const std::size_t r = row(static_cast<std::size_t>(j), static_cast<std::size_t>(k));
  const auto begin = globals.begin() + static_cast<std::ptrdiff_t>(rowStart[r]);
  auto end = globals.begin() + static_cast<std::ptrdiff_t>(rowStart[r + 1]);
  if (begin == end || i < begin->index[0])
  {
    return None;
  }
  // If no box of the row is missing before it, it is at this guess, else before it.
  if (const std::int64_t guess = i - begin->index[0]; guess < end - begin)
  {
    end = begin + guess;
    if (end->index[0] == i)
    {
      return static_cast<std::uint32_t>(end - globals.begin());
    }
  }
  const auto found = std::lower_bound(
    begin, end, i, [](const GlobalBox& g, std::int64_t x) { return g.index[0] < x; });
  return found != end && found->index[0] == i ? static_cast<std::uint32_t>(found - globals.begin())
                                              : None;
}

std::uint32_t Boxes::boxAt(const FinePoint& fine, std::uint32_t near, std::int64_t& step) const
{
  const FinePoint at = { fine[0] >> DeepestLevel, fine[1] >> DeepestLevel,
    fine[2] >> DeepestLevel };
  const auto& guess = globals[near].index;
  const bool hit = guess[0] == at[0] && guess[1] == at[1] && guess[2] == at[2];
  const std::uint32_t g = hit ? near : globalAt(at[0], at[1], at[2]);
  step = FinePerBox;
  if (g == None || globals[g].firstUnit == None)
  {
    return g == None ? None : globals[g].firstBox;
  }
  step = FinePerBox >> globals[g].depth;
  constexpr std::int64_t Mask = FinePerBox - 1;
  return units[globals[g].firstUnit +
    unitIndex(globals[g], { fine[0] & Mask, fine[1] & Mask, fine[2] & Mask })];
}

void Boxes::listUnits()
{
  std::size_t size = 0;
  for (std::size_t g = 0; g + 1 < globals.size(); ++g)
  {
    globals[g].firstUnit = globals[g].depth == 0 ? None : static_cast<std::uint32_t>(size);
    size += globals[g].depth == 0 ? 0 : std::size_t(1) << 3 * globals[g].depth;
  }
  units.assign(size, None);
  findNearDepths();
  for (std::uint32_t b = 0; b < packed.size(); ++b)
  {
    const PackedBox& box = packed[b];
    const GlobalBox& global = globalOf(box);
    if (global.depth == 0)
    {
      continue;
    }
    const std::int64_t unit = FinePerBox >> global.depth;
    for (std::int64_t z = 0; z < fineSize(box, 2); z += unit)
    {
      for (std::int64_t y = 0; y < fineSize(box, 1); y += unit)
      {
        for (std::int64_t x = 0; x < fineSize(box, 0); x += unit)
        {
          units[global.firstUnit +
            unitIndex(global, { box.offset[0] + x, box.offset[1] + y, box.offset[2] + z })] = b;
        }
      }
    }
  }
}

void Boxes::findNearDepths()
{
  for (GlobalBox& global : globals)
  {
    global.nearDepth = 0;
  }
  for (std::size_t g = 0; g + 1 < globals.size(); ++g)
  {
    if (globals[g].depth == 0)
    {
      continue;
    }
    const auto at = globals[g].index;
    for (std::int64_t k = -1; k <= 1; ++k)
    {
      for (std::int64_t j = -1; j <= 1; ++j)
      {
        for (std::int64_t i = -1; i <= 1; ++i)
        {
          const std::uint32_t near = globalAt(at[0] + i, at[1] + j, at[2] + k);
          if (near != None)
          {
            globals[near].nearDepth = std::max(globals[near].nearDepth, globals[g].depth);
          }
        }
      }
    }
  }
}

std::array<std::uint32_t, 4> facing(const Boxes& boxes, const PackedBox& box, int axis, bool upper)
{
  std::array<std::uint32_t, 4> across;
  if (const GlobalBox& global = boxes.globalOf(box);
      global.nearDepth == 0) // neither it nor its neighbour is divided
  {
    std::array<std::int64_t, 3> at{ global.index[0], global.index[1], global.index[2] };
    at[axis] += upper ? 1 : -1;
    const std::uint32_t other = boxes.globalAt(at[0], at[1], at[2]);
    across.fill(other == None ? None : boxes.globals[other].firstBox);
    return across;
  }
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  FinePoint fine = boxes.fineLow(box);
  fine[axis] += upper ? Boxes::fineSize(box, axis) : -1;
  const FinePoint low = fine;
  for (unsigned quarter = 0; quarter < 4; ++quarter)
  {
    fine[a] = low[a] + (quarter & 1) * Boxes::fineSize(box, a) / 2;
    fine[b] = low[b] + (quarter >> 1) * Boxes::fineSize(box, b) / 2;
    std::int64_t step = 0;
    across[quarter] = boxes.boxAt(fine, box.global, step);
    if (quarter == 0 && step >= std::max(Boxes::fineSize(box, a), Boxes::fineSize(box, b)))
    {
      across.fill(across[0]); // one box, or none, spans the whole side
      break;
    }
  }
  return across;
}

std::vector<std::uint32_t> intersectedBoxes(const Boxes& boxes, Execution& execution)
{
  constexpr std::size_t BoxesAChunk = 1 << 16;
  const std::size_t count = boxes.packed.size();
  std::vector<std::vector<std::uint32_t>> parts(chunks(count, BoxesAChunk));
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
    {
      if (boxes.packed[b].status == BoxStatus::Intersected)
      {
        parts[begin / BoxesAChunk].push_back(static_cast<std::uint32_t>(b));
      }
    }
  });
  std::vector<std::uint32_t> result;
  for (const std::vector<std::uint32_t>& part : parts)
  {
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

}

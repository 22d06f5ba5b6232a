// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Boxes.h"

#include <algorithm>
#include <atomic>

namespace cartesian
{

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

std::uint32_t Boxes::globalAt(const FinePoint& fine, std::uint32_t near) const
{
  const FinePoint at = { fine[0] >> DeepestLevel, fine[1] >> DeepestLevel,
    fine[2] >> DeepestLevel };
  const auto& guess = globals[near].index;
  const bool hit = guess[0] == at[0] && guess[1] == at[1] && guess[2] == at[2];
  return hit ? near : globalAt(at[0], at[1], at[2]);
}

std::uint32_t Boxes::boxAt(const FinePoint& fine, std::uint32_t near, std::int64_t& step) const
{
  const std::uint32_t g = globalAt(fine, near);
  step = FinePerBox;
  if (g == None || globals[g].node == None)
  {
    return g == None ? None : globals[g].firstBox;
  }
  return tree.boxAt(fine, globals[g].node, 0, step);
}

bool Boxes::plantTree(Execution& execution)
{
  constexpr std::size_t GlobalsAChunk = 16;
  const std::size_t count = globals.size() - 1;
  std::vector<BoxTree> trees(chunks(count, GlobalsAChunk));
  std::atomic<bool> isFree{ true };
  execution.forEach(count, GlobalsAChunk, [&](std::size_t begin, std::size_t end) {
    BoxTree& chunk = trees[begin / GlobalsAChunk];
    std::vector<std::uint32_t> numbers;
    for (std::size_t g = begin; g < end; ++g)
    {
      GlobalBox& global = globals[g];
      global.depth = 0;
      numbers.clear();
      for (std::uint32_t b = global.firstBox; b < globals[g + 1].firstBox; ++b)
      {
        const auto& level = packed[b].level;
        global.depth = std::max({ global.depth, level[0], level[1], level[2] });
        numbers.push_back(b);
      }
      global.node = global.depth == 0 ? None : chunk.size();
      if (global.depth == 0
          ? numbers.size() != 1
          : !chunk.add(Cube{}, BoxTree::bitsFor(global.depth, 0), packed.data(), numbers))
      {
        isFree = false;
      }
    }
  });
  std::size_t words = 0;
  std::uint32_t nodes = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> before;
  for (const BoxTree& chunk : trees)
  {
    before.emplace_back(static_cast<std::uint32_t>(words), nodes);
    words += chunk.size();
    nodes += chunk.nodes();
  }
  tree.allocate(words, nodes);
  execution.forEach(count, GlobalsAChunk, [&](std::size_t begin, std::size_t end) {
    const std::size_t chunk = begin / GlobalsAChunk;
    const auto [firstWord, firstNode] = before[chunk];
    for (std::size_t g = begin; g < end; ++g)
    {
      globals[g].node += globals[g].node == None ? 0 : firstWord;
    }
    tree.place(trees[chunk], firstWord, firstNode, 0, [](std::uint32_t other) { return other; });
  });
  findNearDepths(execution);
  return isFree;
}

void Boxes::findNearDepths(Execution& execution)
{
  const std::vector<std::uint8_t> depths = largestAround(
    *this, EndlessGrid(), [&](std::size_t g) { return globals[g].depth; }, execution);
  for (std::size_t g = 0; g < depths.size(); ++g)
  {
    globals[g].nearDepth = depths[g];
  }
}

std::vector<std::uint8_t> largestAround(const Boxes& boxes, const EndlessGrid& grid,
  const std::function<std::uint8_t(std::size_t)>& depthOf, Execution& execution)
{
  constexpr std::size_t RowsAChunk = 64;
  const std::size_t rows = boxes.rowStart.size() - 1;
  const auto nj = static_cast<std::int64_t>(boxes.planes[1].size()) - 1;
  const auto nk = static_cast<std::int64_t>(boxes.planes[2].size()) - 1;
  const auto forEachOfRow = [&](std::size_t row, auto&& visit) {
    for (std::size_t g = boxes.rowStart[row]; g < boxes.rowStart[row + 1]; ++g)
    {
      visit(g);
    }
  };
  std::vector<std::uint8_t> result(boxes.rowStart.back(), 0);
  std::vector<std::uint8_t> ofRow(rows, 0);
  execution.forEach(rows, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      forEachOfRow(row, [&](std::size_t g) { ofRow[row] = std::max(ofRow[row], depthOf(g)); });
    }
  });
  execution.forEach(rows, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      const auto j = static_cast<std::int64_t>(row) % nj;
      const auto k = static_cast<std::int64_t>(row) / nj;
      for (std::int64_t n = 0; n < 9; ++n)
      {
        const auto across = grid.seen({ 0, j + n % 3 - 1, k + n / 3 - 1 });
        const std::int64_t y = across[1];
        const std::int64_t z = across[2];
        if (y < 0 || z < 0 || y >= nj || z >= nk ||
          ofRow[boxes.row(std::size_t(y), std::size_t(z))] == 0)
        {
          continue;
        }
        forEachOfRow(row, [&](std::size_t g) {
          const std::int64_t i = boxes.globals[g].index[0];
          for (std::int64_t side = -1; side <= 1; ++side)
          {
            const std::int64_t x = grid.seen({ i + side, 0, 0 })[0];
            const std::uint32_t near = boxes.globalAt(x, y, z);
            result[g] = std::max(result[g], near == None ? std::uint8_t(0) : depthOf(near));
          }
        });
      }
    }
  });
  return result;
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

// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/TriangleTree.h"

#include "Base/Sorting.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t NodesAChunk = 1 << 12;

// The upper 21 bits of a level, with two zeros between consecutive bits.
std::uint64_t spread(std::uint64_t level)
{
  std::uint64_t x = level >> 11;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

// A triangle's place on the space-filling curve: the Morton code of the centre of its bounds.
struct CurvePlace
{
  std::uint64_t code;
  std::uint32_t triangle;

  bool operator<(const CurvePlace& other) const
  {
    return code != other.code ? code < other.code : triangle < other.triangle;
  }
};

std::uint64_t codeOf(const Corners& c)
{
  std::uint64_t code = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto [least, most] = std::minmax({ c[0][axis], c[1][axis], c[2][axis] });
    code |= spread((std::uint64_t(least) + most) / 2) << axis;
  }
  return code;
}

std::vector<std::uint32_t> allWithArea(const Surface& surface, Execution& execution)
{
  const std::size_t count = surface.triangles.size();
  std::vector<std::vector<std::uint32_t>> parts(chunks(count, NodesAChunk));
  execution.forEach(count, NodesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      if (exactNormal(surface.corners(t)) != std::array<Wide, 3>{ 0, 0, 0 })
      {
        parts[begin / NodesAChunk].push_back(static_cast<std::uint32_t>(t));
      }
    }
  });
  return concatenated(parts);
}

}

TriangleTree::TriangleTree(const Surface& surface, Execution& execution)
  : TriangleTree(surface, allWithArea(surface, execution), execution)
{
}

TriangleTree::TriangleTree(
  const Surface& surface, std::vector<std::uint32_t> triangles, Execution& execution)
  : order_(std::move(triangles))
{
  std::vector<CurvePlace> places(order_.size());
  execution.forEach(places.size(), NodesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      places[i] = { codeOf(surface.corners(order_[i])), order_[i] };
    }
  });
  sortAll(places, execution);
  levels_.emplace_back(places.size());
  execution.forEach(places.size(), NodesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      order_[i] = places[i].triangle;
      levels_[0][i] = leafOf(surface.corners(order_[i]));
    }
  });
  while (levels_.back().size() > 1)
  {
    addLevel(execution);
  }
}

TriangleTree::TreeNode TriangleTree::leafOf(const Corners& c)
{
  TreeNode leaf{ {}, {}, 0 };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto [least, most] = std::minmax({ c[0][axis], c[1][axis], c[2][axis] });
    leaf.low[axis] = least;
    leaf.high[axis] = most;
    leaf.size = std::max(leaf.size, most - least);
  }
  return leaf;
}

void TriangleTree::addLevel(Execution& execution)
{
  const std::vector<TreeNode>& below = levels_.back();
  std::vector<TreeNode> above((below.size() + 1) / 2);
  execution.forEach(above.size(), NodesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      above[i] = below[2 * i];
      if (2 * i + 1 < below.size())
      {
        const TreeNode& other = below[2 * i + 1];
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          above[i].low[axis] = std::min(above[i].low[axis], other.low[axis]);
          above[i].high[axis] = std::max(above[i].high[axis], other.high[axis]);
        }
        above[i].size = std::max(above[i].size, other.size);
      }
    }
  });
  levels_.push_back(std::move(above));
}

}

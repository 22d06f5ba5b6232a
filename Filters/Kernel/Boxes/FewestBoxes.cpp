// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/FewestBoxes.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

constexpr std::uint8_t bit(BoxStatus status)
{
  return static_cast<std::uint8_t>(1u << static_cast<unsigned>(status));
}

}

FewestBoxes::Part FewestBoxes::half(const Part& part, int axis, int which)
{
  Part result = part;
  ++result.level[axis];
  result.position[axis] = 2 * part.position[axis] + which;
  return result;
}

std::size_t FewestBoxes::index(const Part& part) const
{
  const std::size_t along = (std::size_t(2) << depth_) - 1;
  std::size_t result = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const int level = part.level[axis];
    result = result * along + static_cast<std::size_t>((1 << level) - 1 + part.position[axis]);
  }
  return result;
}

bool FewestBoxes::isLeaf(const Part& part) const
{
  const auto& level = part.level;
  if (level[0] == depth_ && level[1] == depth_ && level[2] == depth_)
  {
    return true;
  }
  return content_[index(part)] == bit(BoxStatus::Inside) &&
    std::min({ level[0], level[1], level[2] }) >= forced_;
}

int FewestBoxes::cheapestSplit(const Part& part, std::uint32_t& cost) const
{
  int best = -1;
  cost = std::numeric_limits<std::uint32_t>::max();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (part.level[axis] < depth_)
    {
      const std::uint32_t sum =
        cost_[index(half(part, axis, 0))] + cost_[index(half(part, axis, 1))];
      if (sum < cost)
      {
        cost = sum;
        best = axis;
      }
    }
  }
  return best;
}

void FewestBoxes::evaluate(const Part& part)
{
  const std::size_t here = index(part);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (part.level[axis] < depth_)
    {
      content_[here] = static_cast<std::uint8_t>(
        content_[index(half(part, axis, 0))] | content_[index(half(part, axis, 1))]);
      break;
    }
  }
  if (content_[here] == bit(BoxStatus::Outside))
  {
    cost_[here] = 0;
  }
  else if (isLeaf(part))
  {
    cost_[here] = 1;
  }
  else
  {
    cheapestSplit(part, cost_[here]);
  }
}

// Parts of these levels, x fastest.
template <class Visitor>
void FewestBoxes::forEachPart(const std::array<int, 3>& level, Visitor&& visit)
{
  Part part{ level, {} };
  for (part.position[2] = 0; part.position[2] < 1 << level[2]; ++part.position[2])
  {
    for (part.position[1] = 0; part.position[1] < 1 << level[1]; ++part.position[1])
    {
      for (part.position[0] = 0; part.position[0] < 1 << level[0]; ++part.position[0])
      {
        visit(part);
      }
    }
  }
}

std::uint32_t FewestBoxes::search(int depth, int forced, const std::vector<BoxStatus>& units)
{
  depth_ = depth;
  forced_ = forced;
  const std::size_t along = (std::size_t(2) << depth) - 1;
  cost_.resize(along * along * along);
  content_.resize(cost_.size());
  std::size_t unit = 0;
  forEachPart(
    { depth, depth, depth }, [&](const Part& part) { content_[index(part)] = bit(units[unit++]); });
  // Halves are deeper than the whole: from the units up.
  std::array<int, 3> level{};
  for (level[2] = depth; level[2] >= 0; --level[2])
  {
    for (level[1] = depth; level[1] >= 0; --level[1])
    {
      for (level[0] = depth; level[0] >= 0; --level[0])
      {
        forEachPart(level, [&](const Part& part) { evaluate(part); });
      }
    }
  }
  return cost_[index(whole())];
}

void FewestBoxes::collect(std::vector<LocalBox>& boxes) const
{
  collect(whole(), boxes);
}

void FewestBoxes::collect(const Part& part, std::vector<LocalBox>& boxes) const
{
  const std::uint8_t content = content_[index(part)];
  if (content == bit(BoxStatus::Outside))
  {
    return;
  }
  if (isLeaf(part))
  {
    LocalBox box;
    for (int axis = 0; axis < 3; ++axis)
    {
      box.level[axis] = static_cast<std::uint8_t>(part.level[axis]);
      box.offset[axis] =
        static_cast<std::uint8_t>(part.position[axis] * (FinePerBox >> part.level[axis]));
    }
    box.status = content == bit(BoxStatus::Inside) ? BoxStatus::Inside : BoxStatus::Intersected;
    box.corners = AllCorners;
    boxes.push_back(box);
    return;
  }
  std::uint32_t cost = 0;
  const int axis = cheapestSplit(part, cost);
  collect(half(part, axis, 0), boxes);
  collect(half(part, axis, 1), boxes);
}

}

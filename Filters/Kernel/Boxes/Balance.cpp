// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Balance.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Calls visit(levels) for the boxes across a side, at least once for each.
template <class Visitor>
void forEachAcross(
  const LevelsAround& boxes, const BoxToBalance& box, int axis, bool upper, Visitor&& visit)
{
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  FinePoint fine = box.low;
  fine[axis] += upper ? box.size(axis) : -1;
  const std::int64_t endA = fine[a] + box.size(a);
  const std::int64_t endB = fine[b] + box.size(b);
  const std::int64_t firstA = fine[a];
  const auto endOfUnit = [](std::int64_t at, std::int64_t size) { return (at & -size) + size; };
  while (fine[b] < endB)
  {
    std::int64_t next = endB; // where the first unit ends
    for (fine[a] = firstA; fine[a] < endA;)
    {
      std::int64_t size = 0;
      const std::array<std::uint8_t, 3>* const levels = boxes.at(fine, size);
      if (levels != nullptr)
      {
        visit(*levels);
      }
      fine[a] = endOfUnit(fine[a], size);
      next = std::min(next, endOfUnit(fine[b], size));
    }
    fine[b] = next;
  }
}

// The axes along which a neighbour is too fine for the box.
unsigned axesAlongWhichTooCoarse(
  const LevelsAround& boxes, const BoxToBalance& box, const BalancePass& pass)
{
  unsigned result = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool upper : { false, true })
    {
      forEachAcross(boxes, box, axis, upper, [&](const std::array<std::uint8_t, 3>& other) {
        for (unsigned along = 0; along < 3; ++along)
        {
          const bool tooCoarse = box.level[along] < pass.level && other[along] >= pass.touching;
          result |= unsigned(tooCoarse) << along;
        }
      });
    }
  }
  return result;
}

// Halving a box along these axes must not make it long: the axes along which it is halved then, too.
unsigned withoutLongParts(const BoxToBalance& box, unsigned axes)
{
  int most = 0;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    most = std::max<int>(most, box.level[axis] + static_cast<int>(axes >> axis & 1));
  }
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    axes |= unsigned(box.level[axis] + MostLevelsApart < most) << axis;
  }
  return axes;
}

}

unsigned axesToHalve(const LevelsAround& boxes, const BoxToBalance& box, const BalancePass& pass)
{
  if (std::min({ box.level[0], box.level[1], box.level[2] }) >= pass.level)
  {
    return 0; // this box is fine enough
  }
  const unsigned wanted = axesAlongWhichTooCoarse(boxes, box, pass);
  unsigned result = 0;
  if (wanted != 0 && pass.isAlike)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      result |= unsigned(box.level[axis] < pass.level) << axis;
    }
    return result;
  }
  int fewest = 2;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    if ((wanted >> axis & 1) == 0)
    {
      continue;
    }
    int unfinished = 0;
    for (const bool upper : { false, true })
    {
      unfinished += axesAlongWhichTooCoarse(boxes, box.half(axis, upper), pass) != 0 ? 1 : 0;
    }
    result = unfinished < fewest ? 0 : result;
    fewest = std::min(fewest, unfinished);
    result |= unfinished == fewest ? 1u << axis : 0;
  }
  return result == 0 ? 0 : withoutLongParts(box, result);
}

}

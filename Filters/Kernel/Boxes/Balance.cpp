// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Balance.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Calls visit(neighbour) for the boxes across a side, at least once for each.
template <class Visitor>
void forEachAcross(const Boxes& boxes, const PackedBox& box, int axis, bool upper, Visitor&& visit)
{
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  FinePoint fine = boxes.fineLow(box);
  fine[axis] += upper ? Boxes::fineSize(box, axis) : -1;
  const std::int64_t endA = fine[a] + Boxes::fineSize(box, a);
  const std::int64_t endB = fine[b] + Boxes::fineSize(box, b);
  const std::int64_t firstA = fine[a];
  std::int64_t step = 1;
  for (; fine[b] < endB; fine[b] += step)
  {
    for (fine[a] = firstA; fine[a] < endA; fine[a] += step)
    {
      const std::uint32_t neighbour = boxes.boxAt(fine, box.global, step);
      if (neighbour != None)
      {
        visit(boxes.packed[neighbour]);
      }
    }
  }
}

// The axes along which a neighbour is too fine for the box.
unsigned axesAlongWhichTooCoarse(const Boxes& boxes, const PackedBox& box, const BalancePass& pass)
{
  unsigned result = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool upper : { false, true })
    {
      forEachAcross(boxes, box, axis, upper, [&](const PackedBox& other) {
        for (unsigned along = 0; along < 3; ++along)
        {
          const bool tooCoarse =
            box.level[along] < pass.level && other.level[along] >= pass.touching;
          result |= unsigned(tooCoarse) << along;
        }
      });
    }
  }
  return result;
}

}

std::uint8_t axesToHalve(const Boxes& boxes, const PackedBox& box, const BalancePass& pass)
{
  if (boxes.globalOf(box).nearDepth < pass.touching ||
    std::min({ box.level[0], box.level[1], box.level[2] }) >= pass.level)
  {
    return 0; // no neighbour is finer, or this box is fine enough
  }
  const unsigned wanted = axesAlongWhichTooCoarse(boxes, box, pass);
  unsigned result = 0;
  if (wanted != 0 && pass.isGrowth())
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      result |= unsigned(box.level[axis] < pass.level) << axis;
    }
    return static_cast<std::uint8_t>(result);
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
      unfinished += axesAlongWhichTooCoarse(boxes, halfOf(box, axis, upper), pass) != 0 ? 1 : 0;
    }
    result = unfinished < fewest ? 0 : result;
    fewest = std::min(fewest, unfinished);
    result |= unfinished == fewest ? 1u << axis : 0;
  }
  return static_cast<std::uint8_t>(result);
}

}

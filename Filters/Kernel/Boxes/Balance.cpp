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

}

std::uint8_t axisToHalve(const Boxes& boxes, const PackedBox& box, int level)
{
  std::uint8_t result = NoAxis;
  if (boxes.globalOf(box).nearDepth <= level ||
    std::min({ box.level[0], box.level[1], box.level[2] }) >= level)
  {
    return result; // no neighbour is finer, or this box is fine enough
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool upper : { false, true })
    {
      forEachAcross(boxes, box, axis, upper, [&](const PackedBox& other) {
        for (const int along : { (axis + 1) % 3, (axis + 2) % 3 })
        {
          if (box.level[along] < level && other.level[along] > level)
          {
            result = std::min(result, static_cast<std::uint8_t>(along));
          }
        }
      });
    }
  }
  return result;
}

}

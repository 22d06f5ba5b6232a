#include "Balance.h"

#include <algorithm>
#include <atomic>

namespace cartesian
{

namespace
{

constexpr std::size_t BoxesAChunk = 1024;

// Calls visit(neighbour) for the boxes across a side, one or more times each.
template <class Visitor>
void forEachAcross(const Boxes& boxes, const Box& box, int axis, bool upper, Visitor&& visit)
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
        visit(boxes.boxes[neighbour]);
      }
    }
  }
}

std::uint8_t axisToHalve(const Boxes& boxes, const Box& box)
{
  std::uint8_t result = NoAxis;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool upper : { false, true })
    {
      forEachAcross(boxes, box, axis, upper, [&](const Box& other) {
        for (const int along : { (axis + 1) % 3, (axis + 2) % 3 })
        {
          if (other.level[along] > box.level[along] + 1)
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

std::vector<std::uint8_t> tooCoarse(const Boxes& boxes, Execution& execution)
{
  std::vector<std::uint8_t> axes(boxes.boxes.size(), NoAxis);
  std::atomic<bool> any{ false };
  execution.forEach(boxes.globals.size() - 1, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t g = begin; g < end; ++g)
    {
      const int deepest = boxes.globals[g].nearDepth;
      for (std::uint32_t b = boxes.globals[g].firstBox; b < boxes.globals[g + 1].firstBox; ++b)
      {
        const auto& level = boxes.boxes[b].level;
        if (std::min({ level[0], level[1], level[2] }) + 1 >= deepest)
        {
          continue; // no box around is deep enough
        }
        axes[b] = axisToHalve(boxes, boxes.boxes[b]);
        if (axes[b] != NoAxis)
        {
          any = true;
        }
      }
    }
  });
  if (!any)
  {
    axes.clear();
  }
  return axes;
}

}

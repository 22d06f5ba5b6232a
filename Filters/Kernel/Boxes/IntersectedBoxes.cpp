// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/IntersectedBoxes.h"

#include <algorithm>

namespace cartesian
{

double countIntersected(const PackedBox* begin, const PackedBox* end)
{
  return static_cast<double>(std::count_if(
    begin, end, [](const PackedBox& box) { return box.status == BoxStatus::Intersected; }));
}

double countIntersected(const Boxes& boxes)
{
  return countIntersected(boxes.packed.data(), boxes.packed.data() + boxes.packed.size());
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/UnitPlanes.h"

namespace cartesian
{

void UnitPlanes::set(
  const Meshlines& planes, const std::array<std::uint32_t, 3>& index, const Cube& cube, int bits)
{
  bits_ = bits;
  const std::int64_t step = cube.size() >> bits;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    planes_[axis].clear();
    for (std::int64_t part = 0; part <= 1 << bits; ++part)
    {
      planes_[axis].push_back(planeAt(planes, axis, index[axis], cube.offset[axis] + part * step));
    }
    inner_[axis].assign(planes_[axis].begin() + 1, planes_[axis].end() - 1);
    low_[axis] = planes_[axis].front();
    high_[axis] = planes_[axis].back();
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace cartesian
{

// A failing cell of the core, or a part of one, that is left out.
struct RemovedCell
{
  std::uint32_t box;
  double volume; // in levels
};

}

// SPDX-License-Identifier: BSD-3-Clause
// A loop on all threads over items that take a few microseconds at most.
#pragma once

#include "Base/Execution.h"

namespace cartesian
{

constexpr std::size_t ItemsOfALoop = 1024; // in each chunk

// Calls visit(i) for the items 0, 1, ... of so many.
template <class Visitor>
void forEachItem(std::size_t count, Execution& execution, Visitor&& visit)
{
  execution.forEach(count, ItemsOfALoop, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      visit(i);
    }
  });
}

}

// SPDX-License-Identifier: BSD-3-Clause
// The statistics of step 12 of section 6.
#pragma once

#include "Mesher/Assembly.h"

namespace cartesian
{

struct Statistic
{
  const char* name; // of the field data array
  const char* meaning;
  double value;
};

// Of a part (Decomposition.h), those of its core: the parts' add up.
std::vector<Statistic> statistics(const Assembly& assembly);

}

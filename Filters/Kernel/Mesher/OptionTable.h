// SPDX-License-Identifier: BSD-3-Clause
// The options that are one number, by their names in the panel. Tests compare the plugin's XML, the filters' initial
// values and the template of task files with it.
#pragma once

#include "Base/Range.h"

#include <vector>

namespace cartesian
{

struct NamedOption
{
  const char* name; // the panel's label; without spaces the property's name in XML, Python and C++
  double initial;
  Range range;
  const char* unit;                      // "" for ratios and numbers of things
  std::vector<const char*> choices = {}; // of an enum, texts for 0, 1, ...
};

std::vector<NamedOption> optionTable();

}

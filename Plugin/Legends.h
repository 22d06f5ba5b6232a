// SPDX-License-Identifier: BSD-3-Clause
// Legends of names and of measures.
#pragma once

namespace cartesian
{

// From now on new ones have titles in words. Those of many names are small, and those of a measure that has the same value
// everywhere have this one label instead of a range.
void watchLegends();

}

// SPDX-License-Identifier: BSD-3-Clause
// Legends of names, after a source has others.
#pragma once

namespace cartesian
{

// From now on the colours of an array get the names that a source has since it was applied again, and lose those that it had
// and that no source has any more.
void watchNames();

}

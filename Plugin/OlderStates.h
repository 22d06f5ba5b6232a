// SPDX-License-Identifier: BSD-3-Clause States that were saved before a property existed.
#pragma once

namespace cartesian
{

// From now on, properties that a state lacks get the value of their hint OlderStates, where they have one, instead of
// their default: so the state keeps its mesh.
void completeOlderStates();

}

// SPDX-License-Identifier: BSD-3-Clause
// What panels report of outputs.
#pragma once

namespace cartesian
{

// From now on it is asked for again when outputs are new: ParaView asks too early.
void watchTold();

}

// SPDX-License-Identifier: BSD-3-Clause
// Python scripts in ParaView's window.
#pragma once

namespace cartesian
{

// Whether one is running now: in the window, what it makes is not the user's choice in a dialog.
bool isInScript();

}

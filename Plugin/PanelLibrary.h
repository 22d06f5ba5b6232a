// SPDX-License-Identifier: BSD-3-Clause
// The widgets of the panel, which are in a library of their own.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded: loads that library (Plugin/Panel) once there is something in ParaView's window.
void loadPanelWidgets();

}

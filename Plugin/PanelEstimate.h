// SPDX-License-Identifier: BSD-3-Clause
// Estimates in the panel that follow edits before they are applied.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on a property that is only information, and that a source names in its
// hints, is for the values in the source's panel, also those that were not applied yet. For these, which may change with
// each digit typed, a command of the source's class makes the estimate a short one:
//
//   <Estimate property="ExpectedBoxes" command="ExpectCellSizeAlone"/>
//
// Scripts, which have no such values, get estimates for the applied ones.
void watchPanels();

}

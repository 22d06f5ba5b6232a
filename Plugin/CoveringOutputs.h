// SPDX-License-Identifier: BSD-3-Clause
// Outputs that would cover what filters make of another: the boundary of a mesh around its clip.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on, where a filter takes the place of an output in the active view, as in
// the window after Apply, another output of the same source is hidden with it, if the source has the hint
//
//   <Covers port="1" what="0"/>
void watchCoveringOutputs();

}

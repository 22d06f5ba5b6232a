// SPDX-License-Identifier: BSD-3-Clause
// Outputs that would cover what filters make of another: the boundary of a mesh around its clip.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on, where the window shows a filter in the active view, it hides another
// output of the filter's source there, if that has the hint
//
//   <Covers port="1" what="0"/>
//
// and the filter is of output 0 and replaces its input. Scripts without a window hide what they want.
void watchCoveringOutputs();

}

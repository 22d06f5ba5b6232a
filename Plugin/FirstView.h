// SPDX-License-Identifier: BSD-3-Clause
// The initial appearance of the mesher's outputs in a view.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on a representation that is new to a view is coloured by name, with a
// legend, if the hint Colours of its source names an array:
//
//   <Colours port="1" array="BoundaryName"/>
//
// No array: one plain colour, as an outline has no others. A boundary has one plain colour if it is the only one. The names are
// those of the source's property LegendInfo. States keep the colours that they were saved with; older ones get the opacity
// functions that these need.
void watchViews();

}

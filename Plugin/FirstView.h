// SPDX-License-Identifier: BSD-3-Clause
// What a view shows of the mesher's outputs at first.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on a representation that is new to a view has colours by name, with a
// legend, where the hint Colours of its source says of which array:
//
//   <Colours port="1" array="BoundaryName"/>
//
// It has one plain colour where all cells have the same name, and no edges where there are too many to be seen. The
// names are those of the source's property LegendInfo. A text with the hint SmallText is small, in a corner. States keep
// the colours that they were saved with.
void watchViews();

}

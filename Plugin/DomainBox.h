// SPDX-License-Identifier: BSD-3-Clause
// The box of the flow domain in the view, which can be dragged.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on, of each source with the hint
//
//   <DomainBox group="internal_filters" name="MeshPreview"/>
//
// the Domain Bounds in its panel are a box with handles in the active view of the window, while the source is selected and
// these bounds count. When the user chooses Box From Bounds for the first time, they begin with the box that there was,
// which the named proxy knows by its property BoxAroundSurface.
void watchDomainBoxes();

}

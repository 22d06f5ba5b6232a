// SPDX-License-Identifier: BSD-3-Clause
// The first picture of a mesh around bodies.
#pragma once

namespace cartesian
{

// When outputs with the hint FlowView come into a view for the first time and Domain is Outside: with show="0" they are hidden;
// else the bodies fill the view, upright, seen from upstream and from the meshed half, before the mesh in the plane of symmetry or,
// where the mesh is no half, in the middle (MiddleSlice.h).
void watchFlowViews();

}

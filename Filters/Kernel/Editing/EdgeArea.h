// SPDX-License-Identifier: BSD-3-Clause
// Where a node goes from a sharp edge or a border, the next one moves aside, so that the flat walls beside the edge keep
// their area: openings do not shrink as their rims lose nodes.
#pragma once

#include "Editing/MeshEditor.h"

namespace cartesian
{

// Node u, on a sharp edge, is to become node v on the same edge, at `at`: where v should lie instead. `at` itself where the
// edge does not go on from both, or v must not leave its place.
Vector placeKeepingArea(const MeshView& mesh, std::uint32_t u, std::uint32_t v, const Vector& at);

// The area between the edge as it is and as it would be with v at `at`; 0 where it does not go on from both.
double areaLost(const MeshView& mesh, std::uint32_t u, std::uint32_t v, const Vector& at);

}

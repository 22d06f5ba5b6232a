// SPDX-License-Identifier: BSD-3-Clause
// Where surfaces of several regions touch in a plane, gives them the same triangles there.
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

// Divides triangles of different regions that overlap in one plane along each other's edges, and the
// triangles beside them where that puts vertices on their edges. Afterwards such triangles have the same
// vertices, or do not overlap. Vertices are added where edges cross, on the lattice.
void imprint(Surface& surface, Execution& execution);

}

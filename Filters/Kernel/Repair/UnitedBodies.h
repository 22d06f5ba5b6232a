// SPDX-License-Identifier: BSD-3-Clause
// Bodies that cross or touch become one: all at once, or, where that is uncertain somewhere, group by group, so that
// only those that meet there stay as they are.
#pragma once

#include "Lattice/Vector.h"
#include "Repair/Duplicates.h"
#include "Repair/WallsOfBodies.h"

#include <memory>

namespace cartesian
{

struct UnitedBodies
{
  std::shared_ptr<const Surface> before; // none: nothing was united
  std::vector<Vector> refused;           // where groups that stay as they are cross, levels
  std::vector<std::uint8_t>
    touching; // of each triangle of `before`: it was united, and nothing of it is inside another body
};

// `surface`: closed and oriented as far as it can be; triangles that close holes are the last ones. `sheets`: their
// triangles, as they were before they got sides.
UnitedBodies uniteBodies(Surface& surface, const std::vector<DroppedTriangle>& sheets,
  MeshedSide meshed, Execution& execution);

}

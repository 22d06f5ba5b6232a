// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/Mending.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

Mending::Mending(const MendingTask& what, MeshEnergy& objective)
  : task(what)
  , mesh(what.mesh)
  , energy(objective)
  , faces(what.mesh)
  , changes(what.mesh.cells.changing)
  , edgeOf(what.mesh.nodes.at.size(), std::numeric_limits<double>::infinity())
{
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
  {
    mesh.forEachCorner(f, [&](std::uint32_t n) { edgeOf[n] = std::min(edgeOf[n], task.edges[f]); });
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/FacesOfCells.h"

#include <numeric>

namespace cartesian
{

FacesOfCells::FacesOfCells(const FoamMesh& mesh)
  : start(mesh.cellCount + 1)
{
  const auto forEachUse = [&](auto&& visit) {
    for (std::uint32_t face = 0; face < mesh.owner.size(); ++face)
    {
      visit(mesh.owner[face], OrientedFace{ face, false });
      if (face < mesh.neighbour.size())
      {
        visit(mesh.neighbour[face], OrientedFace{ face, true });
      }
    }
  };
  forEachUse([&](std::uint32_t cell, OrientedFace) { ++start[cell + 1]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  uses.resize(start.back());
  std::vector<std::size_t> next = start;
  forEachUse([&](std::uint32_t cell, OrientedFace use) { uses[next[cell]++] = use; });
}

}

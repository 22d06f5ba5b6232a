// SPDX-License-Identifier: BSD-3-Clause
// Small parts of a mesh that no face connects with the rest: bodies of the size of a few boxes, and fragments that the
// grid has cut off from a larger body. In a fragment a solver cannot determine the pressure.
#pragma once

#include "Cells/WallMesh.h"

namespace cartesian
{

// A small part has at most so many cells, none a whole box.
constexpr std::size_t MostCellsOfSmallPart = 16;

// It is a fragment if it holds less than this part of the volume that the surface around it encloses.
constexpr double LargestFragment = 0.01;

struct SmallPart
{
  std::vector<std::uint32_t> cells; // in order
  bool isFragment;
};

// In order of their first cells; with several regions, parts of one, of which none is a fragment: without it there
// would be a hole between two.
std::vector<SmallPart> findSmallParts(const Boxes& boxes, const Patches& patches,
  const Sides& sides, const WallMesh& wall, Execution& execution);

}

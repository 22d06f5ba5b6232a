// SPDX-License-Identifier: BSD-3-Clause
// Assembly of cells (section 6, part B; 4.10).
//
// Method: faces of a box that share an edge belong together; each closed group of them is a cell, with the groups that it encloses as its
// cavities. Source: the paper, which does not say how a box is separated into volumes.
// Limits: cells here are raw: tiny, thin and concave ones stay (unless small ones are removed, before anything else), and the room
// Editing improves them. Nothing is moved, and no face is divided.
#pragma once

#include "Cells/SmallCellSpec.h"
#include "Cells/WallMesh.h"

namespace cartesian
{

// Gives WallMesh::flawed.
std::vector<std::uint8_t> findFlawed(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, Execution& execution);

// Finds the separated volumes of each polyhedral box, and marks small ones as removed. Cells thinner than a
// hundredth of a lattice step (slivers due to rounding) are removed whatever R is. Throws Error: TooManyBoxes.
WallMesh assembleCells(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, const SmallCellSpec& spec, Execution& execution);

// The wall of faces between a cell and this box, which has no cells.
std::int32_t boundaryBeyond(const Patches& patches, const Sides& sides, std::uint32_t box);

}

// SPDX-License-Identifier: BSD-3-Clause
// The levels of cells and points with which OpenFOAM's solvers refine a mesh further and undo it (hexRef8,
// dynamicRefineFvMesh).
//
// Method: a cell of level L is refined at 8 anchors, its points of level L or less; solvers protect cells that have more or fewer.
// Boxes that were halved alike along all axes, uncut and with sides that are whole or quartered, have levels as often as they were
// halved, and so have the points in them. All other points get a level that is no cell's, so that other cells lack anchors. Boxes beside
// which solvers would still divide a face wrongly, or refine another cell, are given up, until there are none.
// Source: hexRef8.C and dynamicRefineFvMesh.C of OpenFOAM v1912 (faceLevel, setRefinement, checkRefinementLevels).
#pragma once

#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

struct RefinementLevels
{
  std::vector<std::int32_t> ofCells; // those of two with a face between them differ by 1 at most
  std::vector<std::int32_t> ofPoints;
  double edge; // the shortest of a cell of level 0, in units of the mesh
};

// None if solvers could refine no cell, or mesh.boxLevels is empty.
std::optional<RefinementLevels> refinementLevels(const FoamMesh& mesh);

}

// SPDX-License-Identifier: BSD-3-Clause
// The mesh of an OpenFOAM case, whichever program wrote it.
#pragma once

#include "Quality/FaceList.h"

#include <filesystem>

namespace cartesian
{

// In the form that measureQuality and checkForSolver take.
struct PolyMesh
{
  std::vector<double> points; // three coordinates each
  CellFaces cells;            // the faces of each in the order of the files, from outside
  FaceList faces;             // in the order of the files, those of the patches last
};

// Reads points, faces, owner and neighbour of a folder polyMesh: ASCII, or binary with labels of 32 bits and numbers of
// 64. Throws Error: CannotRead (a file is missing, or is not what OpenFOAM writes), BadMesh (faces of points or cells
// that are not there).
PolyMesh readPolyMesh(const std::filesystem::path& folder);

}

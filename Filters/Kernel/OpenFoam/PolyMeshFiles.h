// SPDX-License-Identifier: BSD-3-Clause
// A mesh as an OpenFOAM case: its folder constant/polyMesh.
#pragma once

#include "OpenFoam/FoamBoundary.h"
#include "OpenFoam/FoamFile.h"
#include "Quality/FaceList.h"

namespace cartesian
{

struct PolyMesh
{
  const std::vector<double>& points; // three coordinates each; each is a point of a face
  const CellFaces& cells;
  const FaceList& faces; // boundary faces in order of the patches
  const std::vector<FoamPatch>& patches;
};

// Writes points, faces, owner, neighbour and boundary into `folder`/constant/polyMesh; and
// system/controlDict, fvSchemes and fvSolution where they are missing: checkMesh wants them.
//
// A polyMesh that is there already is replaced once the new one is complete, if this function wrote
// it for patches of the same names: then the entries of its patches, which the user may have
// edited, are kept but for the numbers of faces. What else is in the folder (zones and sets, which
// do not fit the new mesh), and all of any other polyMesh, is renamed to polyMesh.old
// (polyMesh.old2, ...): the result is the new name, empty if there was no need.
//
// Throws Error: BadMesh (more than 2^31 - 1 points, faces or corners), CannotWrite.
std::filesystem::path writePolyMesh(
  const PolyMesh& mesh, const std::filesystem::path& folder, FoamFormat format);

// Creates the empty file by which ParaView opens a case, if it is not there. Throws Error
// (CannotWrite).
void createMarker(const std::filesystem::path& path);

}

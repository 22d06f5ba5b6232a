// SPDX-License-Identifier: BSD-3-Clause
// A mesh as an OpenFOAM case: its folder constant/polyMesh.
#pragma once

#include "OpenFoam/FoamBoundary.h"
#include "OpenFoam/FoamFile.h"
#include "Quality/FaceList.h"

namespace cartesian
{

struct FoamZone
{
  std::string name;
  std::vector<std::uint32_t> cells; // ascending
};

struct FoamMesh
{
  const std::vector<double>& points; // three coordinates each; each point belongs to a face
  const CellFaces& cells;
  const FaceList& faces; // boundary faces in order of the patches
  const std::vector<FoamPatch>& patches;
  std::vector<FoamZone> zones = {}; // cellZones; none: no such file
};

// Writes points, faces, owner, neighbour, boundary and, if there are zones, cellZones into `folder`/constant/polyMesh, and the files
// system/controlDict, fvSchemes and fvSolution that checkMesh needs, if they are missing.
//
// If this function wrote an existing polyMesh for patches of the same names, that is replaced once the new
// one is complete. The entries of its patches, which the user may have edited, are kept except for the
// numbers of faces. Anything else in the folder (zones and sets, which do not fit the new mesh), and all of
// any other polyMesh, is renamed to polyMesh.old (polyMesh.old2, ...). Returns the new name, or an empty one
// if nothing was renamed.
//
// Throws Error: BadMesh (more than 2^31 - 1 points, faces or corners), CannotWrite.
std::filesystem::path writePolyMesh(
  const FoamMesh& mesh, const std::filesystem::path& folder, FoamFormat format);

// Creates the empty file with which ParaView opens a case, if it does not exist. Throws Error
// (CannotWrite).
void createMarker(const std::filesystem::path& path);

}

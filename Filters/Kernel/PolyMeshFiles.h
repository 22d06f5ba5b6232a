// A mesh as an OpenFOAM case: its folder constant/polyMesh.
#pragma once

#include "FaceList.h"
#include "FoamFile.h"

namespace cartesian
{

struct FoamPatch
{
  std::string name;  // distinct words (foamWord)
  std::size_t count; // faces, one or more
};

struct PolyMesh
{
  const std::vector<double>& points; // three coordinates each; each is a point of a face
  const CellFaces& cells;
  const FaceList& faces; // boundary faces in order of the patches
  const std::vector<FoamPatch>& patches;
};

// The name with an underscore for each character that OpenFOAM does not allow in words.
std::string foamWord(const std::string& name);

// Writes points, faces, owner, neighbour and boundary into `folder`/constant/polyMesh; and
// system/controlDict, fvSchemes and fvSolution where they are missing: checkMesh wants them.
//
// Patches are of type wall where the name starts with "wall" or "Wall", else of type patch.
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

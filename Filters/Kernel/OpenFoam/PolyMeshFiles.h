// SPDX-License-Identifier: BSD-3-Clause
// A mesh as an OpenFOAM case: its folder constant/polyMesh.
#pragma once

#include "OpenFoam/FoamBoundary.h"
#include "OpenFoam/FoamFile.h"
#include "OpenFoam/SolverSetup.h"
#include "Quality/FaceList.h"

#include <optional>

namespace cartesian
{

struct FoamZone
{
  std::string name;
  std::vector<std::uint32_t> cells; // ascending
};

// Inner faces, each seen from the same side.
struct FoamFaceZone
{
  std::string name;
  std::vector<std::uint32_t> faces; // ascending
  std::vector<bool> isTurned;       // that side is not the owner's
};

// The numbers that the points, faces, cells and patches of a piece have in the whole mesh (FoamPieces.h).
struct FoamAddressing
{
  std::vector<std::int32_t> points;
  std::vector<std::int32_t> faces; // from one; negative where the whole mesh has the face reversed
  std::vector<std::int32_t> cells;
  std::vector<std::int32_t> patches; // -1: between two processes
};

// How often the box of a cell was halved.
struct BoxLevel
{
  std::uint8_t most; // along one of the axes, 0 to DeepestLevel
  bool isWhole;      // alike along all axes, and the cell is all of the box
};

struct FoamMesh
{
  std::vector<double> points;           // three coordinates each; each point belongs to a face
  std::vector<std::size_t> start;       // of each face in `corners`, and the end
  RawVector<std::uint32_t> corners;     // points in order around the face, from outside its owner
  std::vector<std::uint32_t> owner;     // of each face: inner ones first, then those of the patches
  std::vector<std::uint32_t> neighbour; // of inner faces
  std::size_t cellCount;
  std::vector<FoamPatch> patches;
  std::vector<FoamZone> zones = {}; // cellZones; none: no such file
  std::vector<FoamFaceZone> faceZones = {};
  std::optional<FoamAddressing> addressing = {};
  std::vector<BoxLevel> boxLevels = {}; // of each cell; empty: unknown
};

// `faces`: boundary faces in order of the patches. Throws Error (BadMesh): more than 2^31 - 1 corners.
FoamMesh foamMesh(std::vector<double> points, const CellFaces& cells, FaceList faces,
  std::vector<FoamPatch> patches, Execution& execution);

// Which piece of a case; by default the mesh is whole.
struct FoamPlace
{
  int piece = 0;
  int pieces = 1;
};

// Writes meshes of a case: that of `folder`/constant/polyMesh, or one for each region, constant/<region>/polyMesh. A
// piece's are in `folder`/processor0, processor1, ... instead; the list of regions stays in `folder`. Each has
// points, faces, owner, neighbour, boundary and, if it has them, cellZones, faceZones, pointProcAddressing,
// faceProcAddressing, cellProcAddressing, boundaryProcAddressing; if solvers can refine cells of it, cellLevel, pointLevel
// and level0Edge (RefinementLevels.h); beside them are the files system/controlDict,
// fvSchemes, fvSolution and, of pieces, decomposeParDict that checkMesh needs, if they are missing.
//
// If this class wrote an existing polyMesh for patches of the same names, that is replaced once all the new
// ones are complete. The entries of its patches, which the user may have edited, are kept except for the
// numbers of faces. Anything else in the folder (zones and sets, which do not fit the new mesh), and all of
// any other polyMesh, is renamed to polyMesh.old (polyMesh.old2, ...).
//
// All methods throw Error (CannotWrite).
class PolyMeshFiles
{
public:
  PolyMeshFiles(std::filesystem::path folder, FoamFormat format, FoamPlace place = {});
  PolyMeshFiles(PolyMeshFiles&&) = default;
  PolyMeshFiles& operator=(PolyMeshFiles&&) = delete;

  // Removes what was written and not put in its place, and the folders within the case that are empty then.
  ~PolyMeshFiles();

  // `region`: an OpenFOAM word; empty: the case has one mesh. Writes beside what is there.
  void write(const FoamMesh& mesh, const std::string& region, Execution& execution);

  // Moves everything written into place. Of regions, writes constant/regionProperties too, where each is fluid or
  // solid as its name begins, else fluid if flow passes through it (isFluid), as chtMultiRegionFoam requires; one
  // that names all regions is kept, any other is renamed. Returns what was renamed.
  std::vector<std::filesystem::path> replace();

  // What was written so far, in its place or not, for SolverSetup.h.
  std::vector<MeshOfCase> meshes() const;

private:
  struct Written
  {
    std::filesystem::path polyMesh;
    bool replaces; // a mesh that we wrote, of the same patches
    std::string region;
    std::vector<FoamPatch> patches; // each with its type
    std::vector<ZoneOfMesh> zones;
  };

  void writeSystemOf(const std::string& region) const;
  void writeRegionProperties(std::vector<std::filesystem::path>& kept) const;

  std::filesystem::path case_;
  std::filesystem::path folder_;
  FoamFormat format_;
  FoamPlace place_;
  std::vector<Written> written_;
};

std::filesystem::path folderOfProcess(const std::filesystem::path& folder, int process);

// Creates the empty file with which ParaView opens a case, if it does not exist. Throws Error
// (CannotWrite).
void createMarker(const std::filesystem::path& path);

}

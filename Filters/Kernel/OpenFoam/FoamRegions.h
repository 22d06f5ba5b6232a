// SPDX-License-Identifier: BSD-3-Clause
// One mesh as a mesh for each region, as OpenFOAM's solvers for several regions need it; or as one of several
// regions, with zones.
#pragma once

#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

// The regions of the cells of a mesh.
struct FoamRegions
{
  std::vector<std::string> names;         // different OpenFOAM words
  std::vector<std::uint32_t> ofCell;      // index of names
  std::vector<std::uint32_t> beyond = {}; // those of cells behind patches between processes
  bool areZones = false;                  // of one fluid, which flows from one into the other
};

// What lies between a zone and the rest of its mesh.
enum class ZoneBorder
{
  Faces, // inner faces, in a faceZone
  Pair   // two patches of type cyclicAMI with separate points: one side may move
};

// Which regions are zones of which mesh.
struct FoamZoning
{
  std::vector<std::uint32_t> meshOf; // of each region: the first region of the mesh that it is in
  std::vector<bool> isZone;          // of each region: its cells are a cellZone
  ZoneBorder border = ZoneBorder::Faces;
};

// Each region a separate mesh.
FoamZoning separateMeshes(const FoamRegions& regions);

// All regions are zones of one mesh.
FoamZoning allZones(const FoamRegions& regions);

// The regions of these names (foamWord) are zones of the first other region in order that they touch, or that the
// zones touch which they touch. Throws Error (BadParameter): no such region, or one that touches none of the others.
FoamZoning zonesOfNames(
  const FoamMesh& whole, const FoamRegions& regions, const std::vector<std::string>& names);

// The mesh whose first region is this. Cells, faces and points keep their order. Faces between it and another one are
// the patch <region>_to_<other>, after the others, in the order that the other's patch has too; they sample each other.
// Borders of zones have such names too.
// Of a piece with addressing (FoamPieces.h): that part of it, with the same addressing, and all patches that the mesh
// could have. There is no ZoneBorder::Pair.
FoamMesh meshOfRegion(const FoamMesh& whole, const FoamRegions& regions, const FoamZoning& zoning,
  std::uint32_t region);

}

// SPDX-License-Identifier: BSD-3-Clause
// Each region of a mesh in pieces as a separate mesh in pieces: what decomposePar would make of the results of
// meshOfRegion for the whole (FoamRegions.h).
//
//   CompletePiece --labelsOfRegions--> RegionLabels, those of all pieces joined by `add`
//   CompletePiece, RegionLabels --pieceOfRegion--> FoamMesh
#pragma once

#include "OpenFoam/FoamPieces.h"
#include "OpenFoam/LabelRuns.h"

namespace cartesian
{

// What a region has of the whole mesh, by its numbers there.
struct RegionLabels
{
  LabelRuns cells;
  LabelRuns points;
  LabelRuns innerFaces;
  std::vector<LabelRuns> patches; // the faces of each: boundaries, then interfaces

  void add(const RegionLabels& ofOtherPiece);
};

// Of each region.
std::vector<RegionLabels> labelsOfRegions(const CompletePiece& piece);

// The same as numbers that processes can exchange, and back.
std::vector<double> toNumbers(const std::vector<RegionLabels>& regions);
std::vector<RegionLabels> regionLabels(const std::vector<double>& numbers);

// The region's cells of a piece, which may be none, with the addressing of the region's mesh. `ofAll`: of all pieces.
FoamMesh pieceOfRegion(const CompletePiece& piece, std::uint32_t region, const RegionLabels& ofAll);

}

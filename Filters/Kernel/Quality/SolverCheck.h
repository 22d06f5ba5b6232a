// SPDX-License-Identifier: BSD-3-Clause
// What OpenFOAM's checkMesh (1912), without options, finds in the mesh of each region: counted as it does, on the faces
// that it sees, where those between two regions, and those of baffles, are boundary faces of both their cells.
//
// Method and limits of failure are those of OpenFOAM's primitiveMeshCheck, written anew (centres by triangles around the mean of the
// corners, as it has them). TestQualityAgainstFoam and TestTold compare the two, cell by cell.
// Limits: what checkMesh only finds with -allGeometry or -allTopology, such as concave cells, warped faces or small determinants, is
// in QualityMeasures.h; other solvers have other limits.
#pragma once

#include "Quality/QualityMeasures.h"

namespace cartesian
{

enum Finding : std::uint32_t
{
  SkewFaces,
  InvertedFaces,
  NonOrthogonalFaces,
  FacesWithoutArea,
  OpenCells,
  CellsWithoutVolume,
  LongCells,
  CellsOfFewFaces,
  SteepFaces, // no failure, like what follows
  LongLayers, // checkMesh counts them among long cells
  FindingCount
};

struct FindingSpec
{
  const char* name; // of the field data array
  const char* one;
  const char* several;
  bool isFailure;
};

constexpr std::array<FindingSpec, FindingCount> FindingSpecs{ {
  { "SkewFaces", "face has a skewness above 4", "faces have a skewness above 4", true },
  { "InvertedFaces", "face is inverted", "faces are inverted", true },
  { "NonOrthogonalFaces", "face has a non-orthogonality of 90 degrees or more",
    "faces have a non-orthogonality of 90 degrees or more", true },
  { "FacesWithoutArea", "face has no area", "faces have no area", true },
  { "OpenCells", "cell is not closed", "cells are not closed", true },
  { "CellsWithoutVolume", "cell has no volume", "cells have no volume", true },
  { "LongCells", "cell has an aspect ratio above 1000", "cells have an aspect ratio above 1000",
    true },
  { "CellsOfFewFaces", "cell has fewer than four faces", "cells have fewer than four faces", true },
  { "SteepFaces", "face has a non-orthogonality above 70 degrees",
    "faces have a non-orthogonality above 70 degrees", false },
  { "LongLayers", "cell of the layers has an aspect ratio above 1000, which does no harm",
    "cells of the layers have an aspect ratio above 1000, which does no harm", false },
} };

using Findings = std::array<std::size_t, FindingCount>;

// Of those that are failures.
std::size_t failuresIn(const Findings& findings);

struct SolverCheck
{
  std::vector<Findings> ofRegions;
  std::vector<std::uint32_t> failing; // cells, in order: themselves, or with a face that fails

  // Of the faces that are looked at, the worst.
  double skewness = 0;
  double nonOrthogonality = 0; // degrees
};

// What is looked at.
struct CheckedCells
{
  std::vector<std::uint32_t> regionOf; // of each cell, from 0
  std::vector<unsigned char>
    isElsewhere{}; // ghosts: counted by others, with the faces that they own; or none
  std::vector<unsigned char> isLayer{}; // prisms, which are good at any aspect ratio; or none
};

// `faces`: of `cells`, those between regions opened (openFaces). `isSeen`: of each boundary face; those with cells beyond
// that are not here are not.
SolverCheck checkForSolver(const double* points, const CellFaces& cells, const FaceList& faces,
  const CheckedCells& checked, const std::vector<bool>& isSeen, Execution& execution);

}

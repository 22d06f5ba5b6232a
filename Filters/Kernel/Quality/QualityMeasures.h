// SPDX-License-Identifier: BSD-3-Clause
// How good a mesh is for finite-volume solvers: the conditions of section 3, and what OpenFOAM 1912
// checks (checkMesh), with its definitions and limits.
#pragma once

#include "Polyhedra/CellGeometry.h"
#include "Quality/FaceList.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>

namespace cartesian
{

enum Measure : std::uint32_t
{
  Volume,
  Openness,
  OpenEdges,
  BoundaryAngle,
  InnerAngle,
  StarTriangulation,
  NonOrthogonality,
  Skewness,
  FaceWeight,
  VolumeRatio,
  Determinant,
  AspectRatio,
  TetQuality,
  Concavity,
  MeasureCount
};

struct MeasureSpec
{
  const char* name;
  bool ofFaces;      // measured on faces: a cell's value is the worst of its faces'
  bool largeIsWorse; // else small
  double limit;      // fails from here on
  double best;       // of what has nothing to measure, such as the non-orthogonality of boundaries
};

constexpr double NoLimit = std::numeric_limits<double>::infinity();

// The n-th measure's failure is bit n of Failures.
constexpr std::array<MeasureSpec, MeasureCount> MeasureSpecs{ {
  // user units cubed
  { "Volume", false, false, 0, NoLimit },
  // the sum of the face vectors (equation 2), the worst of x, y, z, by the sum of their sizes
  { "Openness", false, true, 1e-6, 0 },
  // edges that the cell's faces do not run through as often one way as the other
  { "OpenEdges", false, true, 1, 0 },
  // section 3: cell centre to face centre against the outward normal, degrees
  { "BoundaryAngle", true, true, 90, 0 },
  { "InnerAngle", true, true, 75, 0 },
  // section 3: the smallest triangle of the star about the mean of the corners by the mean one
  { "StarTriangulation", true, false, -1e-6, 1 },
  // from cell centre to cell centre against the normal, degrees
  { "NonOrthogonality", true, true, 70, 0 },
  // how far that line misses the face's centre, by the face's size in this direction
  { "Skewness", true, true, 4, 0 },
  // the smaller of both centres' distances from the face's plane by their sum
  { "FaceWeight", true, false, 0.05, 1 },
  // the smaller volume of both cells by the larger
  { "VolumeRatio", true, false, 0.01, 1 },
  // of the sum of n n^T over inner faces of mean area 1, by that of a cube
  { "Determinant", false, false, 1e-3, NoLimit },
  // areas across the axes, the largest by the smallest, or a sixth of all by volume^(2/3)
  { "AspectRatio", false, true, 1000, 0 },
  // of an edge, the face's centre and the cell's: volume by that of the regular one in its sphere
  { "TetQuality", true, false, 1e-30, 1 },
  // the most concave edge: by how much more than 180 degrees lie inside
  { "Concavity", false, true, NoLimit, 0 },
} };

// Cells whose Concavity is below count as convex, degrees: neighbouring facets of a smooth surface,
// and sub-faces of one plane.
constexpr double ConcaveFrom = 1;

// Whether a value is at or beyond its measure's limit, or no number.
constexpr bool fails(Measure measure, double value)
{
  const MeasureSpec& spec = MeasureSpecs[measure];
  return spec.largeIsWorse ? !(value < spec.limit) && spec.limit != NoLimit : !(value > spec.limit);
}

struct Quality
{
  // By measure. Faces have those that are `ofFaces`, of two cells the worse one. Cells without
  // faces have NaN and no failures.
  std::array<std::vector<double>, MeasureCount> cells;
  std::array<std::vector<double>, MeasureCount> faces;
  std::vector<std::uint32_t> cellFailures; // bits: 1 << measure
  std::vector<std::uint32_t> faceFailures; // in the order of the FaceList
  std::vector<CellGeometry> cellGeometry;
  std::vector<FaceGeometry> faceGeometry;
};

// `points`: x, y, z of each, any unit. `faces`: those of `cells`, as listFaces gives them.
Quality measureQuality(
  const double* points, const CellFaces& cells, const FaceList& faces, Execution& execution);

// One of the numbers that sum up a mesh; of a mesh in pieces, its pieces' values put together.
struct SummaryValue
{
  enum class Of
  {
    Sum,
    Least,
    Most,
  };
  std::string name;
  double value;
  Of pieces;
};

// Cells, FailingCells, ConcaveCells, TotalVolume, BoundaryArea, and for each measure <Name>Failures,
// a number of cells, and Max<Name> or Min<Name>, the worst of all cells. Cells that are `leftOut`
// (an array of as many flags, or null) do not count.
std::vector<SummaryValue> summarise(
  const Quality& quality, const FaceList& faces, const unsigned char* leftOut = nullptr);

}

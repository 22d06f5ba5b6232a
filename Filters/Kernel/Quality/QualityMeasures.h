// SPDX-License-Identifier: BSD-3-Clause
// The quality of a mesh for finite-volume solvers: the conditions of section 3, and those of checkMesh (OpenFOAM 1912),
// with its definitions and limits.
#pragma once

#include "Base/RawVector.h"
#include "Polyhedra/CellGeometry.h"
#include "Quality/FaceList.h"
#include "Quality/Limits.h"

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
  bool ofFaces;      // measured on faces: the value of a cell is the worst of its faces'
  bool largeIsWorse; // else small values are worse
  double limit;      // values at or beyond it fail
  double best;       // used where nothing can be measured: boundary faces have no non-orthogonality
};

constexpr double NoLimit = std::numeric_limits<double>::infinity();

// Bit n of Failures is set if the n-th measure fails.
constexpr std::array<MeasureSpec, MeasureCount> MeasureSpecs{ {
  // user units cubed
  { "Volume", false, false, 0, NoLimit },
  // sum of the face vectors (equation 2) divided by the sum of their sizes, the worst of x, y, z
  { "Openness", false, true, Limits::Openness, 0 },
  // number of edges that the faces of the cell do not run through equally often in both directions
  { "OpenEdges", false, true, 1, 0 },
  // section 3: angle from the outward normal to the line from cell centre to face centre, degrees
  { "BoundaryAngle", true, true, Limits::BoundaryAngle, 0 },
  { "InnerAngle", true, true, Limits::InnerAngle, 0 },
  // section 3: smallest triangle of the star about the mean of the corners, divided by the mean one
  { "StarTriangulation", true, false, Limits::StarTriangulation, 1 },
  // angle from the normal to the line between the cell centres, degrees
  { "NonOrthogonality", true, true, Limits::NonOrthogonality, 0 },
  // distance of that line from the face centre, divided by the size of the face in this direction
  { "Skewness", true, true, Limits::Skewness, 0 },
  // the smaller distance of the two cell centres from the plane of the face, divided by their sum
  { "FaceWeight", true, false, Limits::FaceWeight, 1 },
  // the smaller volume of the two cells divided by the larger
  { "VolumeRatio", true, false, Limits::VolumeRatio, 1 },
  // of the sum of n n^T over inner faces scaled to mean area 1, divided by that of a cube
  { "Determinant", false, false, Limits::Determinant, NoLimit },
  // largest area across an axis divided by the smallest, or a sixth of all area by volume^(2/3)
  { "AspectRatio", false, true, Limits::AspectRatio, 0 },
  // tetrahedra of an edge, face centre and cell centre: volume by that of the regular one in its sphere
  { "TetQuality", true, false, Limits::TetQuality, 1 },
  // of the most concave edge: its inner angle beyond 180 degrees
  { "Concavity", false, true, NoLimit, 0 },
} };

// Degrees. Cells with less Concavity count as convex, such as those with neighbouring facets of a smooth
// surface, or with several coplanar faces.
constexpr double ConcaveFrom = 1;

// By measure: MeasureSpec::limit, or the user's.
using QualityLimits = std::array<double, MeasureCount>;

constexpr QualityLimits standardLimits()
{
  QualityLimits limits{};
  for (std::size_t m = 0; m < MeasureCount; ++m)
  {
    limits[m] = MeasureSpecs[m].limit;
  }
  return limits;
}

// Whether a value is at or beyond its measure's limit, or is NaN.
constexpr bool fails(Measure measure, double value, const QualityLimits& limits = standardLimits())
{
  const double limit = limits[measure];
  return MeasureSpecs[measure].largeIsWorse ? !(value < limit) && limit != NoLimit
                                            : !(value > limit);
}

struct Quality
{
  // By measure. Faces have the measures that are `ofFaces`, with the worse value of their two cells. Cells
  // without faces have NaN and no failures.
  std::array<RawVector<double>, MeasureCount> cells;
  std::array<RawVector<double>, MeasureCount> faces;
  std::vector<std::uint32_t> cellFailures; // bits: 1 << measure
  std::vector<std::uint32_t> faceFailures; // in the order of the FaceList
  RawVector<CellGeometry> cellGeometry;
  RawVector<FaceGeometry> faceGeometry;
};

// The measures of tetrahedra, stars and edges, which take longest.
constexpr std::uint32_t SlowMeasures =
  1U << TetQuality | 1U << StarTriangulation | 1U << OpenEdges | 1U << Concavity;

// Thin prisms of layers are good cells, though they are long, their inner faces are nearly all in one direction, and a wall that
// is not flat tilts these as far as their pyramids have a volume.
constexpr bool isGoodInLayers(Measure measure, double value)
{
  return measure == AspectRatio || measure == Determinant ||
    (measure == InnerAngle && value < LayerLimits::InnerAngle);
}

// `points`: x, y, z of each, any unit. `faces`: those of `cells`, as listFaces gives them. `leftOut`: bits of
// SlowMeasures, whose values are the best then.
Quality measureQuality(const double* points, const CellFaces& cells, const FaceList& faces,
  Execution& execution, const QualityLimits& limits = standardLimits(), std::uint32_t leftOut = 0);

// One of the numbers that sum up a mesh, and how those of its pieces combine.
struct SummaryValue
{
  enum class Reduction
  {
    Sum,
    Minimum,
    Maximum,
  };
  std::string name;
  double value;
  Reduction reduction;
};

// Cells, FailingCells, ConcaveCells, TotalVolume, BoundaryArea, and for each measure <Name>Failures (a number
// of cells) and Max<Name> or Min<Name> (the worst value of all cells). Cells with a flag in `leftOut` (which
// may be null) do not count.
std::vector<SummaryValue> summarise(
  const Quality& quality, const FaceList& faces, const unsigned char* leftOut = nullptr);

}

// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with a surface, and where (step 4): for the user to look at.
#pragma once

#include "Lattice/Vector.h"
#include "Repair/SurfaceRepair.h"

namespace cartesian
{

// Codes are public: cell array DefectKind of the filters' Defects output.
enum class DefectKind
{
  OpenEdge = 1,           // of an odd number of triangles; line
  NonManifoldEdge = 2,    // of four triangles or more; line
  InconsistentEdge = 3,   // its triangles cannot face one way (a Moebius band); line
  DegenerateTriangle = 4, // without area; line around it
  DuplicateTriangle = 5,  // there before, left out of the mesh; triangle
  FoldedTriangle = 6,     // lies back on a neighbour, within FoldAngle; triangle
  OverlappedTriangle = 7, // shares an area with one in the same plane; triangle
  Intersection = 8,       // two triangles cross; the line they share
  SmallComponent = 9,     // smaller than a box in all directions; triangles
  Hole = 10,              // narrower than a box, closed; line around it
  Leak = 11,              // a hole as wide as a box or wider, closed by a lid; line around it
};
constexpr std::size_t DefectKinds = 12;

// Two triangles closer than this, in degrees, are a fold.
constexpr double FoldAngle = 1;

struct Defect
{
  DefectKind kind;
  std::uint32_t triangle; // of those given, or None
  std::uint32_t other;    // the second of a pair, or None
  std::uint32_t size;     // points
  bool polygon;           // else a line
};

struct SurfaceDefects
{
  static constexpr std::uint32_t None = ~0u;

  // Beyond so many of a kind, defects are counted and not listed.
  static constexpr std::size_t MostListed = 1000000;

  std::vector<Defect> defects;                   // by kind, then in order of vertices or triangles
  std::vector<Vector> points;                    // of one defect after the other, user units
  std::array<std::size_t, DefectKinds> counts{}; // by kind
  std::size_t components = 0;                    // what hangs together by vertices
  std::size_t notCompared = 0; // triangles with too many neighbours to look for intersections
};

// `surface` as repaired; the first `given` triangles are the user's. Planes as for closeHoles.
SurfaceDefects findDefects(const Surface& surface, std::size_t given, const SurfaceRepair& repair,
  const Meshlines& planes, Execution& execution);

// Folds, overlaps and intersections in words, or nothing: what describeFlaws (Messages.h) does not tell
// and a mesh may suffer from.
std::string describe(const SurfaceDefects& defects);

}

// SPDX-License-Identifier: BSD-3-Clause
// Lists the defects of a surface, with places, for the user to inspect (step 4).
#pragma once

#include "Lattice/Vector.h"
#include "Repair/Contacts.h"
#include "Repair/Cracks.h"
#include "Repair/SurfaceRepair.h"

namespace cartesian
{

// The codes are public: they are the cell array DefectKind of the filters' Defects output.
enum class DefectKind
{
  OpenEdge = 1,           // used by an odd number of triangles; line
  NonManifoldEdge = 2,    // used by four triangles or more; line
  InconsistentEdge = 3,   // its triangles cannot be oriented consistently (a Moebius band); line
  DegenerateTriangle = 4, // has no area; line around it
  DuplicateTriangle = 5,  // repeats an earlier one and is left out of the mesh; triangle
  FoldedTriangle = 6,     // folded back onto a neighbour, within FoldAngle; triangle
  OverlappedTriangle = 7, // overlaps another one in the same plane; triangle
  Intersection = 8,       // of two triangles; the line they share
  SmallComponent = 9,     // smaller than a box in all directions; triangles
  Hole = 10,              // narrower than a box, closed; line around it
  Leak = 11,              // a hole at least as wide as a box, closed; line around it
  ClosedContact =
    12,             // faced another region's wall within the tolerance, and is that now; triangles
  CellLeftOut = 13, // of the mesh, not of the surface (Assembly.h); the sides of its box
  FailingCell = 14, // of the mesh, as solvers reject it (SolverCheck.h); its faces
  LayersEndInGap =
    15, // a wall face without a whole stack of layers (LayeredWall.h): something lies opposite
  LayersEndAtCorner = 16, // ... the wall leaves no way inwards
  LayersEndAtFault = 17,  // ... a cell or face would fail there, or at the stack beside it
  JoinedCrack = 18, // an open edge that ran along others and is joined with them (Cracks.h); line
  ClosedGap = 19,   // a hole that was closed as asked (ClosedGaps.h); line around it
  LeakPath = 20,    // of the mesh: the way to a point to keep out (LeakPath.h); line along it
  LeakGap = 21,     // ... a gap that it passes; line across
};
constexpr std::size_t DefectKinds = 22; // from 1

// Two triangles with a smaller angle between them, in degrees, are a fold.
constexpr double FoldAngle = 1;

struct Defect
{
  DefectKind kind;
  std::uint32_t triangle; // one of the given, or None
  std::uint32_t other;    // the second one of a pair, or None
  std::uint32_t size;     // number of points
  bool polygon;           // otherwise a line
  double width = 0;       // of what was closed or joined, user units
};

struct SurfaceDefects
{
  static constexpr std::uint32_t None = ~0u;

  // Further defects of a kind are counted but not listed.
  static constexpr std::size_t MostListed = 1000000;

  std::vector<Defect> defects;                   // by kind, then in order of vertices or triangles
  std::vector<Vector> points;                    // of all defects in turn, user units
  std::array<std::size_t, DefectKinds> counts{}; // by kind
  std::size_t components = 0;                    // connected by vertices
  std::size_t notCompared = 0; // triangles with too many neighbours to be checked for intersections
  Vector notComparedAt{};      // the first of them
};

// Of the repaired surface, whose first `given` triangles are the user's.
SurfaceDefects findDefects(const Surface& surface, std::size_t given, const SurfaceRepair& repair,
  const JoinedCracks& cracks, const Meshlines& planes, Execution& execution);

// The triangles that later regions lost, by their numbers in the view.
SurfaceDefects listContacts(const std::vector<ClosedContact>& contacts, const Lattice& lattice);

// Adds a gap to the defects, of which no kind may follow; user units.
void addClosedGap(const std::vector<Vector>& rim, double width, SurfaceDefects& defects);

// A message about folds, overlaps and intersections, which may degrade a mesh and which describeFlaws
// (Messages.h) does not mention, with the first places of each; empty if there are none. `cells`: the user's number
// of each triangle.
std::string describe(const SurfaceDefects& defects, const std::vector<long long>& cells);

}

// What section 3 of the paper and OpenFOAM's checkMesh demand of cells, counted.
#pragma once

#include "Polyhedra/Polyhedron.h"

#include <array>

namespace cartesian
{

// Solvers take no cell with fewer.
constexpr std::size_t LeastFaces = 4;

// The cell on the other side of an inner face.
struct Beyond
{
  Vector centre{};   // from the same origin
  double volume = 0; // 0: there is none
};

struct Fitness
{
  enum Fault
  {
    BoundaryAngle, // 90 degrees (section 3), or nearly, between a boundary face's normal and the way to it
    InnerAngle,     // 75, or nearly, seen from either cell
    Wrong,          // ... 90 or more, or its normal points away from the way between the centres
    Steep,          // an inner face more than 70 degrees off the line between the centres
    BoundarySkewed, // a boundary face's skewness over 4
    InnerSkewed,    // an inner face's
    Uneven,         // one of the two cells is smaller than a hundredth of the other
    Lopsided,       // ... or its centre 20 times nearer to the face
    Faults
  };

  std::array<int, Faults> faults{};
  double area = 0; // of the faces with a wrong angle or skewness

  int count() const;

  // Faults weighed by how hard they are to mend later.
  int weight() const;
  Fitness& operator+=(const Fitness& other);

  // In none of the kinds that checkMesh refuses: wrong angles and skewness.
  bool isNoLessValidThan(const Fitness& other) const;

  // In no kind.
  bool isNoWorseThan(const Fitness& other) const;

  // In no kind worse, and fewer faults, or the same on less area.
  bool isBetterThan(const Fitness& other) const;
};

// Faults of a cell's faces; beyond[f] belongs to face f. `counts`: of each face, 0 where another cell
// counts it; empty: all count.
Fitness fitnessOf(const Polyhedron& cell, const CellShape& shape, const std::vector<Beyond>& beyond,
  const std::vector<std::uint8_t>& counts = {});

// Whether a face breaks a rule of section 3, or checkMesh refuses it.
bool isRefused(
  const Polyhedron& cell, const CellShape& shape, std::size_t face, const Beyond& beyond);

// Whether a face that is steep, though not refused, would be by the centres of measureProjected.
bool isDoubtful(const Polyhedron& cell, const CellShape& shape, std::size_t face);

// How a cell's centre lies to a face, in levels.
struct FaceSight
{
  float height; // of the face's plane, outwards
  float aside;  // from the centre's foot in that plane to the face's centre
};

// `area`: outwards of the cell.
FaceSight sightOf(const Vector& centre, const Vector& faceCentre, const Vector& area);

// Whether an inner face seen so from its two cells is neither refused nor doubtful, surely: the line
// between the centres meets the face's plane between the two feet.
bool isSurelyAccepted(const FaceSight& one, const FaceSight& other);

// Whether a cell of which no face is at fault has enough, and no boundary face that is doubtful.
bool isPlain(const Polyhedron& cell, const CellShape& shape);

// Whether a face is at fault that no look at other cells is needed for.
bool isAtFault(const Polyhedron& cell, const CellShape& shape, std::size_t face);
bool isAnyAtFault(const Polyhedron& cell, const CellShape& shape);

}

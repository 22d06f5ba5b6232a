// SPDX-License-Identifier: BSD-3-Clause
// What section 3 of the paper and OpenFOAM's checkMesh demand of cells, counted.
#pragma once

#include "Polyhedra/Polyhedron.h"

#include <array>

namespace cartesian
{

// Solvers take no cell with fewer.
constexpr std::size_t LeastFaces = 4;

// The cell on the other side of an inner face.
struct NeighbourCell
{
  Vector centre{};   // from the same origin
  double volume = 0; // 0: there is none
};

// The faults of one cell or more, by kind: the fewer the better.
struct CellFaults
{
  enum Kind
  {
    BoundaryAngle, // section 3: 90 degrees, or nearly, between a boundary face's normal and the way to it
    InnerAngle,      // section 3: 75, or nearly, at an inner face, seen from either cell
    WronglyOriented, // ... 90 or more, or its normal points against the line between the centres
    NonOrthogonal, // an inner face's normal is more than 70 degrees off the line between the centres
    BoundarySkewness, // of a boundary face: over 4
    InnerSkewness,    // of an inner face: over 4
    VolumeRatio, // the smaller of the two cells has less than a hundredth of the other's volume
    FaceWeight,  // ... or its centre is 20 times nearer to the face
    Kinds
  };

  std::array<int, Kinds> counts{};
  double area = 0; // of the faces with a wrong angle or skewness

  int count() const;

  // The count, with each kind weighted by how hard it is to repair later.
  int weight() const;
  CellFaults& operator+=(const CellFaults& other);

  // No more faults of any kind that checkMesh refuses: wrong angles and skewness.
  bool isNoLessValidThan(const CellFaults& other) const;

  // No more faults of any kind.
  bool isNoWorseThan(const CellFaults& other) const;

  // ... and fewer in all, or as many on less area.
  bool isBetterThan(const CellFaults& other) const;
};

// Counts the faults of a cell's faces; neighbours[f] lies across face f. Faces whose `counted` is 0 are left out
// (another cell counts them); if it is empty, all count.
CellFaults faultsOf(const Polyhedron& cell, const CellShape& shape,
  const std::vector<NeighbourCell>& neighbours, const std::vector<std::uint8_t>& counted = {});

// Whether a face breaks a rule of section 3, or checkMesh refuses it.
bool isRefused(
  const Polyhedron& cell, const CellShape& shape, std::size_t face, const NeighbourCell& neighbour);

// Whether a face that is steep, though not refused, would be by the centres of measureProjected.
bool isDoubtful(const Polyhedron& cell, const CellShape& shape, std::size_t face);

// How a cell's centre lies to a face, in levels.
struct CentreOffset
{
  float height; // of the face's plane, outwards
  float aside;  // from the centre's foot in that plane to the face's centre
};

// `area`: outwards of the cell.
CentreOffset centreOffsetOf(const Vector& centre, const Vector& faceCentre, const Vector& area);

// Whether an inner face seen so from its two cells is neither refused nor doubtful, surely: the line
// between the centres meets the face's plane between the two feet.
bool isSurelyAccepted(const CentreOffset& one, const CentreOffset& other);

// Whether a cell of which no face is at fault has enough, and no boundary face that is doubtful.
bool isPlain(const Polyhedron& cell, const CellShape& shape);

// Whether a face is at fault that no look at other cells is needed for.
bool isAtFault(const Polyhedron& cell, const CellShape& shape, std::size_t face);
bool isAnyAtFault(const Polyhedron& cell, const CellShape& shape);

}

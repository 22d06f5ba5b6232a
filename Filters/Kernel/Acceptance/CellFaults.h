// SPDX-License-Identifier: BSD-3-Clause
// Counts the faults of cells: violations of section 3 of the paper and of OpenFOAM's checkMesh.
#pragma once

#include "Polyhedra/Polyhedron.h"

#include <array>

namespace cartesian
{

// Cells with fewer faces fail.
constexpr std::size_t LeastFaces = 4;

// The cell on the other side of an inner face.
struct NeighbourCell
{
  Vector centre{};   // relative to the same origin
  double volume = 0; // 0: there is no such cell
};

// The faults of one cell or more, by kind: the fewer the better.
struct CellFaults
{
  enum Kind
  {
    BoundaryAngle,    // section 3: a boundary face's angle is 90 degrees or nearly
    InnerAngle,       // section 3: an inner face's is 75 or nearly, from either cell
    WronglyOriented,  // ... 90 or more, or its normal points against the line of centres
    NonOrthogonal,    // an inner face's normal is over 70 degrees off the line of centres
    BoundarySkewness, // of a boundary face: over 4
    InnerSkewness,    // of an inner face: over 4
    VolumeRatio,      // one of the two cells has less than a hundredth of the other's volume
    FaceWeight,       // ... or its centre is 20 times nearer to the face
    Kinds
  };

  std::array<int, Kinds> counts{};
  double area = 0; // of the faces with a wrong angle or skewness

  // Their number, with each kind weighted by how hard it is to repair later.
  int weight() const;
  CellFaults& operator+=(const CellFaults& other);

  // Only those that checkMesh reports: wrong angles and skewness.
  CellFaults invalid() const;
};

// Whether checkMesh fails the mesh, not merely warns about it.
inline bool failsCheckMesh(const CellFaults& faults)
{
  return faults.counts[CellFaults::WronglyOriented] + faults.counts[CellFaults::BoundarySkewness] +
    faults.counts[CellFaults::InnerSkewness] >
    0;
}

// Counts the faults of a cell's faces; neighbours[f] lies across face f. Faces whose `counted` is 0
// are left out (another cell counts them); if it is empty, all count.
CellFaults faultsOf(const Polyhedron& cell, const CellShape& shape,
  const std::vector<NeighbourCell>& neighbours, const std::vector<std::uint8_t>& counted = {});

// Whether a face violates section 3 or checkMesh, with the centres of `shape`.
bool isRefused(
  const Polyhedron& cell, const CellShape& shape, std::size_t face, const NeighbourCell& neighbour);

// Whether the centres, or the volumes, of an inner face's two cells are so unequal that solvers are strained.
bool isUnbalanced(const CellShape& shape, std::size_t face, const NeighbourCell& neighbour);

// Whether it is inverted as seen from one of its cells: then that cell is invalid, not merely poor.
bool isTurnedOver(const CellShape& shape, std::size_t face, const NeighbourCell& neighbour);

// Which faces of a cell fail with either of the two centres that solvers compute.
struct Refusal
{
  bool isRefused(std::size_t face);

  const Polyhedron& cell;
  const CellShape& shape;
  const std::vector<NeighbourCell>& beyond; // of each face
  CellShape projected{};                    // with the other centres, once asked for
};

// Where a cell's centre lies relative to a face, in levels.
struct CentreOffset
{
  float height; // distance to the face's plane, positive inside
  float aside;  // distance within that plane from the centre's projection to the face's centre
};

// `area`: the face's, out of the cell.
CentreOffset centreOffsetOf(const Vector& centre, const Vector& faceCentre, const Vector& area);

// Sufficient for an inner face to be neither failing nor doubtful, given the centres of its two cells: the line
// between the centres meets the face's plane between their projections.
bool isSurelyAccepted(const CentreOffset& one, const CentreOffset& other);

// Whether an inner face seen so from its two cells costs little, surely (CellCost.h): no weight below a
// seventh, and the centres near to the face's own normal.
bool isSurelyGood(const CentreOffset& one, const CentreOffset& other);

// Whether a cell without faces at fault has enough faces, and no doubtful boundary face.
bool isPlain(const Polyhedron& cell, const CellShape& shape);

// Whether a face is at fault, as far as that is known without the cell on its other side.
bool isAtFault(const Polyhedron& cell, const CellShape& shape, std::size_t face);
bool isAnyAtFault(const Polyhedron& cell, const CellShape& shape);

}

// SPDX-License-Identifier: BSD-3-Clause
// The quality of a cell for finite-volume solvers, as one number that shaping minimises.
//
// Every term is 1 or less within preferred quality limits and grows steeply beyond, so that the worst term dominates
// the sum: skewness, non-orthogonality, weight and volume ratio of faces as OpenFOAM's checkMesh defines them, the
// angles of section 3, and the cell's volume by that of its box.
#pragma once

#include "Acceptance/CellFaults.h"

namespace cartesian
{

// Of one face; 1e3 and more where an angle condition of section 3 fails or is about to.
double costOfFace(
  const Polyhedron& cell, const CellShape& shape, std::size_t face, const NeighbourCell& beyond);

// Faces of a smaller area are negligible: they join any neighbour, of another boundary too.
double negligibleArea(const CellShape& shape);

// Extra cost of a negligible face: it is worth repairing.
constexpr double CostOfNegligible = 4;

// Of the cell itself. `share`: its volume as a part of its box's.
double costOfShare(double share);

// Above this a face or a cell is worth repairing.
constexpr double PoorCost = 5;

// Cost of the cell by the directions of its inner faces: high if hardly any of them faces some direction. Pressure
// and velocity along it are dominated by rounding.
double costOfDeterminant(const Polyhedron& cell, const CellShape& shape);

// Whether none of its boundary faces costs more than PoorCost, nor its determinant, and no face is negligible.
bool isEasy(const Polyhedron& cell, const CellShape& shape);

}

// SPDX-License-Identifier: BSD-3-Clause
// How good a cell is for a finite-volume solver, as one number: what shaping makes smaller.
//
// Every term is 1 or less within preferred quality limits and grows steeply beyond, so that the sum is ruled
// by what is worst: skewness, non-orthogonality, weight and volume ratio of faces as OpenFOAM's
// checkMesh defines them, the angles of section 3, and the cell's volume by that of its box.
#pragma once

#include "Acceptance/CellFaults.h"

namespace cartesian
{

// Of one face; 1e3 and more where an angle condition of section 3 fails or is about to.
double costOfFace(
  const Polyhedron& cell, const CellShape& shape, std::size_t face, const NeighbourCell& beyond);

// Faces of a smaller area are negligible: they join any neighbour, of another boundary too.
double negligibleArea(const CellShape& shape);

// What a negligible face costs besides: it is worth mending.
constexpr double CostOfNegligible = 4;

// Of the cell itself. `share`: its volume as a part of its box's.
double costOfShare(double share);

// From here on a face or a cell is worth mending.
constexpr double PoorCost = 5;

// Of the cell as its inner faces lie: high where there is a direction that hardly any of them faces. Pressure
// and velocity along it are at the mercy of rounding there.
double costOfDeterminant(const Polyhedron& cell, const CellShape& shape);

// Whether none of its boundary faces costs more than PoorCost, nor its determinant, and no face is negligible.
bool isEasy(const Polyhedron& cell, const CellShape& shape);

}

// SPDX-License-Identifier: BSD-3-Clause
// Divides polyhedra into tetrahedra and pyramids around their centres, which any program can cut.
//
// Triangles and flat convex quadrilaterals stay whole; every other face becomes a fan of triangles around its centre, the
// same from both of its cells. With OpenFOAM's centres (CellGeometry.h) the parts have the volumes that solvers take.
#pragma once

#include "Sections/FaceFans.h"
#include "Sections/PointSums.h"

namespace cartesian
{

struct CellDivision
{
  FaceFans fans;
  std::vector<Vector> centres;       // of the cells
  std::vector<std::uint8_t> inverts; // of each cell, 1: no point sees all of its faces from inside
  std::size_t moved = 0; // cells that are divided around another point than their centre
};

// `cells`: with corners counter-clockwise from outside. `points`: three coordinates each. The result depends neither on
// threads nor on which of two cells comes first, down to the rounding of sums.
CellDivision divideCells(const CellFaces& cells, const double* points, Execution& execution);

// New points, fans before cells, as sums of given ones.
PointSums sumsOf(
  const CellDivision& division, const CellFaces& cells, const double* points, Execution& execution);

}

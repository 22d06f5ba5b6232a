// SPDX-License-Identifier: BSD-3-Clause
// Divides polyhedra into tetrahedra and pyramids around their centres, which any program can cut.
//
// Triangles and flat convex quadrilaterals stay whole; every other face becomes a fan of triangles around its centre, the
// same from both of its cells. With OpenFOAM's centres (CellGeometry.h) the parts have the volumes that solvers take.
#pragma once

#include "Lattice/Vector.h"
#include "Quality/FaceList.h"

#include <array>

namespace cartesian
{

// How far a quadrilateral may be off its plane to stay whole, relative to its longer diagonal.
constexpr double FlatQuadrilateral = 1e-12;

// Whether it is flat and convex. The same for the same corners from whichever they begin, in either direction: `ids` tell
// them apart.
bool staysWhole(const std::array<Vector, 4>& corners, const std::array<std::uint32_t, 4>& ids);

constexpr std::uint32_t NoPoint = ~std::uint32_t(0);

struct CellDivision
{
  std::vector<std::uint32_t>
    fanOf; // of each face of each cell, the place that its fan is around; or NoPoint: whole
  std::vector<std::uint32_t> centre;     // of each cell, a place
  std::vector<Vector> places;            // of the new points: first of faces, then of cells
  std::vector<std::uint32_t> facePlaces; // a face for each of the first places
  std::vector<std::uint8_t> inverts; // of each cell, 1: no point sees all of its faces from inside
  std::size_t moved = 0; // cells that are divided around another point than their centre
};

// `cells`: with corners counter-clockwise from outside. `points`: three coordinates each. The result depends neither on
// threads nor on which of two cells comes first, down to the rounding of sums.
CellDivision divideCells(const CellFaces& cells, const double* points, Execution& execution);

// New points as sums of given ones, for which linear fields are exact.
struct PointSums
{
  std::vector<std::size_t> first; // term of each new point, and the end
  std::vector<std::uint32_t> point;
  std::vector<double> weight;
};

PointSums sumsOf(
  const CellDivision& division, const CellFaces& cells, const double* points, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// Splitting of inner faces that are too concave (sections 3 and 4.9).
//
// A face must fall into triangles around its centre (the mean of its corners): the star
// triangulation. A polygon that does not is split at its most concave corner along the optimal
// edge (O'Rourke, Computational Geometry in C): the shortest diagonal that leaves no concave
// angle there, or the shortest of all; its parts likewise.
#pragma once

#include "Lattice/Plane.h"

#include <vector>

namespace cartesian
{

// A polygon's corners: node numbers and where they lie, counter-clockwise.
struct FlatPolygon
{
  std::vector<std::uint32_t> nodes;
  std::vector<PlanePoint> at;
};

// Whether the star triangulation has no triangle turned over (by more than rounding).
bool isStar(const std::vector<PlanePoint>& at);

// Joins holes (clockwise) to the polygon around them, each by the shortest edge that it and what is
// joined already can see of each other past the other holes.
void joinHoles(FlatPolygon& polygon, std::vector<FlatPolygon> holes);

// Whether splitting leaves it as it is.
bool isWhole(const FlatPolygon& polygon);

// Appends the polygon in parts with a star triangulation; any polygon ends in a finite number
// of steps, also one that crosses itself.
void splitIntoStars(FlatPolygon polygon, std::vector<FlatPolygon>& parts);

}

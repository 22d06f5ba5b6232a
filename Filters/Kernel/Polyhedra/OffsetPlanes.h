// SPDX-License-Identifier: BSD-3-Clause
// Where the planes around a corner meet when they move inwards: the inner end of the layers at a wall node.
#pragma once

#include "Lattice/Vector.h"

#include <vector>

namespace cartesian
{

// A plane through the corner.
struct Facet
{
  Vector normal;   // inwards, of length 1
  double angle;    // at the corner, in radians: its weight
  double distance; // by which it moves
};

// Adds it to the facets around a corner. Those of about one plane count once, with all their angle and the mean of
// their distances.
void addFacet(std::vector<Facet>& facets, const Facet& added);

// The normals that differ from each other and from their sums, at most three, orthogonal and of length 1. `sine`: of
// the least angle.
std::vector<Vector> independentNormals(const std::vector<Facet>& facets, double sine);

// What is left of a vector within planes of orthogonal normals.
Vector within(const std::vector<Vector>& normals, Vector v);

// From the corner to where the facets' planes meet after each moved by its distance: in the sense of least squares,
// within the planes of `fixed`, and no longer than LongestMitre of the largest distance. Zero if there is none.
constexpr double LongestMitre = 2;
Vector meetingPoint(const std::vector<Facet>& facets, const std::vector<Vector>& fixed);

}

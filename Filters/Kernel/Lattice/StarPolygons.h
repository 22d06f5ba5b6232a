// SPDX-License-Identifier: BSD-3-Clause
// Splits inner faces that are too concave (sections 3 and 4.9).
//
// A face must have a star triangulation: triangles from its centre (the mean of its corners) to
// each edge, none of them inverted. A polygon that has none is split at its most concave corner
// along the optimal diagonal (O'Rourke, Computational Geometry in C): the shortest one that leaves
// no concave angle there, or else the shortest of all. The parts are treated likewise.
#pragma once

#include "Lattice/Plane.h"

#include <vector>

namespace cartesian
{

// A polygon's corners, counter-clockwise: their node numbers and positions.
struct FlatPolygon
{
  std::vector<std::uint32_t> nodes;
  std::vector<PlanePoint> at;
};

// A star triangle that is inverted by less than this part of the polygon's area counts as flat:
// rounding.
constexpr double StarRounding = 1e-9;

// Whether no triangle around the polygon's centre is inverted.
bool isStar(const std::vector<PlanePoint>& at);

// Joins holes (clockwise) to the polygon around them, each by the shortest edge to the polygon, or
// to a hole already joined, that no other hole obstructs.
void joinHoles(FlatPolygon& polygon, std::vector<FlatPolygon> holes);

// Whether splitIntoStars leaves the polygon as it is.
bool isWhole(const FlatPolygon& polygon);

// Appends the polygon in parts that have star triangulations. Terminates for any polygon, even one
// that intersects itself.
void splitIntoStars(FlatPolygon polygon, std::vector<FlatPolygon>& parts);

}

// SPDX-License-Identifier: BSD-3-Clause
// Consistent orientation of the triangles (step 6): afterwards normals point out of the domain.
//
// The rule: shells that do not intersect alternate, however they were oriented: a shell inside a
// shell is a cavity, a shell inside that one is a body again. Bodies that overlap are one body
// (Winding.h), also within a cavity (Nesting.h).
//
// Triangles connected across edges of exactly two triangles form a sheet and get one direction,
// whatever edges with more triangles bound it. Sheets that close only together, at such edges, keep
// their relative direction if all triangles around were given consistently. The direction of a
// sheet is put to the vote of axis-parallel lines (RayParityVotes.h). A closed one faces outward by
// its own crossings with them, or inward where it lies an odd number of shells deep; one with at
// least a quarter of its votes on either side passes through itself, and faces so that its volume
// is positive. One that is not closed is judged by the crossings with all sheets.
//
// A sheet with a tie keeps the direction in which most of its triangles were given; but if the
// surface then encloses a negative volume, all such sheets are reversed.
//
// Triangles that already point the right way stay as they are; the others exchange their last two
// corners. The result does not depend on the order of the triangles, except for sheets without a
// majority.
#pragma once

#include "Repair/TrianglePairs.h"

namespace cartesian
{

// `pairs`: of triangles that cross. `tree`: of the surface.
void orient(
  Surface& surface, const TrianglePairs& pairs, const TriangleTree& tree, Execution& execution);

}

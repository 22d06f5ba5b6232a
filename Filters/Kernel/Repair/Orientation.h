// SPDX-License-Identifier: BSD-3-Clause
// Consistent orientation of the triangles (step 6): afterwards normals point out of the domain.
//
// The rule: shells that do not cross alternate, whichever way they were turned: a shell in a shell is a
// cavity, a shell in that a body again. Bodies that overlap are one (Winding.h).
//
// A sheet is what hangs together across edges of exactly two triangles; its triangles get one
// direction, whatever edges of more triangles bound it; sheets that need each other to close at such edges
// keep theirs where all triangles around were given consistently. Which one, lines along x, y and z decide
// that pass through some of its largest triangles: before an odd crossing a line is outside, before
// an even one inside. Lines that cross the surface an odd number of times (through a hole) have no
// vote, nor have crossings that share a level of the lattice. A closed sheet with a quarter of its votes
// or more on either side passes through others and is a body by itself; what passes through them with
// less is what most of it is: a cavity may reach through a wall. A sheet whose votes are equal is left
// as most of its triangles were given; if all that is left so encloses a negative volume with the
// rest, it is turned over.
//
// Only triangles that have to are turned, by exchange of their last two corners: what is
// consistent already stays as it is. The result does not depend on the triangles' order, except
// for sheets without a majority.
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

void orient(Surface& surface, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// Cuts the triangles of bodies along each other wherever they cross or overlap, so that two triangles then share a
// corner, an edge, all of their corners, or nothing.
//
// What crosses what is decided exactly, by signs of determinants. The places where edges pass through triangles are
// rounded to the lattice; triangles bent by less than a level may cross again, so this is repeated in rounds until
// none do (iterated snap rounding, as CGAL's autorefinement of triangle soups has it). All triangles at an edge get
// the same vertices on it: closed surfaces stay closed.
#pragma once

#include "Repair/Snapping.h"
#include "Surface/Surface.h"

namespace cartesian
{

// Faces of different bodies that are nearly coplanar, by the precision of the file, are treated as coplanar.
//
// Surface::triangles, boundary, given and region are of the pieces then; triangles that close holes (without an entry
// in Surface::given) stay the last ones. Triangles without an area are left out. If snapping keeps bending faces,
// some may still cross: Spaces detects this. False, with the work left unfinished, where the triangles fall into too many
// pieces.
bool arrange(Surface& surface, const Placing& placing, Execution& execution);
bool arrange(Surface& surface, Execution& execution); // by placingOf()

// Cut along each other, bodies keep their volumes, to within how far vertices are moved.
bool keepsVolume(const Surface& given, const Surface& arranged, const Placing& placing);

// Whether the surface is large compared with the thickness of sheets (Snapping.h): relative to its distance from the
// origin in single precision, and on the lattice.
bool isFinelyPlaced(const Surface& surface);

// The same compared with what an arrangement moves.
bool canBeArranged(const Surface& surface, const Placing& placing);

}

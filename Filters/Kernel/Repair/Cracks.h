// SPDX-License-Identifier: BSD-3-Clause
// Joins open edges that run along each other: cracks between faces that were written one by one, lids a hair off.
//
// A crack is narrower than a small part of a box. Of two open corners that near each other one goes to the other's place, if they are
// not neighbours along a rim; an open edge is divided where a corner of another one is near, and goes through it. Which corner stays
// is the lower one: of the surface, at most the crack's width moves, and triangles keep their boundaries. What remains of
// a crack is a slit, which is a hole (Holes.h).
// Limits: edges whose corners lie on a curve, one here, one there, are as far apart as their chords.
#pragma once

#include "Base/Range.h"
#include "Lattice/Meshlines.h"
#include "Lattice/Vector.h"
#include "Surface/Surface.h"

namespace cartesian
{

struct CrackSpec
{
  static constexpr Range Widths{ 0 }; // user units

  // Of the side of the smallest box there.
  static constexpr double PartOfBox = 0.01;

  double width = 0; // cracks are at most that wide, user units; 0: PartOfBox
};

struct JoinedCracks
{
  // Where two open edges have become one.
  struct Edge
  {
    std::array<Vector, 2> ends; // levels
    double width;               // levels: how far one of these was from what it was joined with
  };
  std::vector<Edge> joined; // in order of their corners
};

// `depth`: how often boxes may be halved. Corners and edges of other regions do not count.
JoinedCracks joinCracks(Surface& surface, const Meshlines& planes, const CrackSpec& spec, int depth,
  Execution& execution);

}

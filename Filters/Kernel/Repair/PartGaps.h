// SPDX-License-Identifier: BSD-3-Clause
// Closes gaps between closed parts of one body: houses in a row, a door in its frame.
//
// Parts that face each other within a width become regions, the largest first, whose walls become one as those of regions that
// touch nearly (Contacts.h): so a later part reaches up to the earlier one, strips stand across the gap in the planes of the
// walls beside it, and of both parts nothing moves. What is outside of all regions is left then as one surface. Parts that
// are near each other are joined group by group, without those of which it is not certain what they enclose then. The method
// is this project's own.
//
// Limits: parts take part that are closed as they are given, with two triangles at each edge; where several gaps meet, a channel as wide as they are stays open; walls of one part that face each other leave a gap as it is; so do walls that lean from each other by more than 60 degrees.
#pragma once

#include "Lattice/Vector.h"
#include "Surface/Surface.h"

namespace cartesian
{

struct PartGaps
{
  struct Gap
  {
    double width; // levels: how far the walls are apart at most
    std::vector<Corners> strips;
  };

  // A triangle of the view, or a part of one.
  struct Piece
  {
    std::uint32_t given;
    Corners corners; // levels
  };

  std::vector<std::uint32_t> replaced; // triangles of the view, ascending, by:
  std::vector<Piece> pieces;
  std::vector<Gap> gaps;
  std::vector<Vector> refused; // levels: where parts near each other could not be joined
};

// `given`: before the repair; `surface`: afterwards, closed, oriented and united as far as it can be. `width`: levels.
PartGaps closePartGaps(
  const Surface& given, const Surface& surface, double width, Execution& execution);

}

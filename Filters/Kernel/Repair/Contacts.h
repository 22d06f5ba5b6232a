// SPDX-License-Identifier: BSD-3-Clause
// Merges walls of two regions where they nearly touch.
//
// A *sheet* is a part of a region's surface without sharp edges, such as the inside of a pipe. Where sheets of a
// later region and of an earlier one face each other everywhere within a tolerance, the later region's is replaced by
// the triangles of the earlier one, reversed. So nothing of the earlier region moves, the common wall has the same
// triangles from both sides without imprinting, however curved it is and however the two were triangulated, and
// neither slivers nor rounding can come between them.
//
// Only at the rims are both surfaces touched: the corners of the later region's rim move to the nearest places of the
// earlier one's, where edges are divided, so that the rest of the later surface closes there.
#pragma once

#include "Lattice/Vector.h"
#include "Surface/Surface.h"

namespace cartesian
{

// Two walls that became one.
struct ClosedContact
{
  std::int32_t earlier; // regions
  std::int32_t later;
  double width; // levels: the largest distance of a corner of either from the other
  std::vector<std::uint32_t> given; // the later region's triangles, by their numbers in the view
  std::vector<Corners> triangles;   // the same, as they were
};

// `surface`: of all regions, each closed and oriented; `tolerance`: in levels.
std::vector<ClosedContact> closeContacts(
  Surface& surface, std::int32_t regions, double tolerance, Execution& execution);

}

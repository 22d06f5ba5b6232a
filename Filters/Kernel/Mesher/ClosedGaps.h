// SPDX-License-Identifier: BSD-3-Clause
// Closes holes that are at least as wide as the smallest box there, but no wider than the user says: windows of a car body, a
// missing lid.
//
// The triangles that close one are for the caller to add to the surface, as a boundary of their own. They are those of
// Holes.h, whose width this is too; other holes stay for it. With several regions each is closed by itself.
// Where the rim of a hole is the edge of three walls at least, it is closed already, as by the pane of a window between the skin
// and the lining of a door: the smallest of these walls that ends there is a sheet, whose two sides are walls.
// Gaps between closed parts, however narrow, are closed by strips from one to the other (Repair/PartGaps.h); triangles that these
// cut are replaced by their pieces.
// Where two rims face each other, as of a lid and its frame, strips between them (Repair/RimStrips.h) come first.
#pragma once

#include "Mesher/Options.h"

namespace cartesian
{

struct ClosedGap
{
  std::vector<std::uint32_t> rim; // points, in turn; between parts, one of several
  std::vector<std::array<std::uint32_t, 3>> triangles; // points
  std::int32_t region = OutsideRegion;                 // with several regions, of what it closes
  double width = 0;                                    // user units
};

// Points are those of the view, and beyond these `added`.
struct ClosedGaps
{
  struct Piece
  {
    std::uint32_t given; // triangle of the view
    std::array<std::uint32_t, 3> points;
  };

  std::vector<ClosedGap>
    gaps; // strips, holes in order of their lowest points, then gaps between parts
  std::vector<std::uint32_t> panes;    // triangles of the view that are of such sheets, ascending
  std::vector<double> added;           // x, y, z
  std::vector<std::uint32_t> replaced; // triangles of the view, ascending, by:
  std::vector<Piece> pieces;
  std::vector<Vector> refused; // where parts near each other could not be joined, user units
};

// Those no wider than Options::closeGaps; none if that is 0. Throws Error: as placeOnGrid(); BadParameter (Close Gaps).
ClosedGaps closedGaps(const SurfaceView& view, const Options& options, Execution& execution);

}

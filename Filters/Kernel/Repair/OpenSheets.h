// SPDX-License-Identifier: BSD-3-Clause
// Sheets that are there once, such as a plate or a bent guide vane: open pieces of a surface whose lids (Holes.h) would
// have nearly their own area, so that they would enclose next to nothing.
//
// A piece is triangles of one region that are connected across edges of exactly two of them; it is open where it has an
// edge that nothing else uses. A triangle alone is none (it encloses nothing, and is left out), nor is a piece whose rim
// lies along other open rims all around: it is a patch of a wall whose triangles do not share their edges. One that is
// open only on the side it lies on, such as a letter on a wall, is a body: its whole rim lies on other triangles or on sides
// of the domain, and most of its lids is nearer to those than to itself. A fin that stands on a wall, or a partition from
// wall to wall, is a sheet.
#pragma once

#include "Repair/Baffles.h"
#include "Repair/ThinSheets.h"

#include "Lattice/Meshlines.h"

namespace cartesian
{

struct OpenSheet
{
  std::uint32_t triangle; // its first one
  std::int32_t boundary;  // of that
  double area;            // levels squared
  Vector place;           // of that triangle, levels
};

struct OpenSheets
{
  std::vector<OpenSheet> all;        // in order of their first triangles
  std::vector<std::uint8_t> isOfOne; // of each triangle; empty: there are none

  // Of these, sheets that are all that there is of a region, or of a surface whose inside is meshed: they bound nothing.
  std::size_t boundNothing = 0;
};

// How open sheets are told from other open surfaces.
struct OpenSheetSpec
{
  SheetHandling handling = SheetHandling::Automatic;
  bool boundSpaces = true; // the surface, or each region, must bound what is meshed
  double tolerance = 0;    // how far from walls rims may end, in levels
};

// Triangles of baffles are no part of any. With SheetHandling::Keep all open pieces with a hole wider than a box (Holes.h)
// are sheets.
OpenSheets findOpenSheets(const Surface& surface, const OpenSheetSpec& spec,
  const std::vector<Baffle>& baffles, const Meshlines& planes, Execution& execution);

}

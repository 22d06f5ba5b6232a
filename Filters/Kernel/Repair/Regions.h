// SPDX-License-Identifier: BSD-3-Clause
// The walls between several regions, out of their surfaces.
//
// Each region has its own closed surfaces, which may touch or cross those of others (Arrangement.h), or touch them
// within a tolerance (Contacts.h). A region may lie in another; where regions overlap, the first listed wins. The
// result is triangles between two regions, or between one and outside, each once: the only surface in all later
// steps, so that both regions share the faces there.
#pragma once

#include "Base/Range.h"
#include "Lattice/Meshlines.h"
#include "Repair/Baffles.h"
#include "Repair/Contacts.h"
#include "Repair/ThinSheets.h"

#include <optional>
#include <string>
#include <vector>

namespace cartesian
{

// The names of regions, and the distance within which their walls are merged.
struct RegionSpec
{
  static constexpr Range ContactTolerances{ 0 };

  std::vector<std::string> names; // for messages
  double contactTolerance = 0;    // user units
  std::vector<Baffle> baffles;
  SheetHandling sheets = SheetHandling::Automatic;
};

// Fills Surface::walls; boundary indices then are those of walls. Returns what the tolerance closed; or nothing,
// without changing the surface, if the baffles do not divide their regions (Baffles.h). Throws Error (FlawedSurface):
// a region's surface is not closed, or its sides are ambiguous, or nothing is left of it.
std::optional<std::vector<ClosedContact>> separateRegions(
  Surface& surface, const Meshlines& planes, const RegionSpec& spec, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// The walls between several regions, out of their surfaces.
//
// Each region has closed surfaces of its own, which may touch or cross those of others (Arrangement.h), or touch them
// within a tolerance (Contacts.h). A region may lie in another; where several regions are, the first of them is. What
// is left are triangles between two regions, or between one and outside, each once: the only surface that all later
// steps know, so that both regions have the same faces there.
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

// What regions are called, and how far apart their walls may be that become one.
struct RegionSpec
{
  static constexpr Range ContactTolerances{ 0 };

  std::vector<std::string> names; // for messages
  double contactTolerance = 0;    // user units
  std::vector<Baffle> baffles;
  SheetHandling sheets = SheetHandling::Keep;
};

// Fills Surface::walls; boundary indices then are those of walls. Returns what the tolerance closed; or nothing, and leaves
// the surface, where the baffles do not divide their regions (Baffles.h).
// Throws Error (FlawedSurface): a region's surface is not closed, or it is not sure what is on which side of it, or
// nothing is left of it.
std::optional<std::vector<ClosedContact>> separateRegions(
  Surface& surface, const Meshlines& planes, const RegionSpec& spec, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// Makes walls of two regions one where they face each other within a tolerance.
//
// The later region's wall is taken away there. Along the rim of what is left a *curtain* hangs across the gap into the
// earlier region, in the planes of the walls beside the rim, so that flush sides stay flat. All is cut along each other
// (Arrangement.h). Then the walls around a space tell whose it is: what no earlier region has is the later one's up to
// the earlier one's wall. So the common wall has the triangles of the earlier region, of which nothing moves, however
// the two walls weave through each other; and what curtains do within other regions, or beyond a thin one, does not
// matter.
//
// A wall that faces another only in part is divided first, along strips that rise from the other's sharp edges.
//
// Limits: a wall goes triangle by triangle, where its corners and its middle face the other; what a large triangle spans
// between these is not measured.
#pragma once

#include "Repair/WallsOfBodies.h"

#include <string>

namespace cartesian
{

// Two regions' walls that became one.
struct ClosedContact
{
  std::int32_t earlier; // regions
  std::int32_t later;
  double width =
    0; // levels: the largest distance of a place of the later wall from the earlier one
  double closed = 0; // cubic levels, about: what the later region got of gaps
  double taken = 0;  // what it lost where they overlapped
  std::vector<std::uint32_t>
    given; // the later region's triangles there, by their numbers in the view
  std::vector<Corners> triangles;   // the same, as they were
  std::array<std::string, 2> names; // of the regions, for messages
};

struct ContactSpec
{
  static constexpr std::int32_t AsBeside = NoBoundary - 1; // of the wall that a curtain continues

  double tolerance; // levels
  std::int32_t boundaryOfCurtains =
    AsBeside; // of those towards a region: the same, plus the region
};

// As wallsOf(), of regions that are not arranged yet, and sheets; nothing, and no contacts, where no walls are near.
// `arranged`: what `crossing` are triangles of.
Surface wallsWithContacts(const Surface& all, const Surface& sheets, const Bodies& bodies,
  const ContactSpec& spec, std::vector<ClosedContact>& contacts, Surface& arranged,
  std::vector<std::uint32_t>& crossing, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// Rebuilds flawed boxes, in which the patches of the surface do not close, by Marching Cubes from the
// statuses of their corners.
//
// - A line between neighbouring grid nodes keeps its crossings if all sides around it have the same ones
//   and these lead from the status of one end to that of the other. Otherwise it gets one crossing if the
//   statuses of its ends differ (one of those it had, or its middle), and none if they do not.
// - A side keeps its chords if they close and no line around it has changed. Otherwise straight chords
//   join its crossings.
// - A box that is flawed, or has a side with new chords, gets new patches: triangles over the loops of the
//   chords on its sides, which close by construction.
//
// Lines and sides are decided once for all boxes around them, so neighbours agree, and nothing changes
// beyond the boxes around a flawed one.
#pragma once

#include "Faces/InnerFaces.h"

namespace cartesian
{

// What flawed boxes lose, even where it closes.
enum class RebuildLevel : std::uint8_t
{
  Detail, // boxes that close: sides between two of them get simplified chords (ChordSimplification.h)
  Nothing,
  Chords,
  Crossings,
};

struct RebuiltPatches
{
  Patches patches;
  std::vector<std::uint8_t> boxes; // of the polyhedral boxes: 1 if its patches are new
};

// `flawed`: of the polyhedral boxes.
RebuiltPatches rebuildFlawedBoxes(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, const std::vector<std::uint8_t>& flawed,
  RebuildLevel givenUp, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// Flawed boxes: Marching Cubes from the statuses, where the surface's own patches do not close.
//
// - A line between neighbouring nodes of the grid keeps its crossings where all sides around it have the
//   same ones and these lead from the status of one end to that of the other. Else it gets one crossing
//   if its ends differ: one of those it had, or its middle; and none if they do not.
// - A side keeps its chords where they close and the lines around it are as they were. Else straight
//   chords join its crossings.
// - A box that is flawed, or has a side with new chords, gets patches anew: triangles between the loops
//   of the chords on its sides, which close by construction.
//
// Lines and sides are decided once for all boxes around them, so neighbours agree, and nothing changes
// beyond the boxes around a flawed one.
#pragma once

#include "Faces/InnerFaces.h"

namespace cartesian
{

// What flawed boxes do not keep, whether it closes or not.
enum class GivenUp : std::uint8_t
{
  Nothing,
  Chords,
  Crossings,
};

struct RebuiltPatches
{
  Patches patches;
  std::vector<std::uint8_t> boxes; // of the polyhedral boxes: 1 if its patches are new
};

// `flawed`: 1 for those of the polyhedral boxes that are.
RebuiltPatches rebuildFlawedBoxes(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, const std::vector<std::uint8_t>& flawed,
  GivenUp givenUp, Execution& execution);

}

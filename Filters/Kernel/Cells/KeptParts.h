// SPDX-License-Identifier: BSD-3-Clause
// Connected parts of the domain, of which only those around given points are meshed.
#pragma once

#include "Cells/WallMesh.h"
#include "Surface/KeepPoints.h"

#include <optional>

namespace cartesian
{

struct PartsToKeep
{
  std::vector<KeepPoint> points;    // none: all parts
  std::vector<KeepPoint> keepOut;   // in no part that stays
  const Surface* surface = nullptr; // the walls, for the way there
  bool isEnclosed = false;          // none of them may reach the grid's ends
};

// Numbers of a point to keep out that is reached, and of the first one that it is reached from; None if all parts stay.
struct ReachedPoint
{
  std::size_t keptOut;
  std::size_t from;
};

struct KeptParts
{
  std::optional<ReachedPoint> leak;         // then nothing else is known
  std::size_t leftOut = 0;                  // parts
  std::vector<std::uint32_t> boxes;         // that stay, by their old numbers, in order
  std::vector<std::uint8_t> corners;        // of these: the corners that stay inside
  std::vector<std::uint8_t> droppedPatches; // 1: bounds what is left out
};

// Cells connected by faces, hexahedra included, are a part; it stays if a point is in it. The boxes must be those of
// the whole grid, with one region. Throws Error (BadParameter): no cell has a point in it, or a part reaches there.
KeptParts findKeptParts(const PartsToKeep& which, const Boxes& boxes, const Patches& patches,
  const Sides& sides, const Nodes& nodes, const WallMesh& wall, Execution& execution);

// Boxes and patches as for a surface without the other parts.
void keepOnly(const KeptParts& parts, Boxes& boxes, Patches& patches, Execution& execution);

}

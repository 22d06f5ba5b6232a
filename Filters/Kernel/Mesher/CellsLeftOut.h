// SPDX-License-Identifier: BSD-3-Clause
// Cells left out of the mesh, for whatever reason: small ones (section 4.10), failing ones (4.11), and those that the
// grid cuts off.
#pragma once

#include "Mesher/Mesher.h"

namespace cartesian
{

struct CellLeftOut
{
  std::uint32_t box;
  std::int32_t boundary; // of most of its patches, or NoBoundary
  double volume;         // in levels
};

// Of the core, in order of boxes; slivers, which have no volume, do not count.
std::vector<CellLeftOut> cellsLeftOut(const Assembly& assembly);

// Their volume as cut, in user units cubed, and as a part of what the mesh would have with them: 0 to 1.
double volumeLeftOut(const Assembly& assembly);
double shareLeftOut(const Assembly& assembly);

// Pieces of cells that the last step of the edits of the wall left out.
struct LeftOutAtRims
{
  std::size_t pieces = 0;
  double boxes = 0;          // their volume by those of the boxes that they lay in
  std::uint32_t largest = 0; // the box of the largest, by that measure
};

LeftOutAtRims leftOutAtRims(const Assembly& assembly);

}

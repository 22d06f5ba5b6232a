// SPDX-License-Identifier: BSD-3-Clause
// Faces made anew from their boundary alone, where that is flat: what else the file says of them is damaged.
#pragma once

#include "CadPart.h"

#include <vector>

namespace cartesian
{

// Some faces of each part, by number, become planes between their edges, if these are within a distance (millimetres) of one.
// `isFlat` tells which did. Faces stay in order; those that parts share are replaced in all. Empty if none did.
std::vector<CadPart> withFlatFaces(const std::vector<CadPart>& parts,
  const std::vector<std::vector<int>>& faces, double distance,
  std::vector<std::vector<bool>>& isFlat);

}

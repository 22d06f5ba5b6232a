// SPDX-License-Identifier: BSD-3-Clause
// Makes one face of two in which solids touch, so that both get the same triangles there (Open CASCADE's general fuse).
#pragma once

#include "CadOptions.h"
#include "CadPart.h"

namespace cartesian
{

// Solids that overlap are divided: what several hold is a part of its own, which is told. Sheets stay as they are.
void glue(std::vector<CadPart>& parts, const CadOptions& options, const CadReport& report);

// Notes how many pairs of solids may touch, by their boxes.
void noteNeighbours(const std::vector<CadPart>& parts, const CadReport& report);

}

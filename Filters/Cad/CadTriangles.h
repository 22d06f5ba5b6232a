// SPDX-License-Identifier: BSD-3-Clause
// Triangles of parts. Two faces have the same points along their common edge: welded by topology, not by distance.
#pragma once

#include "CadNames.h"
#include "Stream.h"

namespace cartesian
{

// One for each part. Where a face lacks triangles, or edges stay open, the part is tried again, finer.
std::vector<CadSolid> triangulate(const std::vector<CadPart>& parts,
  const CadBoundaries& boundaries, const CadOptions& options, const CadReport& report);

// Of tessellated parts, those that they have.
std::vector<CadSolid> trianglesOf(const std::vector<CadPart>& parts,
  const CadBoundaries& boundaries, const CadOptions& options, const CadReport& report);

}

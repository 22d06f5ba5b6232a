// SPDX-License-Identifier: BSD-3-Clause
// A mesh as files of EnSight Gold, binary (C Binary): polyhedra (nfaced) and named boundaries of polygons (nsided).
//
// The format is that of the chapter "EnSight Gold Case File Format" of EnSight's user manual: records of 80
// characters, and numbers of 32 bits in the order of this computer. So coordinates have 7 digits, not 16.
#pragma once

#include "OpenFoam/FoamRegions.h"

namespace cartesian
{

// Writes `path`, a .case file, and beside it the geometry that it names, the same with the suffix .geo and without
// blanks. Each region is a part (one called "cells", if there are none), then each patch. Parts have points of
// their own with the numbers of the whole mesh as ids (node id given), by which Code_Saturne puts them together.
// Throws Error (CannotWrite).
void writeEnSight(
  const FoamMesh& mesh, const FoamRegions& regions, const std::filesystem::path& path);

}

// SPDX-License-Identifier: BSD-3-Clause
// A mesh as a CGNS file: zones of polyhedra (NGON_n, NFACE_n) with boundary conditions.
#pragma once

#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

struct CgnsZone
{
  std::string name;
  FoamMesh mesh;
};

// Writes a file beside `path`, which takes its name when it is complete. Each patch is a family with a boundary
// condition, and one that samples another zone's a 1-to-1 connection. Names of more than 32 bytes, CGNS's limit, are
// cut and kept unique. Throws Error (CannotWrite).
void writeCgns(const std::vector<CgnsZone>& zones, const std::filesystem::path& path);

}

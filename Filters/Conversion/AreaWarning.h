// SPDX-License-Identifier: BSD-3-Clause
// Warnings about the areas of boundaries.
#pragma once

#include "BoundaryNames.h"

#include "Lattice/Meshlines.h"
#include "Surface/Surface.h"

#include <string>

class vtkDataObject;

namespace cartesian
{

// Faces that belong to no boundary, with their area; empty if there are none. `mesh`: as MeshToVTK makes it.
std::string describeNoSurface(vtkDataObject* mesh);

// Flat boundaries whose area in the mesh differs from that in the surface, where all of it bounds the mesh; empty if
// there are none.
std::string describeWrongAreas(
  const Surface& surface, const Meshlines& planes, const BoundaryNames& names, vtkDataObject* mesh);

}

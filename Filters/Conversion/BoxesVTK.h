// SPDX-License-Identifier: BSD-3-Clause
// The kernel's boxes as a vtkUnstructuredGrid of voxels, and back.
//
// Cell arrays: GlobalBox (int, components I, J, K), Level (unsigned char, components X, Y, Z: how
// often the global box is halved along each axis), RefinementLevel (unsigned char: the largest of these), Offset (unsigned short, components X, Y, Z: of
// the low corner in its global box, in parts of it), Status (unsigned char: 1 inside, 2 intersected),
// CornerStatus (unsigned char, bit x + 2 y + 4 z: that corner is inside).
// Field data: LatticeOrigin (3, user units), LatticeStep (1, user units), PartsPerBox (1: of a global box along each
// axis; 64 if it is missing, as in boxes of earlier versions), PlanesX, PlanesY, PlanesZ (even levels of the lattice),
// MovedPlanesX, MovedPlanesY, MovedPlanesZ (pairs of numbers: a plane that divides boxes, in parts of them from the
// first meshline, and its level, where that is not at this part).
#pragma once

#include "Boxes/Boxes.h"

class vtkDataObject;
class vtkUnstructuredGrid;

namespace cartesian
{

void toVTK(const Boxes& boxes, vtkUnstructuredGrid* grid);

// Throws Error (MissingArray) if an array is missing or is not what toVTK wrote.
Boxes boxesFromVTK(vtkUnstructuredGrid* grid);

// Removes the field data that toVTK wrote: VTK passes that of a filter's first input on to its outputs.
void removeBoxFields(vtkDataObject* data);

}

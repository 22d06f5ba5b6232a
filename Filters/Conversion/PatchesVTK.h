// SPDX-License-Identifier: BSD-3-Clause
// The kernel's patches as a vtkPolyData, and back.
//
// Cell arrays: BoundaryId (int), BoxId (id type: the box's cell in the grid of boxes), SurfaceCell (id type: the cell
// of the surface that the patch is part of), PatchReason (unsigned char: the reason for its box's method; the codes
// of PatchReason in PatchChoice.h), EnclosedVolume (double, cubic user units: of the connected piece of surface that
// it comes from), VolumeGap (double, user units: how far the patches of its box would have to move outwards to enclose
// the surface's volume there). Point array: PointKind (unsigned char: the codes of PointKind.h). Field data:
// FeatureAngle (double: the angle above which an edge is a sharp feature), SurfaceVolume (double, cubic user units: the
// part of the domain that the surface encloses; 0: not known), and, only if the surface knows its sharp edges, KnowsEdges
// (double: 1).
#pragma once

#include "Patches/Patches.h"

#include "vtkType.h"

class vtkPolyData;

namespace cartesian
{

constexpr const char* FeatureAngleField = "FeatureAngle";
constexpr const char* SurfaceVolumeField = "SurfaceVolume";

// `surfaceCells`: the cell of each triangle of the surface (SurfaceFromVTK).
void toVTK(const Patches& patches, const Boxes& boxes, const std::vector<vtkIdType>& surfaceCells,
  vtkPolyData* output);

// Throws Error (MissingArray) if an array is missing, or the patches do not belong to the boxes.
Patches patchesFromVTK(vtkPolyData* input, const Boxes& boxes);

}

// SPDX-License-Identifier: BSD-3-Clause
// What boundary each face of a mesh belongs to, kept in the mesh itself: so that it can be written
// with its patches whatever filters came between, as long as they leave its cells as they are.
//
// Cell array CellId (id type): number of the cell when the mesh was made. Field data array
// BoundaryOfFaces (id type, components Cell, Face, BoundaryId): for each boundary face the CellId
// of its cell, the number of the face in the cell in VTK's order, and its boundary; by CellId.
#pragma once

#include "GridFaces.h"

#include <map>
#include <string>

class vtkPolyData;

namespace cartesian
{

constexpr const char* CellId = "CellId";
constexpr const char* BoundaryOfFaces = "BoundaryOfFaces";

// Adds both arrays to the mesh. `boundary`: as in MeshToVTK.h, in order of OwnerCell.
void setBoundaryOfFaces(vtkUnstructuredGrid* mesh, vtkPolyData* boundary, Execution& execution);

enum class BoundaryKnowledge
{
  Nothing, // the grid does not say
  Unfit,   // cells were changed since, or several meshes are in one
  All      // each boundary face is known, or was an inner face once
};

// Boundary of each boundary face of `list`; NoBoundary where none is known.
BoundaryKnowledge readBoundaryOfFaces(vtkUnstructuredGrid* grid, const GridFaces& faces,
  const FaceList& list, std::vector<vtkIdType>& boundary);

// What the field data say of boundaries, by number: the strings of the array `name` (BoundaryNames,
// BoundaryTypes), for the numbers in BoundaryIds (if missing: 0, 1, 2, ...).
std::map<vtkIdType, std::string> readBoundaryTexts(vtkUnstructuredGrid* grid, const char* name);

}

// SPDX-License-Identifier: BSD-3-Clause
// The boundary of each face of a mesh, kept in the mesh itself. Thus a mesh can be written with its patches
// after any filters that leave its cells unchanged.
//
// Cell array CellId (id type): number of the cell when the mesh was made, in order of boxes: not its
// place in the mesh, where hexahedra come first. Field data array BoundaryOfFaces (id type, components Cell, Face, BoundaryId): for each boundary face the CellId
// of its cell, the number of the face in the cell in VTK's order, and its boundary; by CellId. Both sides of a
// face of a baffle are there.
#pragma once

#include "GridFaces.h"
#include "Surface/Walls.h"

#include <array>
#include <map>
#include <string>

class vtkPolyData;

namespace cartesian
{

constexpr const char* CellId = "CellId";
constexpr const char* BoundaryOfFaces = "BoundaryOfFaces";

using BoundaryFaceRow = std::array<vtkIdType, 3>; // its components

// Adds BoundaryOfFaces to a mesh whose CellId is 0, 1, 2, ... in any order. `boundary`: as in MeshToVTK.h,
// in order of OwnerCell.
void setBoundaryOfFaces(vtkUnstructuredGrid* mesh, vtkPolyData* boundary, Execution& execution);

enum class BoundaryKnowledge
{
  Nothing, // the grid has no such array
  Unfit,   // cells were changed since, or the grid unites several meshes
  All      // each boundary face is known, or was an inner face before
};

// Of faces that the mesh's boundary did not have.
constexpr vtkIdType UnknownBoundary = NoBoundary - 1;

// Gives the boundary of each boundary face of `list`, or UnknownBoundary. Faces of baffles are boundary faces of both
// their cells then. `cellOf`: the number in the grid of each of the `cells`.
BoundaryKnowledge readBoundaryOfFaces(vtkUnstructuredGrid* grid, const CellFaces& cells,
  const std::vector<vtkIdType>& cellOf, FaceList& list, std::vector<vtkIdType>& boundary,
  Execution& execution);

// The strings of the field data array `name` (BoundaryNames, BoundaryTypes), by the numbers in BoundaryIds
// (if that is missing: 0, 1, 2, ...).
std::map<vtkIdType, std::string> readBoundaryTexts(vtkUnstructuredGrid* grid, const char* name);

}

// SPDX-License-Identifier: BSD-3-Clause
// The kernel's mesh as VTK data.
//
// Mesh (vtkUnstructuredGrid of VTK_HEXAHEDRON, which come first, and VTK_POLYHEDRON with outward faces).
// Cell arrays:
// GlobalBox (int, components I, J, K), Level (unsigned char, components X, Y, Z: of the cell's box), Region
// (int, from 1), VolumeFraction (double, of the cell's box); and those of BoundaryOfFaces.h. Field data: one
// array of one number for each of the statistics.
//
// Boundary (vtkPolyData): the faces that only one cell has, in order of their cells. Cell arrays:
// BoundaryId (int; -1 where no patch was), OwnerCell (id type: CellId of the cell). Point array:
// MeshPointId (id type).
//
// Both have field data with one value for each boundary, in order of their numbers: BoundaryIds and
// BoundaryNames, BoundaryTypes if any boundary has a type (BoundaryNames.h), BoundaryFaceCounts (id type),
// BoundaryAreas (double, square user units).
//
// With several regions, Boundary has the cell array Region (int), and both have field data with one value for
// each region: RegionNames, RegionVolumes (double, cubic user units).
//
// Interfaces (vtkPolyData): the faces between cells of two regions, seen from the one of the lower region, their
// owner. Cell arrays: InterfaceId (int, from 0: of the field data InterfaceNames, "X_to_Y" of the names of the
// owner's and the neighbour's region), OwnerRegion, NeighbourRegion, OwnerBoundaryId, NeighbourBoundaryId (int),
// OwnerCell, NeighbourCell (id type: CellIds; -1: the neighbour belongs to another piece). Point array:
// MeshPointId.
//
// For a piece of the mesh, all numbers of cells and points in arrays are those of the whole mesh
// (MeshPiece.h). Statistics and field data are those of all processes together, if there are several, else
// of this piece.
#pragma once

#include "BoundaryNames.h"
#include "MeshPiece.h"
#include "Mesher/Assembly.h"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace cartesian
{

struct BoundaryTexts
{
  BoundaryNames names;
  BoundaryNames types;              // of those that have one
  std::vector<std::string> regions; // empty: there is one
};

void toVTK(const Assembly& assembly, const BoundaryTexts& texts, const MeshPiece& piece,
  vtkUnstructuredGrid* mesh, vtkPolyData* boundary, vtkPolyData* interfaces, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// A mesh's boundaries and regions, in OpenFOAM's terms (vtkPolyMeshWriter.h).
#pragma once

#include "GridFaces.h"
#include "OpenFoam/FoamPieces.h"
#include "OpenFoam/FoamRegions.h"

class vtkUnstructuredGrid;

namespace cartesian
{

// Patches of these boundaries, with so many faces each.
std::vector<FoamPatch> patchesOf(vtkUnstructuredGrid* grid,
  const std::vector<vtkIdType>& boundaries, const std::vector<std::size_t>& counts);

// Sorts the boundary faces by boundary, NoBoundary last. Returns the boundaries and their numbers of faces.
std::pair<std::vector<vtkIdType>, std::vector<std::size_t>> sortByBoundary(
  const std::vector<vtkIdType>& boundaryOf, FaceList& list);

enum class RegionsAsked
{
  WithCells,    // none, if all cells are of one
  AllOfTheMesh, // those of other pieces too; none, if there is one
};

// Of some cells of the grid.
FoamRegions regionsOf(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& cells, RegionsAsked asked);

std::vector<FoamZone> zonesOf(const FoamRegions& regions);

struct WholeMesh
{
  FoamMesh mesh;
  FoamRegions regions;
  bool lostBoundaries; // the grid had some: the mesh has one patch
};

constexpr const char* LostBoundaries =
  "Cells were cut or merged after meshing, so the mesh has lost its boundaries: all boundary faces "
  "are written as one patch. To keep the boundaries, save the output of Cartesian Mesher itself.";

// Throws Error (BadMesh): cells overlap, or too many to number.
WholeMesh wholeMesh(vtkUnstructuredGrid* grid, Execution& execution);

// A piece of a mesh; it must have global ids (MeshPiece.h). Throws Error (BadMesh): it has none, or cells were
// changed since it was made.
FoamPiece foamPiece(vtkUnstructuredGrid* grid, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// The defects of a surface as a vtkPolyData of lines and triangles.
//
// Cell arrays: DefectKind (int: SurfaceDefects.h, vtkSurfaceInspector.h), DefectName (string), SurfaceCell and OtherCell (id
// type: cells of the surface, or -1), Width (double: of what was closed or joined and of leaks, else 0), Volume (double: of cells left out,
// else 0). Field data: one number for each count.
#pragma once

#include "Mesher/Assembly.h"
#include "Mesher/LeakPath.h"
#include "Repair/SurfaceDefects.h"

#include "vtkType.h"

class vtkDataObject;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace cartesian
{

// `surfaceCells`: the cell of each triangle of the surface (SurfaceFromVTK).
void toVTK(const SurfaceDefects& defects, const std::vector<vtkIdType>& surfaceCells,
  vtkPolyData* output, Execution& execution);

// What was repaired, as numbers in field data: TrianglesTurned, DuplicatesLeftOut, LooseTrianglesLeftOut,
// HolesClosed, LeaksClosed; each only if it is not 0.
void setRepairs(const SurfaceRepair& repair, vtkDataObject* output);

// Adds the cells left out of the mesh because they failed or the grid cut them off: the six sides of the box of each,
// of kind CellLeftOut.
void addCellsLeftOut(const Assembly& assembly, vtkPolyData* output);

// Adds the faces of each of these cells of the mesh, of kind FailingCell.
void addFailingCells(
  vtkUnstructuredGrid* mesh, const std::vector<vtkIdType>& cells, vtkPolyData* output);

// Adds the wall faces without a whole stack of layers, of kinds LayersEnd... `boundary`: the faces of the layered boundary, in
// order.
void addEndedLayers(const BoundaryLayers& layers, vtkPolyData* boundary, vtkPolyData* output);

// Adds the way to a point to keep out, of kind LeakPath, with the width of its narrowest gap, and its gaps, of kind LeakGap.
void addLeak(const LeakPath& path, vtkPolyData* output, Execution& execution);

}

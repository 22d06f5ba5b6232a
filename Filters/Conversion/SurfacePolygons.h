// SPDX-License-Identifier: BSD-3-Clause
// Polygons of a vtkPolyData: whether they are triangles, are there at all, and have an area.
#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkPoints;
class vtkPolyData;

namespace cartesian
{

constexpr const char* CellIds = "CartesianMesherCellIds";

bool allTriangles(vtkPolyData* input);

// The same surface in triangles; its array CellIds has the cell of the input that each comes from.
vtkSmartPointer<vtkPolyData> triangulated(vtkPolyData* input);

// Cells that VTK takes for absent: blanked, refined elsewhere, copies of another piece's, or with a blanked
// point. Empty if there are none.
std::vector<bool> hiddenCells(vtkPolyData* block);

// How many of a polygon's corners differ from the one before.
std::size_t differentCorners(vtkPoints* points, vtkIdType size, const vtkIdType* corners);

// Whether a polygon's corners lie on one line.
bool isFlat(vtkPoints* points, vtkIdType size, const vtkIdType* corners);

}

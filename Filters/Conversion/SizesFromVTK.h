// SPDX-License-Identifier: BSD-3-Clause
// Sizes that a point or cell array asks boxes to have.
#pragma once

#include "Boxes/SizingSpec.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace cartesian
{

struct AskedSizes
{
  bool isThere = false; // the array
  std::vector<WantedSize> boxes;
  std::vector<double> ofTriangles; // of the surface, or empty
};

// What an array of the surface asks for; `cells`: of its triangles (SurfaceFromVTK.h). A cell has the least value of its
// points. Values that are not positive and finite ask for nothing.
AskedSizes sizesOnSurface(
  const std::string& array, vtkDataObject* surface, const std::vector<vtkIdType>& cells);

// The same of a data set of any kind, or blocks of them: each cell asks in its bounding box; points of clouds, which may be one
// cell or none, each where it is.
AskedSizes sizesInField(const std::string& array, vtkDataObject* field);

}

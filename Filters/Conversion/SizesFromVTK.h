// SPDX-License-Identifier: BSD-3-Clause
// Box sizes prescribed by a point or cell array.
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

// Sizes prescribed by an array of the surface; `cells`: of its triangles (SurfaceFromVTK.h). A cell has the least
// value of its points. Values that are not positive and finite have no effect.
AskedSizes sizesOnSurface(
  const std::string& array, vtkDataObject* surface, const std::vector<vtkIdType>& cells);

// The same for a data set of any kind, or blocks of them: each cell prescribes its bounding box; each point of a
// cloud, which may be one cell or none, its own place.
AskedSizes sizesInField(const std::string& array, vtkDataObject* field);

}

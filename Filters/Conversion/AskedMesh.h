// SPDX-License-Identifier: BSD-3-Clause
// What the properties and inputs of a filter ask for.
#pragma once

#include "Mesher/Options.h"
#include "SurfaceFromVTK.h"
#include "vtkCartesianGridAlgorithm.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

struct vtkCartesianGridAlgorithm::RegionSurface
{
  vtkSmartPointer<vtkPolyData> shape; // as given
  std::unique_ptr<cartesian::SurfaceFromVTK> surface;
  int depth;
};

// All options, with the surfaces of regions that they borrow.
struct vtkCartesianGridAlgorithm::Asked
{
  std::vector<RegionSurface> regions;
  cartesian::Options options;
};

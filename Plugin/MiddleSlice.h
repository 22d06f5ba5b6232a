// SPDX-License-Identifier: BSD-3-Clause
// Cells in a plane through bodies, where no boundary of the mesh shows any.
#pragma once

#include <array>

class vtkSMRenderViewProxy;
class vtkSMSourceProxy;

namespace cartesian
{

// A filter in the pipeline, MiddleSlice, after the first output of `mesher`; shown in the view.
void showMiddleSlice(vtkSMSourceProxy* mesher, vtkSMRenderViewProxy* view,
  const std::array<double, 3>& place, const std::array<double, 3>& normal);

}

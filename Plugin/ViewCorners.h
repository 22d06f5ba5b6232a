// SPDX-License-Identifier: BSD-3-Clause
// Where legends and texts lie in a view: each elsewhere.
#pragma once

#include <vector>

class vtkSMProxy;

namespace cartesian
{

// As ParaView numbers them.
enum ViewCorner
{
  LowerLeft = 1, // the axes are there
  LowerRight = 2,
  LowerCentre = 3,
  UpperLeft = 4,
  UpperRight = 5,
  UpperCentre = 6,
};

// The first of these at which a view shows no other legend or text than this one; the first if each has one.
ViewCorner freeCorner(
  vtkSMProxy* view, vtkSMProxy* forThis, const std::vector<ViewCorner>& corners);

// From now on texts with the hint SmallText of their source are small and in a corner, and yield to legends.
void watchTexts();

}

// SPDX-License-Identifier: BSD-3-Clause
// A mesh with periodic boundaries (Sections/PeriodicFaces.h), as VTK has it.
#pragma once

#include "Base/Execution.h"
#include "Sections/SideMotion.h"

#include <array>
#include <string>

class vtkUnstructuredGrid;

namespace cartesian
{

struct PeriodicBoundarySpec
{
  std::array<std::string, 2> names;
  bool turns = false; // the second is the first turned around the axis, else moved
  Vector axis{ 0, 0, 1 };
  Vector centre{};
  bool keepsFaces = false; // of type cyclicAMI, else cyclic
};

struct PeriodicResult
{
  std::array<double, 2> areas; // of the boundaries, user units squared
  double farthest;             // that a point has moved by
};

// Fills an empty grid; vtkPeriodicBoundaries.h lists its arrays. Throws Error: BadParameter (no such boundary, a pair of one, no
// axis); BadMesh (as matchSides; cells were changed since the mesh was made).
PeriodicResult makePeriodic(vtkUnstructuredGrid* grid, const PeriodicBoundarySpec& spec,
  vtkUnstructuredGrid* output, Execution& execution);

}

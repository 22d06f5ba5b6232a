// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPeriodicBoundaries.h"

#include "Base/Error.h"
#include "PeriodicMesh.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{

// Solvers lose what flows through a pair whose areas differ by more.
constexpr double SameArea = 1e-6;

}

vtkStandardNewMacro(vtkPeriodicBoundaries);

int vtkPeriodicBoundaries::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkPeriodicBoundaries::FillOutputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

int vtkPeriodicBoundaries::RequestData(
  vtkInformation* /*request*/, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::GetData(input[0]);
  this->Run(0, 1, [&](cartesian::Execution& execution) {
    cartesian::PeriodicBoundarySpec spec;
    spec.names = { this->FirstBoundary, this->SecondBoundary };
    spec.turns = this->Motion == Rotation;
    std::copy_n(this->Axis, 3, spec.axis.begin());
    std::copy_n(this->AxisOrigin, 3, spec.centre.begin());
    spec.keepsFaces = this->Faces == Own;
    const auto [areas, farthest] =
      cartesian::makePeriodic(grid, spec, vtkUnstructuredGrid::GetData(output), execution);
    if (spec.keepsFaces && std::abs(areas[0] - areas[1]) > SameArea * areas[0])
    {
      vtkWarningMacro(<< "The areas of \"" << spec.names[0] << "\" and \"" << spec.names[1]
                      << "\" differ: " << areas[0] << " and " << areas[1]
                      << ". Solvers lose or gain flow there.");
    }
  });
  return 1;
}

void vtkPeriodicBoundaries::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FirstBoundary: " << this->FirstBoundary << "\n"
     << indent << "SecondBoundary: " << this->SecondBoundary << "\n"
     << indent << "Motion: " << this->Motion << "\n"
     << indent << "Axis: (" << this->Axis[0] << ", " << this->Axis[1] << ", " << this->Axis[2]
     << ")\n"
     << indent << "AxisOrigin: (" << this->AxisOrigin[0] << ", " << this->AxisOrigin[1] << ", "
     << this->AxisOrigin[2] << ")\n"
     << indent << "Faces: " << this->Faces << "\n";
}

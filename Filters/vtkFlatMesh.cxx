// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlatMesh.h"

#include "FlatGrid.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkFlatMesh);

int vtkFlatMesh::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkFlatMesh::FillOutputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

int vtkFlatMesh::RequestData(
  vtkInformation* /*request*/, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::GetData(input[0]);
  this->Run(0, 1, [&](cartesian::Execution& execution) {
    cartesian::requireInRange({ 0, 2 }, this->Across, "Across");
    cartesian::requireInRange({ 0, 2 }, this->Axis, "Axis");
    cartesian::SweepSpec spec;
    spec.across = static_cast<std::size_t>(this->Across);
    spec.thickness = this->Thickness;
    spec.isWedge = this->Shape == Wedge;
    spec.axis = static_cast<std::size_t>(this->Axis);
    spec.origin = { this->AxisOrigin[0], this->AxisOrigin[1], this->AxisOrigin[2] };
    spec.angle = this->WedgeAngle;
    cartesian::makeFlat(grid, spec, vtkUnstructuredGrid::GetData(output), execution);
  });
  return 1;
}

void vtkFlatMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Across: " << this->Across << "\n"
     << indent << "Shape: " << this->Shape << "\n"
     << indent << "Thickness: " << this->Thickness << "\n"
     << indent << "Axis: " << this->Axis << "\n"
     << indent << "AxisOrigin: (" << this->AxisOrigin[0] << ", " << this->AxisOrigin[1] << ", "
     << this->AxisOrigin[2] << ")\n"
     << indent << "WedgeAngle: " << this->WedgeAngle << "\n";
}

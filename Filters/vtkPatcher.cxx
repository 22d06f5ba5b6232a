// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatcher.h"

#include "BoxesVTK.h"
#include "Mesher.h"
#include "PatchesVTK.h"
#include "SurfaceFromVTK.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkPatcher);

vtkPatcher::vtkPatcher()
{
  this->SetNumberOfInputPorts(2);
}

int vtkPatcher::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkUnstructuredGrid");
  return 1;
}

int vtkPatcher::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkPatcher::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  if (IsLeftToFirstProcess(output))
  {
    return 1;
  }
  this->Run([&](cartesian::Execution& execution) {
    execution.stage("Shoeboxes", 0, cartesian::AfterBoxes);
    const cartesian::SurfaceFromVTK source(vtkPolyData::GetData(input[0]), this->BoundaryArray);
    const cartesian::Boxes boxes = cartesian::boxesFromVTK(vtkUnstructuredGrid::GetData(input[1]));
    cartesian::boundsOf(source.view()); // checks the coordinates
    const cartesian::Surface surface =
      cartesian::onLattice(source.view(), boxes.lattice, execution);
    const cartesian::Shoeboxes shoeboxes =
      cartesian::fillShoeboxes(surface, boxes.planes, execution);
    execution.stage("Patches", cartesian::AfterBoxes, 1);
    cartesian::toVTK(cartesian::generatePatches(surface, boxes, shoeboxes, execution), boxes,
      source.cells(), vtkPolyData::GetData(output));
  });
  return 1;
}

void vtkPatcher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BoundaryArray: " << this->BoundaryArray << "\n";
  os << indent << "PatchMethod: " << this->PatchMethod << "\n";
}

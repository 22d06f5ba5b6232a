// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellAssembler.h"

#include "BoundaryNames.h"
#include "BoxesVTK.h"
#include "MeshToVTK.h"
#include "PatchesVTK.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkCellAssembler);

vtkCellAssembler::vtkCellAssembler()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

int vtkCellAssembler::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

int vtkCellAssembler::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

int vtkCellAssembler::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (IsLeftToFirstProcess(request, output))
  {
    return 1;
  }
  for (int port = 0; port < 2; ++port)
  {
    cartesian::removeBoxFields(vtkDataObject::GetData(output, port));
  }
  this->Run(cartesian::AfterPatches, 1, [&](cartesian::Execution& execution) {
    const cartesian::Boxes boxes = cartesian::boxesFromVTK(vtkUnstructuredGrid::GetData(input[0]));
    const cartesian::Patches patches =
      cartesian::patchesFromVTK(vtkPolyData::GetData(input[1]), boxes);
    cartesian::CellSpec spec;
    spec.collapseRatio = this->CollapseRatio;
    spec.smallCellRatio = this->SmallCellRatio;
    spec.smallCells =
      this->SmallCells == Merge ? cartesian::SmallCells::Merge : cartesian::SmallCells::Remove;
    spec.mergeRatio = this->MergeRatio;
    spec.splitConcave = this->SplitConcaveCells;
    const cartesian::Assembly assembly(boxes, patches, spec, execution);
    cartesian::toVTK(assembly, cartesian::boundaryNames(vtkDataObject::GetData(input[1])),
      vtkUnstructuredGrid::GetData(output, 0), vtkPolyData::GetData(output, 1), execution);
    this->ReportFlaws(assembly.describeFlaws());
  });
  return 1;
}

void vtkCellAssembler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CollapseRatio: " << this->CollapseRatio << "\n";
  os << indent << "SmallCells: " << this->SmallCells << "\n";
  os << indent << "MergeRatio: " << this->MergeRatio << "\n";
  os << indent << "SplitConcaveCells: " << this->SplitConcaveCells << "\n";
  os << indent << "SmallCellRatio: " << this->SmallCellRatio << "\n";
}

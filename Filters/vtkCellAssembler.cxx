// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellAssembler.h"

#include "BoundaryNames.h"
#include "BoundarySettings.h"
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

void vtkCellAssembler::SetBoundaryName(int row, const char* name)
{
  this->SetRow(this->BoundaryNames, row, std::string(name ? name : ""));
}

void vtkCellAssembler::SetBoundaryType(int row, const char* type)
{
  this->SetRow(this->BoundaryTypes, row, std::string(type ? type : ""));
}

void vtkCellAssembler::SetBoundarySmallCellRatio(int row, double ratio)
{
  this->SetRow(this->BoundaryRatios, row, ratio);
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
    const cartesian::BoundaryNames names =
      cartesian::boundaryNames(vtkDataObject::GetData(input[1]));
    const cartesian::BoundarySettings boundaries{ this->BoundaryNames, this->BoundaryTypes,
      this->BoundaryRatios };
    const auto types = cartesian::boundaryTypes(boundaries, names);
    const auto ratios = cartesian::boundaryRatios(boundaries, names);
    cartesian::CellSpec spec;
    spec.collapseRatio = this->CollapseRatio;
    spec.smallCellRatio = this->SmallCellRatio;
    spec.smallCells =
      this->SmallCells == Merge ? cartesian::SmallCells::Merge : cartesian::SmallCells::Remove;
    spec.mergeRatio = this->MergeRatio;
    spec.splitConcave = this->SplitConcaveCells;
    spec.refusedCellRatio = this->RefusedCellRatio;
    spec.boundaryRatios = &ratios;
    cartesian::planStages(spec, execution);
    const cartesian::Assembly assembly(boxes, patches, spec, execution);
    cartesian::toVTK(assembly, { names, types }, {}, vtkUnstructuredGrid::GetData(output, 0),
      vtkPolyData::GetData(output, 1), execution);
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
  os << indent << "RefusedCellRatio: " << this->RefusedCellRatio << "\n";
  os << indent << "SmallCellRatio: " << this->SmallCellRatio << "\n";
  PrintColumn(os, indent, "BoundaryNames", this->BoundaryNames);
  PrintColumn(os, indent, "BoundaryTypes", this->BoundaryTypes);
  PrintColumn(os, indent, "BoundarySmallCellRatios", this->BoundaryRatios);
}

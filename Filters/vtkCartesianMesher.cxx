// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCartesianMesher.h"

#include "BoundarySettings.h"
#include "MeshToVTK.h"
#include "SurfaceFromVTK.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkCartesianMesher);

vtkCartesianMesher::vtkCartesianMesher()
{
  this->SetNumberOfOutputPorts(3);
}

void vtkCartesianMesher::SetBoundaryName(int row, const char* name)
{
  this->SetRow(this->BoundaryNames, row, std::string(name ? name : ""));
}

void vtkCartesianMesher::SetBoundaryType(int row, const char* type)
{
  this->SetRow(this->BoundaryTypes, row, std::string(type ? type : ""));
}

void vtkCartesianMesher::SetBoundarySmallCellRatio(int row, double ratio)
{
  this->SetRow(this->BoundaryRatios, row, ratio);
}

int vtkCartesianMesher::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

int vtkCartesianMesher::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (IsLeftToFirstProcess(request, output))
  {
    return 1;
  }
  this->Run(0, 1, [&](cartesian::Execution& execution) {
    const cartesian::SurfaceFromVTK surface(vtkDataObject::GetData(input[0]), this->BoundaryArray);
    const cartesian::BoundarySettings boundaries{ this->BoundaryNames, this->BoundaryTypes,
      this->BoundaryRatios };
    const auto types = cartesian::boundaryTypes(boundaries, surface.names());
    const auto ratios = cartesian::boundaryRatios(boundaries, surface.names());
    cartesian::CellSpec spec;
    spec.collapseRatio = this->CollapseRatio;
    spec.smallCellRatio = this->SmallCellRatio;
    spec.smallCells =
      this->SmallCells == Merge ? cartesian::SmallCells::Merge : cartesian::SmallCells::Remove;
    spec.mergeRatio = this->MergeRatio;
    spec.splitConcave = this->SplitConcaveCells;
    spec.boundaryRatios = &ratios;
    cartesian::planStages(spec, execution);
    const cartesian::PreparedSurface prepared = this->Prepare(surface, execution);
    this->Inspect(prepared, surface, vtkPolyData::GetData(output, 2), execution);
    const cartesian::BoxedSurface boxed = this->Divide(surface, prepared, input[1], execution);
    execution.stage("Patches", cartesian::AfterBoxes, cartesian::AfterPatches);
    const cartesian::Patches patches =
      cartesian::generatePatches(prepared.surface, boxed.boxes, boxed.shoeboxes,
        { static_cast<cartesian::PatchMethod>(this->PatchMethod), this->FeatureAngle,
          this->MergeAngle, static_cast<cartesian::Tying>(this->Tying) },
        execution);
    const cartesian::Assembly assembly(boxed.boxes, patches, spec, execution);
    cartesian::toVTK(assembly, { surface.names(), types }, vtkUnstructuredGrid::GetData(output, 0),
      vtkPolyData::GetData(output, 1), execution);
    this->ReportFlaws(assembly.describeFlaws());
  });
  return 1;
}

void vtkCartesianMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PatchMethod: " << this->PatchMethod << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MergeAngle: " << this->MergeAngle << "\n";
  os << indent << "Tying: " << this->Tying << "\n";
  os << indent << "CollapseRatio: " << this->CollapseRatio << "\n";
  os << indent << "SmallCells: " << this->SmallCells << "\n";
  os << indent << "MergeRatio: " << this->MergeRatio << "\n";
  os << indent << "SplitConcaveCells: " << this->SplitConcaveCells << "\n";
  os << indent << "SmallCellRatio: " << this->SmallCellRatio << "\n";
  PrintColumn(os, indent, "BoundaryNames", this->BoundaryNames);
  PrintColumn(os, indent, "BoundaryTypes", this->BoundaryTypes);
  PrintColumn(os, indent, "BoundarySmallCellRatios", this->BoundaryRatios);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellAssembler.h"

#include "AreaWarning.h"
#include "BoundaryNames.h"
#include "BoundarySettings.h"
#include "BoxesVTK.h"
#include "FieldData.h"
#include "FilterOptions.h"
#include "MeshCheck.h"
#include "MeshToVTK.h"
#include "Mesher/Messages.h"
#include "PatchesVTK.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace
{

// The feature angle of the patches; `otherwise` if they have none.
double FeatureAngleOf(vtkPolyData* patches, double otherwise)
{
  if (!patches->GetFieldData()->HasArray(cartesian::FeatureAngleField))
  {
    return otherwise;
  }
  const double angle = cartesian::getField(patches, cartesian::FeatureAngleField, 1)[0];
  cartesian::requireInRange(cartesian::PatchSpec::FeatureAngles, angle, "Feature Angle");
  return angle;
}

}

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
    cartesian::Boxes boxes = cartesian::boxesFromVTK(vtkUnstructuredGrid::GetData(input[0]));
    vtkPolyData* patchData = vtkPolyData::GetData(input[1]);
    cartesian::Patches patches = cartesian::patchesFromVTK(patchData, boxes);
    if (patchData->GetFieldData()->HasArray(cartesian::SurfaceVolumeField))
    {
      patches.surfaceVolume = cartesian::getField(patchData, cartesian::SurfaceVolumeField, 1)[0];
    }
    const cartesian::BoundaryNames names = cartesian::boundaryNames(patchData);
    const cartesian::BoundarySettings boundaries{ this->BoundaryNames, this->BoundaryTypes,
      this->BoundaryRatios, {}, {}, {} };
    const auto types = cartesian::boundaryTypes(boundaries, names, cartesian::NoEnds);
    for (const auto& [boundary, type] : types)
    {
      if (type == cartesian::BaffleType || type == cartesian::ZoneType)
      {
        throw cartesian::Error(cartesian::Fault::BadParameter,
          "Boundary Types has \"" + type +
            "\", which only Cartesian Mesher supports: use it instead of the three steps.");
      }
    }
    cartesian::Options options;
    options.patches.featureAngle = FeatureAngleOf(patchData, options.patches.featureAngle);
    cartesian::setCellOptions(this, options);
    options.smallCells.boundaryRatios =
      cartesian::boundaryRatios(boundaries, names, cartesian::NoEnds, options.smallCells.handling);
    cartesian::planStages(options, execution);
    const auto assembly =
      cartesian::assemble(std::move(boxes), std::move(patches), options, execution);
    cartesian::toVTK(*assembly, { names, types, {} }, {}, vtkUnstructuredGrid::GetData(output, 0),
      vtkPolyData::GetData(output, 1), nullptr, execution);
    vtkUnstructuredGrid* const mesh = vtkUnstructuredGrid::GetData(output, 0);
    const cartesian::MeshCheck check =
      cartesian::checkMesh(mesh, cartesian::Checked::AtWalls, execution);
    cartesian::setFindings(check, mesh);
    this->Warn(cartesian::describeFlaws(*assembly, names));
    this->Warn(cartesian::describeFailures(check, mesh));
    this->Warn(cartesian::describeNoSurface(mesh));
  });
  return 1;
}

void vtkCellAssembler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  cartesian::printCellProperties(this, os, indent);
  PrintColumn(os, indent, "BoundaryNames", this->BoundaryNames);
  this->PrintBoundarySettings(os, indent);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCartesianBoxer.h"

#include "BoxesVTK.h"
#include "DefectsToVTK.h"
#include "Mesher/Mesher.h"
#include "Parts/Decomposition.h"
#include "SizesFromVTK.h"
#include "SurfaceFromVTK.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkCartesianBoxer);

int vtkCartesianBoxer::FillOutputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

int vtkCartesianBoxer::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (IsLeftToFirstProcess(request, output))
  {
    return 1;
  }
  this->Run(0, cartesian::AfterBoxes, [&](cartesian::Execution& execution) {
    vtkDataObject* const data = vtkDataObject::GetData(input[0]);
    const cartesian::SurfaceFromVTK surface = this->Read(data);
    const cartesian::PreparedSurface prepared = this->Prepare(surface, execution);
    const auto decomposition = this->Divide(surface, prepared, Regions(input[1]),
      this->ReadSizes(data, surface, vtkDataObject::GetData(input[2])), execution);
    // Fields of boxes go on to the mesh.
    cartesian::setRepairs(prepared.repair, vtkUnstructuredGrid::GetData(output));
    cartesian::toVTK(decomposition->boxes(decomposition->allLayers(), execution),
      vtkUnstructuredGrid::GetData(output));
  });
  return 1;
}

void vtkCartesianBoxer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceInspector.h"

#include "Mesher/Mesher.h"
#include "SurfaceFromVTK.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkSurfaceInspector);

vtkSurfaceInspector::vtkSurfaceInspector()
{
  this->SetNumberOfInputPorts(1);
}

int vtkSurfaceInspector::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkSurfaceInspector::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (IsLeftToFirstProcess(request, output))
  {
    return 1;
  }
  this->Run(0, cartesian::AfterDefects, [&](cartesian::Execution& execution) {
    const cartesian::SurfaceFromVTK surface = this->Read(vtkDataObject::GetData(input[0]));
    const cartesian::PreparedSurface prepared = this->Prepare(surface, execution);
    this->Inspect(prepared, surface, vtkPolyData::GetData(output), execution);
  });
  return 1;
}

void vtkSurfaceInspector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDividePolyhedra.h"

#include "DividedGrid.h"
#include "FieldData.h"
#include "Mesher/Options.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkDividePolyhedra);

int vtkDividePolyhedra::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkDividePolyhedra::FillOutputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

// Each process divides its own cells.
int vtkDividePolyhedra::RequestUpdateExtent(
  vtkInformation* /*request*/, vtkInformationVector** /*input*/, vtkInformationVector* /*output*/)
{
  return 1;
}

int vtkDividePolyhedra::RequestData(
  vtkInformation* /*request*/, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::GetData(input[0]);
  this->Run(0, 1, [&](cartesian::Execution& execution) {
    cartesian::Options options;
    options.memoryLimit = this->MemoryLimit;
    cartesian::DividedGrid divided(grid, execution);
    divided.check(cartesian::memoryLimitOf(options, 1).bytes);
    divided.write(vtkUnstructuredGrid::GetData(output), execution);
  });
  return 1;
}

void vtkDividePolyhedra::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}

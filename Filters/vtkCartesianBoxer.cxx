// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCartesianBoxer.h"

#include "BoxesVTK.h"
#include "Mesher.h"
#include "SurfaceFromVTK.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "vtksys/SystemInformation.hxx"

namespace
{

constexpr double BytesOfAKiB = 1024;
constexpr double BytesOfAGiB = BytesOfAKiB * BytesOfAKiB * BytesOfAKiB;

// Of the machine's memory, where the user sets no limit.
constexpr double ShareOfMemory = 0.75;

}

vtkStandardNewMacro(vtkCartesianBoxer);

void vtkCartesianBoxer::SetNumberOfMeshlines(int axis, int number)
{
  if (axis < 0 || axis > 2 || number < 0)
  {
    vtkErrorMacro("There is no axis " << axis << " with " << number << " meshlines.");
    return;
  }
  auto& lines = this->Meshlines[axis];
  if (lines.size() != static_cast<std::size_t>(number))
  {
    lines.resize(number, 0.0);
    this->Modified();
  }
}

int vtkCartesianBoxer::GetNumberOfMeshlines(int axis)
{
  return axis < 0 || axis > 2 ? 0 : static_cast<int>(this->Meshlines[axis].size());
}

bool vtkCartesianBoxer::HasMeshline(int axis, int i)
{
  if (i >= 0 && i < this->GetNumberOfMeshlines(axis))
  {
    return true;
  }
  vtkErrorMacro(
    "There is no meshline " << i << " on axis " << axis << ": set the number of meshlines first.");
  return false;
}

void vtkCartesianBoxer::SetMeshline(int axis, int i, double position)
{
  if (this->HasMeshline(axis, i) && this->Meshlines[axis][i] != position)
  {
    this->Meshlines[axis][i] = position;
    this->Modified();
  }
}

double vtkCartesianBoxer::GetMeshline(int axis, int i)
{
  return this->HasMeshline(axis, i) ? this->Meshlines[axis][i] : 0.0;
}

int vtkCartesianBoxer::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkCartesianBoxer::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

cartesian::PreparedSurface vtkCartesianBoxer::Prepare(
  const cartesian::SurfaceFromVTK& surface, cartesian::Execution& execution)
{
  const double limit = this->MemoryLimit > 0
    ? this->MemoryLimit * BytesOfAGiB
    : ShareOfMemory * BytesOfAKiB *
      static_cast<double>(vtksys::SystemInformation().GetHostMemoryTotal());
  const cartesian::GridSpec grid{ this->CellSize, this->Meshlines };
  cartesian::PreparedSurface prepared =
    cartesian::prepareSurface(surface.view(), grid, limit, execution);
  this->ReportFlaws(cartesian::describeFlaws(prepared, surface.cells()));
  return prepared;
}

int vtkCartesianBoxer::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (IsLeftToFirstProcess(request, output))
  {
    return 1;
  }
  this->Run(0, cartesian::AfterBoxes, [&](cartesian::Execution& execution) {
    const cartesian::SurfaceFromVTK surface(vtkPolyData::GetData(input[0]), "");
    const cartesian::PreparedSurface prepared = this->Prepare(surface, execution);
    cartesian::toVTK(
      cartesian::boxSurface(prepared, execution).boxes, vtkUnstructuredGrid::GetData(output));
  });
  return 1;
}

void vtkCartesianBoxer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CellSize: " << this->CellSize << "\n";
  for (int axis = 0; axis < 3; ++axis)
  {
    os << indent << "Meshlines"
       << "XYZ"[axis] << ":";
    for (const double position : this->Meshlines[axis])
    {
      os << " " << position;
    }
    os << "\n";
  }
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}

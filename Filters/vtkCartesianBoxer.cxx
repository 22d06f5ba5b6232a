// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCartesianBoxer.h"

#include "BoxesVTK.h"
#include "DefectsToVTK.h"
#include "Error.h"
#include "Mesher.h"
#include "SurfaceFromVTK.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "vtksys/SystemInformation.hxx"

#include <cmath>
#include <limits>
#include <memory>

namespace
{

constexpr double BytesOfAKiB = 1024;
constexpr double BytesOfAGiB = BytesOfAKiB * BytesOfAKiB * BytesOfAKiB;

// Of the machine's memory, where the user sets no limit.
constexpr double ShareOfMemory = 0.75;

template <class Table>
void PrintTable(ostream& os, vtkIndent indent, const char* name, const Table& table)
{
  os << indent << name << ":\n";
  for (const auto& row : table)
  {
    os << indent.GetNextIndent();
    for (const double value : row)
    {
      os << value << " ";
    }
    os << "\n";
  }
}

// Tables hold doubles; all their numbers are whole.
int WholeNumber(double value, const std::string& where)
{
  if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
  {
    throw cartesian::Error(cartesian::Fault::BadParameter,
      "In " + where + ", " + std::to_string(value) + " is no whole number.");
  }
  return static_cast<int>(value);
}

}

vtkStandardNewMacro(vtkCartesianBoxer);

vtkCartesianBoxer::vtkCartesianBoxer()
{
  this->SetNumberOfInputPorts(2);
}

void vtkCartesianBoxer::SetNumberOfRefinementBlocks(int number)
{
  this->Resize(this->RefinementBlocks, number);
}

void vtkCartesianBoxer::SetRefinementBlock(int row, double firstI, double lastI, double firstJ,
  double lastJ, double firstK, double lastK, double allowed, double forced)
{
  this->SetRow(
    this->RefinementBlocks, row, { firstI, lastI, firstJ, lastJ, firstK, lastK, allowed, forced });
}

void vtkCartesianBoxer::SetNumberOfBoundaryRefinements(int number)
{
  this->Resize(this->BoundaryRefinements, number);
}

void vtkCartesianBoxer::SetBoundaryRefinement(
  int row, double boundary, double depth, double blendLayers, double blendBelow)
{
  this->SetRow(this->BoundaryRefinements, row, { boundary, depth, blendLayers, blendBelow });
}

template <class Row>
void vtkCartesianBoxer::Resize(std::vector<Row>& table, int number)
{
  if (number >= 0 && table.size() != static_cast<std::size_t>(number))
  {
    table.resize(static_cast<std::size_t>(number), Row{});
    this->Modified();
  }
}

template <class Row>
void vtkCartesianBoxer::SetRow(std::vector<Row>& table, int row, const Row& values)
{
  if (row < 0 || static_cast<std::size_t>(row) >= table.size())
  {
    vtkErrorMacro("There is no row " << row << ": set the number of rows first.");
    return;
  }
  if (table[static_cast<std::size_t>(row)] != values)
  {
    table[static_cast<std::size_t>(row)] = values;
    this->Modified();
  }
}

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

int vtkCartesianBoxer::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 1 ? 1 : 0);
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
  const double limit = this->MemoryLimit > 0 ? this->MemoryLimit * BytesOfAGiB
                                             : ShareOfMemory * BytesOfAKiB *
      static_cast<double>(vtksys::SystemInformation().GetHostMemoryTotal());
  const cartesian::GridSpec grid{ this->CellSize, this->Meshlines };
  cartesian::PreparedSurface prepared =
    cartesian::prepareSurface(surface.view(), grid, limit, execution);
  this->ReportFlaws(cartesian::describeFlaws(prepared, surface.cells()));
  return prepared;
}

void vtkCartesianBoxer::Inspect(const cartesian::PreparedSurface& prepared,
  const cartesian::SurfaceFromVTK& surface, vtkPolyData* defects, cartesian::Execution& execution)
{
  execution.stage("Defects of the surface", cartesian::AfterSurface, cartesian::AfterDefects);
  const cartesian::SurfaceDefects found = cartesian::findDefects(
    prepared.surface, prepared.trianglesGiven, prepared.repair, prepared.planes, execution);
  cartesian::toVTK(found, surface.cells(), defects);
  const std::string text = cartesian::describe(found);
  if (!text.empty())
  {
    vtkWarningMacro(<< text);
  }
}

cartesian::BoxedSurface vtkCartesianBoxer::Divide(const cartesian::PreparedSurface& prepared,
  vtkInformationVector* regions, cartesian::Execution& execution)
{
  cartesian::RefinementSpec spec;
  spec.depth = this->RefinementDepth;
  for (std::size_t n = 0; n < this->RefinementBlocks.size(); ++n)
  {
    const std::string name = "row " + std::to_string(n) + " of Refinement Blocks";
    std::array<int, 8> whole;
    for (std::size_t i = 0; i < whole.size(); ++i)
    {
      whole[i] = WholeNumber(this->RefinementBlocks[n][i], name);
    }
    spec.blocks.push_back(
      { { whole[0], whole[2], whole[4] }, { whole[1], whole[3], whole[5] }, whole[6], whole[7] });
  }
  for (std::size_t n = 0; n < this->BoundaryRefinements.size(); ++n)
  {
    const std::string name = "row " + std::to_string(n) + " of Boundary Refinement";
    const std::array<double, 4>& row = this->BoundaryRefinements[n];
    spec.boundaries.push_back({ WholeNumber(row[0], name), WholeNumber(row[1], name),
      WholeNumber(row[2], name), WholeNumber(row[3], name) != 0 });
  }
  std::unique_ptr<cartesian::SurfaceFromVTK> region;
  if (vtkPolyData* input = regions ? vtkPolyData::GetData(regions) : nullptr)
  {
    region = std::make_unique<cartesian::SurfaceFromVTK>(input, "");
    spec.regions.push_back({ region->view(), this->RegionDepth });
  }
  cartesian::BoxedSurface boxed = cartesian::boxSurface(prepared, spec, execution);
  for (const std::string& warning : { cartesian::describeOverhang(prepared), boxed.warnings })
  {
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
  return boxed;
}

int vtkCartesianBoxer::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (IsLeftToFirstProcess(request, output))
  {
    return 1;
  }
  this->Run(0, cartesian::AfterBoxes, [&](cartesian::Execution& execution) {
    const cartesian::SurfaceFromVTK surface(vtkPolyData::GetData(input[0]), this->BoundaryArray);
    const cartesian::PreparedSurface prepared = this->Prepare(surface, execution);
    cartesian::toVTK(
      this->Divide(prepared, input[1], execution).boxes, vtkUnstructuredGrid::GetData(output));
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
  os << indent << "BoundaryArray: " << this->BoundaryArray << "\n";
  os << indent << "RefinementDepth: " << this->RefinementDepth << "\n";
  PrintTable(os, indent, "RefinementBlocks", this->RefinementBlocks);
  PrintTable(os, indent, "BoundaryRefinements", this->BoundaryRefinements);
  os << indent << "RegionDepth: " << this->RegionDepth << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}

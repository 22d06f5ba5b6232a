// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFromVTK.h"

#include "Base/Error.h"
#include "SurfaceBlocks.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTriangleFilter.h"

#include "vtksys/SystemTools.hxx"

#include <cmath>
#include <cstring>
#include <limits>
#include <set>

namespace cartesian
{

namespace
{

constexpr const char* CellIds = "CartesianMesherCellIds";

bool allTriangles(vtkPolyData* input)
{
  return input->GetNumberOfStrips() == 0 && input->GetPolys()->GetMaxCellSize() <= 3;
}

// The same surface in triangles; its array CellIds has the cell of the input that each comes from.
vtkSmartPointer<vtkPolyData> triangulated(vtkPolyData* input)
{
  vtkNew<vtkPolyData> numbered;
  numbered->ShallowCopy(input);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(CellIds);
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    ids->InsertNextValue(i);
  }
  numbered->GetCellData()->AddArray(ids);
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(numbered);
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->Update();
  return filter->GetOutput();
}

// The boundary that a cell array gives for `cell`, which the user knows as `userCell`.
std::int32_t boundaryNumber(vtkDataArray* array, vtkIdType cell, vtkIdType userCell)
{
  const double value = array->GetComponent(cell, 0);
  if (!(std::abs(value) <= std::numeric_limits<std::int32_t>::max()))
  {
    throw Error(Fault::MissingArray,
      std::string("Boundary Array \"") + array->GetName() + "\" holds " + number(value) +
        " at cell " + std::to_string(userCell) + ", which is no boundary number.");
  }
  return static_cast<std::int32_t>(std::lround(value));
}

// Blocks are called like the files that they were read from.
std::string withoutSuffix(const std::string& name)
{
  for (const char* suffix : { ".stl", ".obj", ".ply", ".vtp", ".vtk" })
  {
    if (name.size() > std::strlen(suffix) &&
      vtksys::SystemTools::StringEndsWith(vtksys::SystemTools::LowerCase(name), suffix))
    {
      return name.substr(0, name.size() - std::strlen(suffix));
    }
  }
  return name;
}

// The array that numbers the boundaries of a surface that is no blocks, where none is chosen; or null.
const char* boundaryArrayOf(vtkPolyData* surface)
{
  for (const char* name : { StlSolids, BoundaryIdArray })
  {
    if (surface->GetCellData()->HasArray(name))
    {
      return name;
    }
  }
  return nullptr;
}

}

SurfaceFromVTK::SurfaceFromVTK(vtkDataObject* input, const std::string& boundaryArray)
{
  const std::vector<SurfaceBlock> blocks = surfaceBlocks(input);
  const bool isWhole = blocks.front().surface == input;
  const bool isChosen = !boundaryArray.empty() && boundaryArray != AutomaticBoundaries;
  const char* const found = isWhole ? boundaryArrayOf(blocks.front().surface) : nullptr;
  names_ = isWhole ? boundaryNames(input) : BoundaryNames();
  for (const SurfaceBlock& block : blocks)
  {
    readTriangles(block.surface);
    if (isChosen || found)
    {
      readBoundaries(block.surface, isChosen ? boundaryArray : found);
    }
    else if (isWhole)
    {
      boundary_.resize(cells_.size(), 0);
    }
    else
    {
      const std::string name = block.name.empty()
        ? "block_" + std::to_string(&block - blocks.data())
        : withoutSuffix(block.name);
      boundary_.resize(cells_.size(), numberOf(name));
    }
    cellsBefore_ += block.surface->GetNumberOfCells();
  }
  for (const std::int32_t boundary : std::set<std::int32_t>(boundary_.begin(), boundary_.end()))
  {
    names_.emplace(boundary, unnamedBoundary(boundary));
  }
}

void SurfaceFromVTK::readTriangles(vtkPolyData* block)
{
  const std::size_t pointsBefore = points_.size() / 3;
  if (pointsBefore + static_cast<std::size_t>(block->GetNumberOfPoints()) >=
    std::numeric_limits<std::uint32_t>::max())
  {
    throw Error(
      Fault::BadParameter, "The surface has more points than can be numbered in 32 bits.");
  }
  vtkSmartPointer<vtkPolyData> surface = block;
  vtkIdTypeArray* ids = nullptr;
  if (!allTriangles(block))
  {
    surface = triangulated(block);
    ids = vtkIdTypeArray::SafeDownCast(surface->GetCellData()->GetArray(CellIds));
  }
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  auto cell = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  triangles_.reserve(triangles_.size() + 3 * static_cast<std::size_t>(surface->GetNumberOfPolys()));
  cells_.reserve(cells_.size() + static_cast<std::size_t>(surface->GetNumberOfPolys()));
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(size, corners);
    if (size != 3)
    {
      continue; // a polygon of fewer corners has no area
    }
    for (int i = 0; i < 3; ++i)
    {
      triangles_.push_back(
        static_cast<std::uint32_t>(pointsBefore + static_cast<std::size_t>(corners[i])));
    }
    const vtkIdType id = before + cell->GetCurrentCellId();
    cells_.push_back(cellsBefore_ + (ids ? ids->GetValue(id) : id));
  }
  points_.resize(points_.size() + 3 * static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, points_.data() + 3 * (pointsBefore + static_cast<std::size_t>(i)));
  }
}

void SurfaceFromVTK::readBoundaries(vtkPolyData* block, const std::string& name)
{
  vtkAbstractArray* array = block->GetCellData()->GetAbstractArray(name.c_str());
  auto* strings = vtkStringArray::SafeDownCast(array);
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if ((!strings && !numbers) || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != block->GetNumberOfCells())
  {
    throw Error(Fault::MissingArray,
      "Boundary Array \"" + name +
        "\" is no cell array of the surface with one number or string a cell: choose another, or "
        "none.");
  }
  for (std::size_t t = boundary_.size(); t < cells_.size(); ++t)
  {
    const vtkIdType cell = cells_[t] - cellsBefore_;
    boundary_.push_back(
      strings ? numberOf(strings->GetValue(cell)) : boundaryNumber(numbers, cell, cells_[t]));
  }
}

std::int32_t SurfaceFromVTK::numberOf(const std::string& name)
{
  const auto [place, isNew] = numbers_.emplace(name, static_cast<std::int32_t>(numbers_.size()));
  if (isNew)
  {
    names_[place->second] = name;
  }
  return place->second;
}

SurfaceView SurfaceFromVTK::view() const
{
  return { points_.data(), points_.size() / 3, triangles_.data(), cells_.size(), boundary_.data(),
    cells_.data() };
}

}

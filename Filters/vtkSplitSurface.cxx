// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSplitSurface.h"

#include "FieldData.h"
#include "SplitNames.h"
#include "SurfaceFromVTK.h"
#include "SurfaceParts.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkExtractSelection.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <numeric>

vtkStandardNewMacro(vtkSplitSurface);

namespace
{

static_assert(static_cast<int>(cartesian::SplitBy::Boundaries) == vtkSplitSurface::BOUNDARIES);

// Lines first: SharpEdgeArray of triangles and lines that know them.
void SetSharpEdges(const cartesian::SurfaceView& view, vtkPolyData* output)
{
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkUnsignedCharArray> sharp;
  sharp->SetName(cartesian::SharpEdgeArray);
  for (std::size_t i = 0; i < view.sharpEdgeCount; ++i)
  {
    lines->InsertNextCell(
      { vtkIdType(view.sharpEdges[2 * i]), vtkIdType(view.sharpEdges[2 * i + 1]) });
    sharp->InsertNextValue(1);
  }
  for (std::size_t t = 0; t < view.triangleCount; ++t)
  {
    sharp->InsertNextValue(view.knowsEdges[t] != 0 ? 0 : 1);
  }
  output->SetLines(lines);
  output->GetCellData()->AddArray(sharp);
}

// The triangles of several blocks in one piece, after the lines that are their sharp edges.
void SetTriangles(const cartesian::SurfaceView& view, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(view.pointCount));
  for (std::size_t i = 0; i < view.pointCount; ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), view.points + 3 * i);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(
    static_cast<vtkIdType>(view.triangleCount), 3 * static_cast<vtkIdType>(view.triangleCount));
  for (std::size_t t = 0; t < view.triangleCount; ++t)
  {
    triangles->InsertNextCell({ vtkIdType(view.triangles[3 * t]),
      vtkIdType(view.triangles[3 * t + 1]), vtkIdType(view.triangles[3 * t + 2]) });
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  if (view.knowsEdges)
  {
    SetSharpEdges(view, output);
  }
}

// After the lines. Nothing if there are none.
void SetOpenBodies(const std::vector<std::uint8_t>& open, vtkPolyData* output)
{
  if (open.empty())
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> cells;
  cells->SetName(cartesian::OpenBodyArray);
  cells->SetNumberOfValues(output->GetNumberOfCells());
  cells->Fill(0);
  std::copy(open.begin(), open.end(), cells->GetPointer(output->GetNumberOfLines()));
  output->GetCellData()->AddArray(cells);
}

// Which cells are selected.
std::vector<bool> selectedCells(vtkPolyData* surface, vtkSelection* selection)
{
  vtkNew<vtkExtractSelection> extraction;
  extraction->PreserveTopologyOn();
  extraction->SetInputData(0, surface);
  extraction->SetInputData(1, selection);
  extraction->Update();
  auto* output = vtkPolyData::SafeDownCast(extraction->GetOutputDataObject(0));
  vtkDataArray* inside = output ? output->GetCellData()->GetArray("vtkInsidedness") : nullptr;
  std::vector<bool> cells(static_cast<std::size_t>(surface->GetNumberOfCells()));
  for (std::size_t i = 0; inside && i < cells.size(); ++i)
  {
    cells[i] = inside->GetTuple1(static_cast<vtkIdType>(i)) > 0;
  }
  return cells;
}

// Gives lines that are edges of the surface the boundary of a polygon beside them, where there are such: the lowest.
void AddLines(vtkPolyData* surface, std::vector<std::int32_t>& ofCells)
{
  vtkNew<vtkPolyData> linked;
  linked->CopyStructure(surface);
  linked->BuildLinks();
  vtkNew<vtkIdList> beside;
  vtkIdType cell = surface->GetNumberOfVerts();
  auto line = vtk::TakeSmartPointer(surface->GetLines()->NewIterator());
  for (line->GoToFirstCell(); !line->IsDoneWithTraversal(); line->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    line->GetCurrentCell(size, points);
    std::int32_t& lowest = ofCells[static_cast<std::size_t>(cell)];
    for (vtkIdType i = 1; i < size; ++i)
    {
      linked->GetCellEdgeNeighbors(cell, points[i - 1], points[i], beside);
      for (vtkIdType n = 0; n < beside->GetNumberOfIds(); ++n)
      {
        const std::int32_t other = ofCells[static_cast<std::size_t>(beside->GetId(n))];
        lowest = other >= 0 && (lowest < 0 || other < lowest) ? other : lowest;
      }
    }
  }
}

void SetBoundaries(const cartesian::SurfaceParts& parts, vtkPolyData* output)
{
  const std::vector<std::string> names = parts.names();
  std::vector<std::int32_t> ofCells = parts.ofCells(output->GetNumberOfCells());
  if (output->GetCellData()->HasArray(cartesian::SharpEdgeArray))
  {
    AddLines(output, ofCells);
  }
  vtkNew<vtkIntArray> ids;
  ids->SetName(cartesian::BoundaryIdArray);
  ids->SetNumberOfValues(static_cast<vtkIdType>(ofCells.size()));
  vtkNew<vtkStringArray> texts;
  texts->SetName("BoundaryName");
  texts->SetNumberOfValues(static_cast<vtkIdType>(ofCells.size()));
  const std::string none = cartesian::unnamedBoundary(cartesian::NoBoundary);
  for (std::size_t i = 0; i < ofCells.size(); ++i)
  {
    ids->SetValue(static_cast<vtkIdType>(i), ofCells[i]);
    texts->SetValue(static_cast<vtkIdType>(i),
      ofCells[i] < 0 ? none : names[static_cast<std::size_t>(ofCells[i])]);
  }
  output->GetCellData()->RemoveArray(cartesian::StlSolids);
  output->GetCellData()->AddArray(ids);
  output->GetCellData()->AddArray(texts);
  cartesian::BoundaryNames numbered;
  for (const std::string& name : names)
  {
    numbered.emplace(static_cast<std::int32_t>(numbered.size()), name);
  }
  cartesian::setBoundaryNames(output, numbered);
}

// Caps that are walls in a case, if there are any.
void TellOfWalls(const std::string& caps)
{
  if (!caps.empty())
  {
    vtkOutputWindowDisplayText(("Split Surface: the flat ends " + caps +
      " will be walls. If flow passes through them, let their names begin with inlet or outlet: "
      "Cap Names "
      "has them by size, such as \"outlet, inlet\".\n")
                                 .c_str());
  }
}

std::vector<double> AreasOf(const cartesian::SurfaceView& view)
{
  std::vector<double> areas(view.triangleCount);
  for (std::size_t t = 0; t < view.triangleCount; ++t)
  {
    const auto c = view.corners(t);
    areas[t] = cartesian::norm(
                 cartesian::cross(cartesian::minus(c[1], c[0]), cartesian::minus(c[2], c[0]))) /
      2;
  }
  return areas;
}

}

vtkSplitSurface::vtkSplitSurface()
{
  this->SetNumberOfInputPorts(2);
}

int vtkSplitSurface::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    AcceptAnything(info);
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
  return 1;
}

int vtkSplitSurface::FillOutputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkSplitSurface::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  this->FoundBoundaries->Reset();
  if (IsLeftToFirstProcess(request, output))
  {
    return 1;
  }
  this->Run(0, 1, [&](cartesian::Execution& execution) {
    vtkDataObject* data = vtkDataObject::GetData(input[0]);
    const cartesian::SurfaceFromVTK surface(data, this->BoundaryArray);
    this->Warn(surface.describeLeftOut());
    vtkNew<vtkPolyData> result;
    std::vector<vtkIdType> cells = surface.cells();
    if (auto* whole = vtkPolyData::SafeDownCast(data))
    {
      result->ShallowCopy(whole);
    }
    else
    {
      SetTriangles(surface.view(), result);
      SetOpenBodies(surface.openBodies(), result);
      std::iota(cells.begin(), cells.end(), result->GetNumberOfLines());
    }
    const cartesian::SplitSpec spec{ static_cast<cartesian::SplitBy>(this->SplitBy),
      this->FeatureAngle };
    const cartesian::SurfaceSplit split = cartesian::splitSurface(surface.view(), spec, execution);
    const std::vector<std::string> bases =
      cartesian::baseNames(split, surface.names(), spec.by, this->CapNames);
    cartesian::SurfaceParts parts(split, cartesian::numbered(bases), cells);
    const std::vector<bool> selected = this->Selected(result, vtkSelection::GetData(input[1]));
    if (!selected.empty())
    {
      parts.select(selected, this->SelectWholePatches, this->SelectionName);
      parts.nameLeft(
        cartesian::numbered(bases, parts.areGone(this->SelectionName), this->SelectionName),
        this->SelectionName);
    }
    cartesian::BoundarySettings settings;
    settings.names = this->BoundaryNames;
    settings.mergedNames = this->BoundaryMergedNames;
    parts.rename(settings);
    SetBoundaries(parts, result);
    TellOfWalls(
      cartesian::describeWalledCaps(split, spec.by, bases, this->CapNames, parts.namesOfPatches()));
    this->Describe(parts, AreasOf(surface.view()), result);
    vtkPolyData::GetData(output)->ShallowCopy(result);
  });
  return 1;
}

std::vector<bool> vtkSplitSurface::Selected(vtkPolyData* surface, vtkSelection* selection) const
{
  std::vector<bool> cells = selection ? selectedCells(surface, selection) : std::vector<bool>();
  if (!this->SelectedCells.empty())
  {
    cells.resize(static_cast<std::size_t>(surface->GetNumberOfCells()));
  }
  for (const int cell : this->SelectedCells)
  {
    if (cell < 0 || cell >= surface->GetNumberOfCells())
    {
      throw cartesian::Error(cartesian::Fault::BadParameter,
        "Selected Cells has cell " + std::to_string(cell) + ", but the surface has " +
          std::to_string(surface->GetNumberOfCells()) + " cells: select them anew.");
    }
    cells[static_cast<std::size_t>(cell)] = true;
  }
  return cells;
}

void vtkSplitSurface::Describe(
  const cartesian::SurfaceParts& parts, const std::vector<double>& areas, vtkPolyData* output)
{
  const std::vector<std::string> names = parts.names();
  const std::vector<std::string> former = parts.formerNames();
  const std::vector<std::int32_t> of = parts.ofTriangles();
  std::vector<double> area(names.size());
  std::vector<double> triangles(names.size());
  for (std::size_t t = 0; t < of.size(); ++t)
  {
    area[static_cast<std::size_t>(of[t])] += areas[t];
    triangles[static_cast<std::size_t>(of[t])] += 1;
  }
  cartesian::setField(output, "BoundaryAreas", area);
  cartesian::setField(output, "BoundaryFaceCounts", triangles);
  for (const char* title : { "Boundary", "Before", "Area", "Triangles" })
  {
    this->FoundBoundaries->InsertNextValue(title);
  }
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    this->FoundBoundaries->InsertNextValue(names[i]);
    this->FoundBoundaries->InsertNextValue(former[i]);
    this->FoundBoundaries->InsertNextValue(cartesian::number(area[i]));
    this->FoundBoundaries->InsertNextValue(std::to_string(static_cast<long long>(triangles[i])));
  }
}

vtkStringArray* vtkSplitSurface::GetFoundBoundaries()
{
  return this->FoundBoundaries;
}

void vtkSplitSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SplitBy: " << this->SplitBy << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "CapNames: " << this->CapNames << "\n";
  os << indent << "BoundaryArray: " << this->BoundaryArray << "\n";
  PrintColumn(os, indent, "SelectedCells", this->SelectedCells);
  os << indent << "SelectionName: " << this->SelectionName << "\n";
  os << indent << "SelectWholePatches: " << this->SelectWholePatches << "\n";
  PrintColumn(os, indent, "BoundaryNames", this->BoundaryNames);
  PrintColumn(os, indent, "BoundaryMergedNames", this->BoundaryMergedNames);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "PreviewToVTK.h"

#include "vtkAppendPolyData.h"
#include "vtkArrowSource.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkOutlineSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <utility>

namespace cartesian
{

namespace
{

// Of the box, along the flow.
constexpr double LengthOfArrow = 0.15;
constexpr double GapBeforeInlet = 0.02;

constexpr int Facets = 24; // of the arrow, once around

std::array<double, 3> centreOf(const Bounds& box)
{
  std::array<double, 3> centre{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    centre[axis] = (box.low[axis] + box.high[axis]) / 2;
  }
  return centre;
}

// `side`: in the order of DomainSide.
std::array<double, 3> centreOfSide(const Bounds& box, std::size_t side)
{
  std::array<double, 3> centre = centreOf(box);
  centre[side / 2] = (side % 2 == 0 ? box.low : box.high)[side / 2];
  return centre;
}

vtkSmartPointer<vtkPolyData> arrowTo(const Bounds& box, FlowDirection flow)
{
  const auto inlet = static_cast<std::size_t>(flow);
  const std::array<double, 3> along = unitAlong(flow);
  const double length = box.high[inlet / 2] - box.low[inlet / 2];
  std::array<double, 3> tail = centreOfSide(box, inlet);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    tail[axis] -= (LengthOfArrow + GapBeforeInlet) * length * along[axis];
  }
  vtkNew<vtkArrowSource> arrow; // along x, of length 1
  arrow->SetShaftResolution(Facets);
  arrow->SetTipResolution(Facets);
  vtkNew<vtkTransform> place;
  place->Translate(tail.data());
  if (inlet / 2 == 1)
  {
    place->RotateZ(90 * along[1]);
  }
  else if (inlet / 2 == 2)
  {
    place->RotateY(-90 * along[2]);
  }
  else if (along[0] < 0)
  {
    place->RotateZ(180);
  }
  place->Scale(LengthOfArrow * length, LengthOfArrow * length, LengthOfArrow * length);
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputConnection(arrow->GetOutputPort());
  filter->SetTransform(place);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  return filter->GetOutput();
}

std::string inText(double value)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

}

void surfaceToVTK(const SurfaceView& view, const ExpectedDepths& expected, vtkPolyData* surface)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(view.pointCount));
  std::copy(view.points, view.points + 3 * view.pointCount, coordinates->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(
    static_cast<vtkIdType>(view.triangleCount), static_cast<vtkIdType>(3 * view.triangleCount));
  for (std::size_t t = 0; t < view.triangleCount; ++t)
  {
    triangles->InsertNextCell({ vtkIdType(view.triangles[3 * t]),
      vtkIdType(view.triangles[3 * t + 1]), vtkIdType(view.triangles[3 * t + 2]) });
  }
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  if (expected.depths.empty())
  {
    return;
  }
  vtkNew<vtkIntArray> depths;
  depths->SetName(DepthArray);
  depths->SetNumberOfTuples(static_cast<vtkIdType>(expected.depths.size()));
  std::copy(expected.depths.begin(), expected.depths.end(), depths->GetPointer(0));
  vtkNew<vtkDoubleArray> sizes;
  sizes->SetName(BoxSizeArray);
  sizes->SetNumberOfTuples(static_cast<vtkIdType>(expected.sizes.size()));
  std::copy(expected.sizes.begin(), expected.sizes.end(), sizes->GetPointer(0));
  surface->GetCellData()->AddArray(depths);
  surface->GetCellData()->AddArray(sizes);
}

void domainToVTK(const Bounds& box, FlowDirection flow, vtkPolyData* domain)
{
  vtkNew<vtkOutlineSource> edges;
  edges->SetBounds(box.low[0], box.high[0], box.low[1], box.high[1], box.low[2], box.high[2]);
  edges->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  edges->Update();
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(edges->GetOutput());
  both->AddInputData(arrowTo(box, flow));
  both->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  both->Update();
  domain->CopyStructure(both->GetOutput());
}

void labelsToVTK(const Bounds& box, const DomainSpec& domain, vtkPolyData* labels)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkStringArray> texts;
  texts->SetName(LabelArray);
  const auto add = [&](const std::array<double, 3>& at, const std::string& text) {
    vertices->InsertNextCell({ points->InsertNextPoint(at.data()) });
    texts->InsertNextValue(text);
  };
  if (domain.isOutside())
  {
    const std::array<std::string, 6> names = namesOfSides(domain);
    for (std::size_t side = 0; side < names.size(); ++side)
    {
      add(centreOfSide(box, side), names[side]);
    }
  }
  for (const std::array<double, 3>& point : domain.keepPoints)
  {
    add(point, "keep");
  }
  labels->SetPoints(points);
  labels->SetVerts(vertices);
  labels->GetPointData()->AddArray(texts);
}

void zonesToVTK(const std::vector<ZoneShape>& shapes, vtkPolyData* zones)
{
  vtkNew<vtkAppendPolyData> all;
  all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkIntArray> depths;
  depths->SetName(DepthArray);
  for (const ZoneShape& zone : shapes)
  {
    vtkNew<vtkPolyData> polygons;
    polygons->SetPoints(zone.shape->GetPoints());
    polygons->SetPolys(zone.shape->GetPolys());
    all->AddInputData(polygons);
    for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
    {
      depths->InsertNextValue(zone.depth);
    }
  }
  if (shapes.empty())
  {
    return;
  }
  all->Update();
  zones->CopyStructure(all->GetOutput());
  zones->GetCellData()->AddArray(depths);
}

void sizesToVTK(const ExpectedDepths& expected, vtkStringArray* rows)
{
  constexpr double Alike = 1.01;
  std::map<int, std::pair<double, double>> ranges;
  for (std::size_t t = 0; t < expected.depths.size(); ++t)
  {
    if (const double size = expected.sizes[t]; size > 0) // not of a triangle without an area
    {
      auto& [low, high] = ranges.emplace(expected.depths[t], std::pair(size, size)).first->second;
      low = std::min(low, size);
      high = std::max(high, size);
    }
  }
  for (const auto& [depth, range] : ranges)
  {
    const auto& [low, high] = range;
    rows->InsertNextValue(std::to_string(depth));
    rows->InsertNextValue(high <= Alike * low ? inText(high) : inText(low) + " to " + inText(high));
  }
}

}

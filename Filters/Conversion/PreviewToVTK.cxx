// SPDX-License-Identifier: BSD-3-Clause
#include "PreviewToVTK.h"

#include "vtkAppendPolyData.h"
#include "vtkArrowSource.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkContourFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFeatureEdges.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkOutlineSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>

namespace cartesian
{

namespace
{

// Of the box, along the flow.
constexpr double LengthOfArrow = 0.15;
constexpr double GapBeforeInlet = 0.02;

constexpr std::size_t MostHalved = 200000; // pieces of a surface

// Of the arrow, by its length; facets once around.
constexpr double ShaftRadius = 0.06;
constexpr double TipRadius = 0.18;
constexpr int Facets = 24;

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
  arrow->SetShaftRadius(ShaftRadius);
  arrow->SetTipRadius(TipRadius);
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

using Points = std::vector<std::array<double, 3>>;

// Of the first edge of a triangle.
double lengthOf(const std::array<vtkIdType, 3>& triangle, const Points& points)
{
  const auto& p = points[static_cast<std::size_t>(triangle[0])];
  const auto& q = points[static_cast<std::size_t>(triangle[1])];
  return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
}

std::array<double, 3> middleOf(const std::array<vtkIdType, 3>& triangle, const Points& points)
{
  const auto& p = points[static_cast<std::size_t>(triangle[0])];
  const auto& q = points[static_cast<std::size_t>(triangle[1])];
  return { (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2 };
}

// The same triangle.
std::array<vtkIdType, 3> longestEdgeFirst(std::array<vtkIdType, 3> triangle, const Points& points)
{
  std::array<vtkIdType, 3> result = triangle;
  for (int i = 0; i < 2; ++i)
  {
    std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
    result = lengthOf(triangle, points) > lengthOf(result, points) ? triangle : result;
  }
  return result;
}

// Where it is cut in the middle, along an axis. (vtkCutter tells the user each time that it cuts.)
vtkSmartPointer<vtkPolyData> sectionOf(vtkPolyData* shape, int axis)
{
  vtkNew<vtkDoubleArray> heights;
  for (vtkIdType i = 0; i < shape->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(shape->GetPoint(i)[axis]);
  }
  vtkNew<vtkPolyData> withHeights;
  withHeights->CopyStructure(shape);
  withHeights->GetPointData()->SetScalars(heights);
  vtkNew<vtkContourFilter> section;
  section->SetInputData(withHeights);
  section->SetValue(0, shape->GetCenter()[axis]);
  section->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  section->Update();
  return section->GetOutput();
}

// The sharp edges of a shape; of a round one, sections.
vtkSmartPointer<vtkPolyData> linesOf(vtkPolyData* shape)
{
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(shape->GetPoints());
  polygons->SetPolys(shape->GetPolys());
  vtkNew<vtkCleanPolyData> joined; // sides of a box have corners of their own
  joined->SetInputData(polygons);
  joined->SetTolerance(0);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(joined->GetOutputPort());
  edges->ColoringOff();
  edges->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  edges->Update();
  vtkNew<vtkPolyData> lines;
  lines->CopyStructure(edges->GetOutput());
  if (lines->GetNumberOfCells() > 0)
  {
    return lines;
  }
  vtkNew<vtkAppendPolyData> sections;
  for (int axis = 0; axis < 3; ++axis)
  {
    sections->AddInputData(sectionOf(polygons, axis));
  }
  sections->Update();
  lines->CopyStructure(sections->GetOutput());
  return lines;
}

std::string inText(double value)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

}

std::vector<std::array<double, 3>> SurfacePieces::centres() const
{
  std::vector<std::array<double, 3>> centres;
  centres.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles)
  {
    const auto& p = points[static_cast<std::size_t>(a)];
    const auto& q = points[static_cast<std::size_t>(b)];
    const auto& r = points[static_cast<std::size_t>(c)];
    centres.push_back(
      { (p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3, (p[2] + q[2] + r[2]) / 3 });
  }
  return centres;
}

SurfacePieces piecesOf(const SurfaceView& view, double along)
{
  SurfacePieces pieces;
  for (std::size_t i = 0; i < view.pointCount; ++i)
  {
    pieces.points.push_back({ view.points[3 * i], view.points[3 * i + 1], view.points[3 * i + 2] });
  }
  const double longest =
    along > 0 ? boundsOf(view).longest() / along : std::numeric_limits<double>::max();
  std::vector<std::array<vtkIdType, 3>> parts; // of one triangle, not small enough
  for (std::size_t t = 0; t < view.triangleCount; ++t)
  {
    const std::uint32_t* corner = view.triangles + 3 * t;
    parts.push_back({ corner[0], corner[1], corner[2] });
    if (pieces.triangles.size() > view.triangleCount + MostHalved)
    {
      return piecesOf(view, along > 1 ? along / 2 : 0);
    }
    while (!parts.empty())
    {
      const std::array<vtkIdType, 3> part = longestEdgeFirst(parts.back(), pieces.points);
      parts.pop_back();
      if (lengthOf(part, pieces.points) <= longest)
      {
        pieces.triangles.push_back(part);
        continue;
      }
      const auto middle = static_cast<vtkIdType>(pieces.points.size());
      pieces.points.push_back(middleOf(part, pieces.points));
      parts.push_back({ part[0], middle, part[2] });
      parts.push_back({ middle, part[1], part[2] });
    }
  }
  return pieces;
}

void surfaceToVTK(const SurfacePieces& pieces, const ExpectedDepths& expected, vtkPolyData* surface)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(pieces.points.size()));
  for (std::size_t i = 0; i < pieces.points.size(); ++i)
  {
    coordinates->SetTypedTuple(static_cast<vtkIdType>(i), pieces.points[i].data());
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkCellArray> triangles;
  const auto count = static_cast<vtkIdType>(pieces.triangles.size());
  triangles->AllocateExact(count, 3 * count);
  for (const std::array<vtkIdType, 3>& triangle : pieces.triangles)
  {
    triangles->InsertNextCell(3, triangle.data());
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
  for (const std::array<double, 3>& point : domain.keepOut)
  {
    add(point, "keep out");
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
    const vtkSmartPointer<vtkPolyData> lines = linesOf(zone.shape);
    all->AddInputData(lines);
    for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
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

void sizesToVTK(
  const ExpectedDepths& expected, const std::vector<ZoneShape>& zones, vtkStringArray* rows)
{
  constexpr double Alike = 1.01;
  using Sizes = std::pair<double, double>; // the least and the largest
  std::map<int, Sizes> ofDepths;
  Sizes undivided{ std::numeric_limits<double>::max(), 0 };
  const auto include = [](Sizes& sizes, double size) {
    sizes = { std::min(sizes.first, size), std::max(sizes.second, size) };
  };
  for (std::size_t t = 0; t < expected.depths.size(); ++t)
  {
    const double size = expected.sizes[t];
    include(ofDepths.emplace(expected.depths[t], Sizes{ size, size }).first->second, size);
    include(undivided, std::ldexp(size, expected.depths[t]));
  }
  for (const ZoneShape& zone : zones)
  {
    if (undivided.second > 0)
    {
      ofDepths.emplace(zone.depth,
        Sizes{
          std::ldexp(undivided.first, -zone.depth), std::ldexp(undivided.second, -zone.depth) });
    }
  }
  for (const auto& [depth, sizes] : ofDepths)
  {
    const auto& [least, largest] = sizes;
    rows->InsertNextValue(std::to_string(depth));
    rows->InsertNextValue(
      largest <= Alike * least ? inText(largest) : inText(least) + " to " + inText(largest));
  }
}

}

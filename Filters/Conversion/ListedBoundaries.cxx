// SPDX-License-Identifier: BSD-3-Clause
#include "ListedBoundaries.h"

#include "Base/NamePatterns.h"
#include "Lattice/Vector.h"
#include "SurfaceFromVTK.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

constexpr double DistanceBySize = 0.002; // of what covers the surface

std::int32_t boundaryOf(const SurfaceView& view, std::size_t triangle)
{
  return view.boundary ? view.boundary[triangle] : 0;
}

Vector normalOf(const std::array<Vector, 3>& corners) // twice as long as the area
{
  return cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
}

double sizeOf(const SurfaceView& view)
{
  vtkBoundingBox box;
  for (std::size_t i = 0; i < view.pointCount; ++i)
  {
    box.AddPoint(view.points[3 * i], view.points[3 * i + 1], view.points[3 * i + 2]);
  }
  return box.IsValid() ? box.GetMaxLength() : 0;
}

void addTriangle(const std::array<Vector, 3>& corners, const Vector& shift, vtkPolyData* triangles)
{
  std::array<vtkIdType, 3> points{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    points[i] = triangles->GetPoints()->InsertNextPoint(plus(corners[i], shift).data());
  }
  triangles->GetPolys()->InsertNextCell(3, points.data());
}

// How far along the way a triangle is, from 0 to 1; 2: it is not there.
double distanceAlong(const Vector& from, const Vector& way, const std::array<Vector, 3>& corners)
{
  constexpr double Never = 2;
  const Vector u = minus(corners[1], corners[0]);
  const Vector v = minus(corners[2], corners[0]);
  const Vector h = cross(way, v);
  const double determinant = dot(u, h);
  if (determinant == 0)
  {
    return Never;
  }
  const Vector s = minus(from, corners[0]);
  const Vector q = cross(s, u);
  const double a = dot(s, h) / determinant;
  const double b = dot(way, q) / determinant;
  const double along = dot(v, q) / determinant;
  return a >= 0 && b >= 0 && a + b <= 1 && along >= 0 && along <= 1 ? along : Never;
}

std::string nameOf(const SurfaceFromVTK& surface, std::int32_t boundary)
{
  const auto found = surface.names().find(boundary);
  return found != surface.names().end() ? found->second : unnamedBoundary(boundary);
}

}

std::vector<ListedBoundary> listBoundaries(const SurfaceFromVTK& surface)
{
  std::map<std::int32_t, ListedBoundary> listed;
  for (const auto& [number, name] : surface.names())
  {
    listed.emplace(number, ListedBoundary{ number, name });
  }
  const SurfaceView view = surface.view();
  for (std::size_t i = 0; i < view.triangleCount; ++i)
  {
    const std::int32_t number = boundaryOf(view, i);
    ListedBoundary& boundary =
      listed.emplace(number, ListedBoundary{ number, nameOf(surface, number) }).first->second;
    boundary.area += norm(normalOf(view.corners(i))) / 2;
    ++boundary.triangles;
  }
  std::vector<ListedBoundary> list;
  list.reserve(listed.size());
  for (const auto& [number, boundary] : listed)
  {
    list.push_back(boundary);
  }
  return list;
}

void boundariesToVTK(
  const SurfaceFromVTK& surface, const std::vector<std::string>& patterns, vtkPolyData* triangles)
{
  std::set<std::int32_t> chosen;
  for (const ListedBoundary& boundary : listBoundaries(surface))
  {
    if (std::any_of(patterns.begin(), patterns.end(),
          [&](const std::string& pattern) { return isOf(boundary.name, pattern); }))
    {
      chosen.insert(boundary.number);
    }
  }
  triangles->SetPoints(vtkNew<vtkPoints>());
  triangles->SetPolys(vtkNew<vtkCellArray>());
  const SurfaceView view = surface.view();
  const double distance = DistanceBySize * sizeOf(view);
  for (std::size_t i = 0; i < view.triangleCount; ++i)
  {
    if (chosen.count(boundaryOf(view, i)) > 0)
    {
      const std::array<Vector, 3> corners = view.corners(i);
      const Vector normal = unit(normalOf(corners));
      addTriangle(corners, scaled(normal, distance), triangles);
      addTriangle(corners, scaled(normal, -distance), triangles);
    }
  }
}

std::string boundaryBetween(
  const SurfaceFromVTK& surface, const std::array<double, 3>& from, const std::array<double, 3>& to)
{
  const Vector way = minus(to, from);
  const SurfaceView view = surface.view();
  double nearest = 1;
  std::string name;
  for (std::size_t i = 0; i < view.triangleCount; ++i)
  {
    const double along = distanceAlong(from, way, view.corners(i));
    if (along <= nearest)
    {
      nearest = along;
      name = nameOf(surface, boundaryOf(view, i));
    }
  }
  return name;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "AreaWarning.h"

#include "Base/Error.h"
#include "Lattice/Vector.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace cartesian
{

namespace
{

constexpr double LargestUntold = 0.05; // of the area in the surface
constexpr double OnePlane = 1e-6;      // sine of the angle between normals
constexpr std::size_t MostNamed = 10;

struct FlatBoundary
{
  double area = 0;
  Vector normal{};
  bool isFlat = true;
  bool isInGrid = true;
};

bool isInGrid(const Corners& corners, const Meshlines& planes)
{
  return std::all_of(corners.begin(), corners.end(), [&](const Point& p) {
    bool isIn = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      isIn = isIn && p[axis] >= planes[axis].front() && p[axis] <= planes[axis].back();
    }
    return isIn;
  });
}

// Sides of a flow domain continue the surface's boundaries of their names.
bool isContinued(std::int32_t boundary, const EndBoundaries& sides)
{
  return std::find(sides.begin(), sides.end(), boundary) != sides.end();
}

// By the user's number; those on both sides of a wall are none.
std::map<std::int32_t, FlatBoundary> boundariesOf(const Surface& surface, const Meshlines& planes)
{
  std::map<std::int32_t, FlatBoundary> boundaries;
  const double step = surface.lattice.step();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners c = surface.corners(t);
    const Vector area = scaled(cross(minus(c[1], c[0]), minus(c[2], c[0])), step * step / 2);
    FlatBoundary& boundary = boundaries[surface.walls.boundary(surface.boundary[t])];
    boundary.isFlat = boundary.isFlat && !surface.walls.isInterface(surface.boundary[t]);
    boundary.isInGrid = boundary.isInGrid && isInGrid(c, planes);
    if (norm(area) == 0)
    {
      continue;
    }
    boundary.normal = boundary.area == 0 ? unit(area) : boundary.normal;
    boundary.isFlat = boundary.isFlat && dot(boundary.normal, area) > 0 &&
      norm(cross(boundary.normal, unit(area))) < OnePlane;
    boundary.area += norm(area);
  }
  return boundaries;
}

double areaOf(vtkDataObject* mesh, std::int32_t boundary)
{
  vtkDataArray* const ids = mesh->GetFieldData()->GetArray("BoundaryIds");
  vtkDataArray* const areas = mesh->GetFieldData()->GetArray("BoundaryAreas");
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    if (ids->GetComponent(i, 0) == boundary)
    {
      return areas->GetComponent(i, 0);
    }
  }
  return 0;
}

// With three digits.
std::string brief(double x)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", x);
  return text.data();
}

}

std::string describeNoSurface(vtkDataObject* mesh)
{
  const double area = areaOf(mesh, NoBoundary);
  return area > 0 ? "Faces with an area of " + number(area) + " belong to no boundary: they are " +
      unnamedBoundary(NoBoundary) +
      ", in a case a wall. Close the surface there, or extend the Meshlines."
                  : "";
}

std::string describeWrongAreas(
  const Surface& surface, const Meshlines& planes, const BoundaryNames& names, vtkDataObject* mesh)
{
  constexpr double Percent = 100;
  std::string text;
  std::size_t told = 0;
  for (const auto& [id, boundary] : boundariesOf(surface, planes))
  {
    if (!boundary.isFlat || !boundary.isInGrid || boundary.area == 0 || id == NoBoundary ||
      isContinued(id, surface.ends))
    {
      continue;
    }
    const double area = areaOf(mesh, id);
    const double error = area / boundary.area - 1;
    if (std::abs(error) <= LargestUntold || told++ >= MostNamed)
    {
      continue;
    }
    const auto name = names.find(id);
    text += (text.empty() ? "" : ", ") +
      (name == names.end() ? unnamedBoundary(id) : name->second) + " (" + number(area) +
      " instead of " + number(boundary.area) + ", " + (error > 0 ? "+" : "") +
      brief(Percent * error) + " %)";
  }
  return text.empty() ? ""
                      : "Boxes are too large for the area of flat boundaries: " + text +
      ". Use smaller boxes there (Boundary Refinement), or Exact Fit.";
}

}

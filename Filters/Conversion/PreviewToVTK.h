// SPDX-License-Identifier: BSD-3-Clause
// What will be meshed, as views show it before.
#pragma once

#include "Mesher/ExpectedDepths.h"
#include "Surface/FlowDomain.h"

#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkPolyData;
class vtkStringArray;

namespace cartesian
{

// The cell arrays of the surface and, of zones, Depth.
constexpr const char* DepthArray = "Depth";     // int
constexpr const char* BoxSizeArray = "BoxSize"; // double, user units
constexpr const char* LabelArray = "Label";     // of points

// Triangles of a surface, each small enough to have one colour.
struct SurfacePieces
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<vtkIdType, 3>> triangles;

  std::vector<std::array<double, 3>> centres() const;
};

// Triangles with edges longer than the surface's longest side by `along` are halved, as far as they do not become too many; 0:
// none are.
SurfacePieces piecesOf(const SurfaceView& view, double along);

// `expected`: at the centres of the pieces; without depths, there are no arrays.
void surfaceToVTK(
  const SurfacePieces& pieces, const ExpectedDepths& expected, vtkPolyData* surface);

// The edges of a flow domain, and an arrow that points from upstream to its inlet.
void domainToVTK(const Bounds& box, FlowDirection flow, vtkPolyData* domain);

// Points with a text each: the names of the sides at their centres, and the points to keep.
void labelsToVTK(const Bounds& box, const DomainSpec& domain, vtkPolyData* labels);

struct ZoneShape
{
  vtkPolyData* shape;
  int depth;
};

// Lines: the sharp edges of the shapes, and sections of round ones.
void zonesToVTK(const std::vector<ZoneShape>& shapes, vtkPolyData* zones);

// Two texts a row: each depth that triangles or zones have, ascending, and the sizes of boxes there, as a number or a
// range.
void sizesToVTK(
  const ExpectedDepths& expected, const std::vector<ZoneShape>& zones, vtkStringArray* rows);

}

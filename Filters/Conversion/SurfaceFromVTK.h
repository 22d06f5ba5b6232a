// SPDX-License-Identifier: BSD-3-Clause
// A vtkPolyData as the kernel wants a surface.
#pragma once

#include "Surface.h"

#include "vtkType.h"

#include <string>

class vtkPolyData;

namespace cartesian
{

// Name that vtkSTLReader gives the array of the solids a file names.
constexpr const char* StlSolids = "STLSolidLabeling";

// Triangles copied out of a vtkPolyData: polygons with more corners are triangulated, verts and
// lines left out.
class SurfaceFromVTK
{
public:
  // `boundaryArray`: cell array that numbers the boundaries; empty: StlSolids if there, else all 0.
  // Throws Error: EmptySurface, MissingArray.
  SurfaceFromVTK(vtkPolyData* input, const std::string& boundaryArray);

  SurfaceView view() const;

  // The input's cell that each triangle is, or is a part of.
  const std::vector<vtkIdType>& cells() const { return cells_; }

private:
  void readTriangles(vtkPolyData* input);
  void readBoundaries(vtkPolyData* input, const std::string& boundaryArray);

  std::vector<double> points_;
  std::vector<std::uint32_t> triangles_;
  std::vector<vtkIdType> cells_;
  std::vector<std::int32_t> boundary_;
};

}

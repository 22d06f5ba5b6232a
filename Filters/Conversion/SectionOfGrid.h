// SPDX-License-Identifier: BSD-3-Clause
// Plane sections of a grid (Sections/PlaneSection.h), as VTK has them.
#pragma once

#include "Sections/PlaneSection.h"

#include "vtkType.h"

#include <vector>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace cartesian
{

class SectionOfGrid
{
public:
  // `normal`: of length 1.
  SectionOfGrid(vtkUnstructuredGrid* grid, const Vector& origin, const Vector& normal);

  // The plane at this distance from the origin. Throws Error (BadMesh).
  void add(double offset, Execution& execution);

  // Fills an empty vtkPolyData; vtkSlicePolyhedra.h lists its arrays.
  void write(vtkPolyData* output) const;

private:
  struct Part
  {
    double offset;
    std::vector<vtkIdType> cut; // the cells of the section
    PlaneSection section;
    PointSums sums; // where there are data of points
  };

  void findHeights(Execution& execution);
  std::vector<vtkIdType> cutCells(double offset, Execution& execution) const;
  void writePoints(vtkPolyData* output) const;
  void writePolygons(vtkPolyData* output) const;

  vtkUnstructuredGrid* grid_;
  Vector origin_;
  Vector normal_;
  std::vector<double> copy_;
  const double* points_;
  std::vector<double> heights_; // of points, above the plane at offset 0
  std::vector<double> lowest_;  // of the points of each cell
  std::vector<double> highest_;
  std::vector<Part> parts_;
};

}

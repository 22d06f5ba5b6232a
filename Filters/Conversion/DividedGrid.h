// SPDX-License-Identifier: BSD-3-Clause
// A grid whose polyhedra are divided (Sections/CellDivision.h), as VTK has it.
#pragma once

#include "Sections/CellDivision.h"

#include "vtkType.h"

#include <vector>

class vtkUnstructuredGrid;

namespace cartesian
{

class DividedGrid
{
public:
  // Finds what is divided, and how many parts there will be. Throws Error (BadMesh).
  DividedGrid(vtkUnstructuredGrid* grid, Execution& execution);

  // Throws Error (TooManyBoxes) if the output takes more than these bytes.
  void check(double bytes) const;

  // Fills an empty grid; vtkDividePolyhedra.h lists its arrays.
  void write(vtkUnstructuredGrid* output, Execution& execution);

private:
  void findDivided(Execution& execution);
  void countParts(Execution& execution);
  void writeCells(vtkUnstructuredGrid* output, Execution& execution) const;
  void writePoints(vtkUnstructuredGrid* output) const;
  void writePointData(vtkUnstructuredGrid* output, Execution& execution) const;
  void writeCellData(vtkUnstructuredGrid* output, Execution& execution) const;
  void writeFieldData(vtkUnstructuredGrid* output) const;

  vtkUnstructuredGrid* grid_;
  std::vector<double> copy_;
  const double* points_;
  std::vector<vtkIdType> divided_;      // cells, in order
  std::vector<std::uint32_t> numberOf_; // of each cell among these, or NoPoint: it stays whole
  CellFaces faces_;                     // of those that are divided
  CellDivision division_;
  std::vector<std::size_t> firstPart_;   // of each cell, and the end
  std::vector<std::size_t> firstCorner_; // of each cell's parts, and the end
};

}

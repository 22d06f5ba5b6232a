// SPDX-License-Identifier: BSD-3-Clause
// Grids made anew from the faces of others' cells, with their boundaries (BoundaryOfFaces.h).
#pragma once

#include "BoundaryOfFaces.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"

class vtkPoints;

namespace cartesian
{

// Of faces between two cells.
constexpr vtkIdType InnerFace = UnknownBoundary - 1;

// Of each face of all cells.
struct FaceNeighbours
{
  std::vector<vtkIdType> boundary;   // or InnerFace
  std::vector<std::size_t> opposite; // the same face of another cell, or NoFace
};

// Throws Error (BadMesh): cells were changed since the mesh was made.
FaceNeighbours neighboursOf(
  vtkUnstructuredGrid* grid, const GridFaces& faces, Execution& execution);

// Three coordinates each.
vtkSmartPointer<vtkPoints> pointsOf(const std::vector<double>& coordinates);

// The cells of a grid, in order; those that are no polyhedra come first.
class CellWriter
{
public:
  void addHexahedron(const std::array<vtkIdType, 8>& points);
  void addPolyhedron(const CellFaces& cells, std::size_t cell);
  void finish(vtkUnstructuredGrid* grid);

private:
  vtkNew<vtkUnsignedCharArray> types_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkIdTypeArray> starts_;
  vtkNew<vtkIdTypeArray> stream_;
  std::vector<vtkIdType> points_; // of the last cell
};

// The boundaries' names and types, by number.
class BoundaryTable
{
public:
  explicit BoundaryTable(vtkUnstructuredGrid* grid);

  void add(vtkIdType number, const std::string& name, const std::string& type)
  {
    names_[number] = name;
    types_[number] = type;
  }
  const std::map<vtkIdType, std::string>& names() const { return names_; }
  vtkIdType last() const { return names_.empty() ? vtkIdType(NoBoundary) : names_.rbegin()->first; }

  // Sets the field data arrays BoundaryOfFaces, of these rows, BoundaryIds, BoundaryNames and BoundaryTypes, of those that
  // have faces.
  void write(const std::vector<BoundaryFaceRow>& rows, vtkUnstructuredGrid* grid);

private:
  std::map<vtkIdType, std::string> names_;
  std::map<vtkIdType, std::string> types_;
};

}

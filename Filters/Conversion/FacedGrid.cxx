// SPDX-License-Identifier: BSD-3-Clause
#include "FacedGrid.h"

#include "Base/Error.h"
#include "PolyhedronStorage.h"
#include "Sections/SideFaces.h"

#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <set>

namespace cartesian
{

FaceNeighbours neighboursOf(vtkUnstructuredGrid* grid, const GridFaces& faces, Execution& execution)
{
  FaceList list = listFaces(faces.cells, faces.points.size() / 3, Clashes::Refused, execution);
  std::vector<vtkIdType> outer;
  if (readBoundaryOfFaces(grid, faces.cells, faces.cellOf, list, outer, execution) ==
    BoundaryKnowledge::Unfit)
  {
    throw Error(Fault::BadMesh,
      "Cells were cut or merged after meshing, so the mesh has lost its boundaries: connect the "
      "output of Cartesian Mesher itself.");
  }
  const std::size_t inner = list.neighbour.size();
  FaceNeighbours result{ std::vector<vtkIdType>(faces.cells.faceCount(), InnerFace),
    std::vector<std::size_t>(faces.cells.faceCount(), NoFace) };
  for (std::size_t i = 0; i < inner; ++i)
  {
    const std::size_t beyond = faceBeyond(faces.cells, list.face[i], list.neighbour[i]);
    result.opposite[list.face[i]] = beyond;
    result.opposite[beyond] = list.face[i];
  }
  for (std::size_t i = 0; i < outer.size(); ++i)
  {
    result.boundary[list.face[inner + i]] =
      outer[i] == UnknownBoundary ? vtkIdType(NoBoundary) : outer[i];
  }
  return result;
}

vtkSmartPointer<vtkPoints> pointsOf(const std::vector<double>& coordinates)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(coordinates.size() / 3));
  std::copy(
    coordinates.begin(), coordinates.end(), static_cast<double*>(points->GetVoidPointer(0)));
  return points;
}

void CellWriter::addHexahedron(const std::array<vtkIdType, 8>& points)
{
  types_->InsertNextValue(VTK_HEXAHEDRON);
  starts_->InsertNextValue(-1);
  cells_->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
}

void CellWriter::addPolyhedron(const CellFaces& cells, std::size_t cell)
{
  types_->InsertNextValue(VTK_POLYHEDRON);
  starts_->InsertNextValue(stream_->GetNumberOfValues());
  stream_->InsertNextValue(
    static_cast<vtkIdType>(cells.firstFace[cell + 1] - cells.firstFace[cell]));
  points_.clear();
  for (std::size_t f = cells.firstFace[cell]; f < cells.firstFace[cell + 1]; ++f)
  {
    stream_->InsertNextValue(
      static_cast<vtkIdType>(cells.firstCorner[f + 1] - cells.firstCorner[f]));
    for (std::size_t i = cells.firstCorner[f]; i < cells.firstCorner[f + 1]; ++i)
    {
      stream_->InsertNextValue(cells.corners[i]);
      points_.push_back(cells.corners[i]);
    }
  }
  std::sort(points_.begin(), points_.end());
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  cells_->InsertNextCell(static_cast<vtkIdType>(points_.size()), points_.data());
}

void CellWriter::finish(vtkUnstructuredGrid* grid)
{
  setCells(grid, types_, cells_, starts_, stream_);
}

BoundaryTable::BoundaryTable(vtkUnstructuredGrid* grid)
  : names_(readBoundaryTexts(grid, "BoundaryNames"))
  , types_(readBoundaryTexts(grid, "BoundaryTypes"))
{
}

void BoundaryTable::write(const std::vector<BoundaryFaceRow>& rows, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkIdTypeArray> ofFaces;
  ofFaces->SetName(BoundaryOfFaces);
  ofFaces->SetNumberOfComponents(3);
  std::set<vtkIdType> used;
  for (const BoundaryFaceRow& row : rows)
  {
    ofFaces->InsertNextTypedTuple(row.data());
    used.insert(row[2]);
  }
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkStringArray> names;
  vtkNew<vtkStringArray> types;
  ids->SetName("BoundaryIds");
  names->SetName("BoundaryNames");
  types->SetName("BoundaryTypes");
  for (const auto& [number, name] : names_)
  {
    if (used.count(number) > 0)
    {
      ids->InsertNextValue(number);
      names->InsertNextValue(name);
      types->InsertNextValue(types_[number]);
    }
  }
  for (vtkAbstractArray* array :
    { static_cast<vtkAbstractArray*>(ofFaces), static_cast<vtkAbstractArray*>(ids),
      static_cast<vtkAbstractArray*>(names), static_cast<vtkAbstractArray*>(types) })
  {
    grid->GetFieldData()->AddArray(array);
  }
}

}

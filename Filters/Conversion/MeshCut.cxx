// SPDX-License-Identifier: BSD-3-Clause
#include "MeshCut.h"

#include "BoundaryOfFaces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExtractCells.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>

namespace cartesian
{

namespace
{

constexpr const char* GlobalPointIds = "GlobalPointIds";

vtkIdTypeArray* idsOf(vtkFieldData* data, const char* name)
{
  return vtkIdTypeArray::SafeDownCast(data->GetAbstractArray(name));
}

class Cutter
{
public:
  Cutter(const MeshOutputs& whole, const std::vector<SlabRange>& pieces, std::size_t number)
    : whole_(whole)
    , own_(number)
    , pieceOf_(static_cast<std::size_t>(whole.mesh->GetNumberOfCells()))
  {
    vtkDataArray* const box = whole.mesh->GetCellData()->GetArray("GlobalBox");
    vtkIdTypeArray* const ids = idsOf(whole.mesh->GetCellData(), CellId);
    for (vtkIdType cell = 0; cell < whole.mesh->GetNumberOfCells(); ++cell)
    {
      const auto k = static_cast<std::uint32_t>(box->GetComponent(cell, 2));
      const auto at = std::find_if(
        pieces.begin(), pieces.end(), [&](const SlabRange& piece) { return piece.contains(k); });
      pieceOf_[static_cast<std::size_t>(ids->GetValue(cell))] =
        static_cast<std::size_t>(at - pieces.begin());
    }
  }

  void cutMesh(vtkUnstructuredGrid* piece) const
  {
    vtkNew<vtkUnstructuredGrid> named;
    named->ShallowCopy(whole_.mesh);
    vtkNew<vtkIdTypeArray> points;
    points->SetName(GlobalPointIds);
    points->SetNumberOfValues(named->GetNumberOfPoints());
    std::iota(points->GetPointer(0), points->GetPointer(0) + points->GetNumberOfValues(), 0);
    named->GetPointData()->AddArray(points);
    vtkIdTypeArray* const ids = idsOf(whole_.mesh->GetCellData(), CellId);
    std::vector<vtkIdType> cells;
    for (vtkIdType cell = 0; cell < named->GetNumberOfCells(); ++cell)
    {
      if (isOwn(ids->GetValue(cell)))
      {
        cells.push_back(cell);
      }
    }
    vtkNew<vtkExtractCells> extract;
    extract->SetInputData(named);
    extract->SetCellIds(cells.data(), static_cast<vtkIdType>(cells.size()));
    extract->AssumeSortedAndUniqueIdsOn();
    extract->Update();
    piece->ShallowCopy(extract->GetOutput());
    piece->GetPointData()->SetGlobalIds(idsOf(piece->GetPointData(), GlobalPointIds));
    piece->GetCellData()->SetGlobalIds(idsOf(piece->GetCellData(), CellId));
    piece->GetFieldData()->DeepCopy(whole_.mesh->GetFieldData());
    cutBoundaryOfFaces(piece->GetFieldData());
  }

  // `other`: of interfaces, the cells on the other side, which may be of another piece.
  void cutFaces(vtkPolyData* whole, vtkPolyData* piece, const char* other) const
  {
    piece->Initialize();
    piece->GetFieldData()->DeepCopy(whole->GetFieldData());
    vtkIdTypeArray* const owner = idsOf(whole->GetCellData(), "OwnerCell");
    if (!owner)
    {
      return;
    }
    std::vector<vtkIdType> faces;
    for (vtkIdType face = 0; face < whole->GetNumberOfCells(); ++face)
    {
      if (isOwn(owner->GetValue(face)))
      {
        faces.push_back(face);
      }
    }
    copyFaces(whole, faces, piece);
    if (other)
    {
      forgetOthers(idsOf(piece->GetCellData(), other));
    }
  }

private:
  bool isOwn(vtkIdType cell) const { return pieceOf_[static_cast<std::size_t>(cell)] == own_; }

  // Cells of other pieces become -1.
  void forgetOthers(vtkIdTypeArray* cells) const
  {
    for (vtkIdType i = 0; i < cells->GetNumberOfValues(); ++i)
    {
      cells->SetValue(i, isOwn(cells->GetValue(i)) ? cells->GetValue(i) : -1);
    }
  }

  void cutBoundaryOfFaces(vtkFieldData* fields) const
  {
    vtkIdTypeArray* const all = idsOf(fields, BoundaryOfFaces);
    std::vector<std::array<vtkIdType, 3>> rows;
    for (vtkIdType i = 0; i < all->GetNumberOfTuples(); ++i)
    {
      std::array<vtkIdType, 3> row{};
      all->GetTypedTuple(i, row.data());
      if (isOwn(row[0]))
      {
        rows.push_back(row);
      }
    }
    all->SetNumberOfTuples(static_cast<vtkIdType>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      all->SetTypedTuple(static_cast<vtkIdType>(i), rows[i].data());
    }
  }

  static void copyFaces(vtkPolyData* from, const std::vector<vtkIdType>& faces, vtkPolyData* to)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(from->GetPoints()->GetDataType());
    vtkNew<vtkCellArray> polygons;
    copyAll(from->GetPointData(), to->GetPointData(), from->GetNumberOfPoints());
    copyAll(from->GetCellData(), to->GetCellData(), static_cast<vtkIdType>(faces.size()));
    std::vector<vtkIdType> pointOf(static_cast<std::size_t>(from->GetNumberOfPoints()), -1);
    for (const vtkIdType face : faces)
    {
      vtkIdType count = 0;
      const vtkIdType* corners = nullptr;
      from->GetPolys()->GetCellAtId(face, count, corners);
      const vtkIdType number = polygons->InsertNextCell(static_cast<int>(count));
      for (const vtkIdType* corner = corners; corner != corners + count; ++corner)
      {
        vtkIdType& point = pointOf[static_cast<std::size_t>(*corner)];
        if (point < 0)
        {
          point = points->InsertNextPoint(from->GetPoint(*corner));
          to->GetPointData()->CopyData(from->GetPointData(), *corner, point);
        }
        polygons->InsertCellPoint(point);
      }
      to->GetCellData()->CopyData(from->GetCellData(), face, number);
    }
    to->SetPoints(points);
    to->SetPolys(polygons);
  }

  static void copyAll(vtkDataSetAttributes* from, vtkDataSetAttributes* to, vtkIdType count)
  {
    to->CopyAllOn();
    to->CopyAllocate(from, count);
  }

  const MeshOutputs& whole_;
  const std::size_t own_;
  std::vector<std::size_t> pieceOf_; // of each cell by its CellId
};

bool addsUp(vtkDataArray* array, const char* name)
{
  return array->GetNumberOfTuples() == 1 || std::string(name) == "BoundaryFaceCounts" ||
    std::string(name) == "BoundaryAreas" || std::string(name) == "RegionVolumes";
}

void clearSums(vtkFieldData* fields)
{
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = fields->GetArray(i);
    if (array && addsUp(array, array->GetName()))
    {
      array->Fill(0);
    }
  }
}

}

void cutPiece(const MeshOutputs& whole, const std::vector<SlabRange>& pieces, std::size_t number,
  const Processes& processes, const MeshOutputs& piece)
{
  const Cutter cutter(whole, pieces, number);
  cutter.cutMesh(piece.mesh);
  cutter.cutFaces(whole.boundary, piece.boundary, nullptr);
  cutter.cutFaces(whole.interfaces, piece.interfaces, "NeighbourCell");
  if (number > 0 && !processes.areSeveral())
  {
    clearSums(piece.mesh->GetFieldData());
    clearSums(piece.boundary->GetFieldData());
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "FlatGrid.h"

#include "Base/Error.h"
#include "BoundaryOfFaces.h"
#include "GridFaces.h"
#include "PolyhedronStorage.h"
#include "Sections/SideMerging.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// Of faces between two cells.
constexpr vtkIdType Inner = UnknownBoundary - 1;

// Of each face of all cells.
struct FaceNeighbours
{
  std::vector<vtkIdType> boundary;   // or Inner
  std::vector<std::size_t> opposite; // the same face of another cell, or NoFace
};

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
  FaceNeighbours result{ std::vector<vtkIdType>(faces.cells.faceCount(), Inner),
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

class FlatGrid
{
public:
  FlatGrid(vtkUnstructuredGrid* grid, const SweepSpec& spec, Execution& execution)
    : grid_(grid)
    , isWedge_(spec.isWedge)
    , faces_(grid, execution)
  {
    turnOutward(faces_.cells, faces_.points.data(), execution);
    FaceNeighbours neighbours = neighboursOf(grid, faces_, execution);
    given_ = std::move(neighbours.boundary);
    side_ = facesOfSide(faces_.cells, faces_.points, spec.across, neighbours.opposite);
    mergeSkew(
      faces_.points, [&](std::uint32_t a, std::uint32_t b) { return regionOf(a) == regionOf(b); },
      [&](std::size_t face) -> long long {
        const vtkIdType boundary = face < given_.size() ? given_[face] : vtkIdType(NoBoundary);
        return boundary == Inner ? InnerEdge : boundary;
      },
      side_);
    flat_ = sweep(side_, faces_.points, spec);
    names_ = readBoundaryTexts(grid, "BoundaryNames");
    types_ = readBoundaryTexts(grid, "BoundaryTypes");
    front_ = 1 +
      std::max(names_.empty() ? vtkIdType(NoBoundary) : names_.rbegin()->first,
        *std::max_element(given_.begin(), given_.end()));
  }

  void write(vtkUnstructuredGrid* output)
  {
    writePoints(output);
    writeCells(output);
    writeCellData(output);
    writeBoundaries(output);
    for (const char* name : { "RegionNames", "RegionsAreZones" })
    {
      if (vtkAbstractArray* regions = grid_->GetFieldData()->GetAbstractArray(name))
      {
        output->GetFieldData()->AddArray(regions);
      }
    }
  }

private:
  int regionOf(std::uint32_t cell) const
  {
    auto* regions = vtkIntArray::SafeDownCast(grid_->GetCellData()->GetArray("Region"));
    return regions ? regions->GetValue(faces_.cellOf[cell]) : 0;
  }

  vtkIdType boundaryOf(std::size_t face) const
  {
    const std::size_t source = flat_.source[face];
    return source == FrontFace ? front_
      : source == BackFace     ? front_ + 1
      : source < given_.size() ? given_[source]
                               : vtkIdType(NoBoundary);
  }

  void writePoints(vtkUnstructuredGrid* output) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(flat_.pointOf.size()));
    std::copy(
      flat_.points.begin(), flat_.points.end(), static_cast<double*>(points->GetVoidPointer(0)));
    output->SetPoints(points);
  }

  void writeCells(vtkUnstructuredGrid* output) const
  {
    vtkNew<vtkUnsignedCharArray> types;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkIdTypeArray> starts;
    vtkNew<vtkIdTypeArray> stream;
    const CellFaces& all = flat_.cells;
    for (std::size_t cell = 0; cell < all.cellCount(); ++cell)
    {
      types->InsertNextValue(VTK_POLYHEDRON);
      starts->InsertNextValue(stream->GetNumberOfValues());
      stream->InsertNextValue(
        static_cast<vtkIdType>(all.firstFace[cell + 1] - all.firstFace[cell]));
      std::set<vtkIdType> points;
      for (std::size_t f = all.firstFace[cell]; f < all.firstFace[cell + 1]; ++f)
      {
        stream->InsertNextValue(
          static_cast<vtkIdType>(all.firstCorner[f + 1] - all.firstCorner[f]));
        for (std::size_t i = all.firstCorner[f]; i < all.firstCorner[f + 1]; ++i)
        {
          stream->InsertNextValue(all.corners[i]);
          points.insert(all.corners[i]);
        }
      }
      cells->InsertNextCell(static_cast<int>(points.size()));
      for (const vtkIdType point : points)
      {
        cells->InsertCellPoint(point);
      }
    }
    setCells(output, types, cells, starts, stream);
  }

  void writeCellData(vtkUnstructuredGrid* output) const
  {
    vtkCellData* from = grid_->GetCellData();
    vtkCellData* to = output->GetCellData();
    const auto count = static_cast<vtkIdType>(side_.count());
    to->CopyGlobalIdsOff();
    to->CopyAllocate(from, count);
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(CellId);
    for (vtkIdType i = 0; i < count; ++i)
    {
      to->CopyData(from, faces_.cellOf[side_.cellOf[static_cast<std::size_t>(i)]], i);
      ids->InsertNextValue(i);
    }
    to->RemoveArray("VolumeFraction");
    to->AddArray(ids);
  }

  void writeBoundaries(vtkUnstructuredGrid* output)
  {
    vtkNew<vtkIdTypeArray> rows;
    rows->SetName(BoundaryOfFaces);
    rows->SetNumberOfComponents(3);
    std::set<vtkIdType> used;
    for (std::size_t cell = 0; cell < flat_.cells.cellCount(); ++cell)
    {
      const std::size_t first = flat_.cells.firstFace[cell];
      for (std::size_t f = first; f < flat_.cells.firstFace[cell + 1]; ++f)
      {
        const std::array<vtkIdType, 3> row{ static_cast<vtkIdType>(cell),
          static_cast<vtkIdType>(f - first), boundaryOf(f) };
        if (row[2] != Inner)
        {
          rows->InsertNextTypedTuple(row.data());
          used.insert(row[2]);
        }
      }
    }
    output->GetFieldData()->AddArray(rows);
    names_[front_] = "front";
    names_[front_ + 1] = "back";
    types_[front_] = types_[front_ + 1] = isWedge_ ? "wedge" : "empty";
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
    for (vtkAbstractArray* array : { static_cast<vtkAbstractArray*>(ids),
           static_cast<vtkAbstractArray*>(names), static_cast<vtkAbstractArray*>(types) })
    {
      output->GetFieldData()->AddArray(array);
    }
  }

  vtkUnstructuredGrid* grid_;
  bool isWedge_;
  GridFaces faces_;
  std::vector<vtkIdType> given_; // boundaries of its faces
  SideFaces side_;
  FlatCells flat_;
  std::map<vtkIdType, std::string> names_;
  std::map<vtkIdType, std::string> types_;
  vtkIdType front_; // the boundary; the back's is the next
};

}

void makeFlat(vtkUnstructuredGrid* grid, const SweepSpec& spec, vtkUnstructuredGrid* output,
  Execution& execution)
{
  FlatGrid(grid, spec, execution).write(output);
}

}

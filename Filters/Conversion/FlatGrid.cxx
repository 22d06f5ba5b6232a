// SPDX-License-Identifier: BSD-3-Clause
#include "FlatGrid.h"

#include "Base/Error.h"
#include "FacedGrid.h"
#include "Sections/SideMerging.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace cartesian
{

namespace
{

class FlatGrid
{
public:
  FlatGrid(vtkUnstructuredGrid* grid, const SweepSpec& spec, Execution& execution)
    : grid_(grid)
    , isWedge_(spec.isWedge)
    , boundaries_(grid)
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
        return boundary == InnerFace ? InnerEdge : boundary;
      },
      side_);
    flat_ = sweep(side_, faces_.points, spec);
    front_ = 1 + std::max(boundaries_.last(), *std::max_element(given_.begin(), given_.end()));
  }

  void write(vtkUnstructuredGrid* output)
  {
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

  void writeCells(vtkUnstructuredGrid* output) const
  {
    output->SetPoints(pointsOf(flat_.points));
    CellWriter cells;
    for (std::size_t cell = 0; cell < flat_.cells.cellCount(); ++cell)
    {
      cells.addPolyhedron(flat_.cells, cell);
    }
    cells.finish(output);
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
    std::vector<BoundaryFaceRow> rows;
    for (std::size_t cell = 0; cell < flat_.cells.cellCount(); ++cell)
    {
      const std::size_t first = flat_.cells.firstFace[cell];
      for (std::size_t f = first; f < flat_.cells.firstFace[cell + 1]; ++f)
      {
        if (boundaryOf(f) != InnerFace)
        {
          rows.push_back(
            { static_cast<vtkIdType>(cell), static_cast<vtkIdType>(f - first), boundaryOf(f) });
        }
      }
    }
    boundaries_.add(front_, "front", isWedge_ ? "wedge" : "empty");
    boundaries_.add(front_ + 1, "back", isWedge_ ? "wedge" : "empty");
    boundaries_.write(rows, output);
  }

  vtkUnstructuredGrid* grid_;
  bool isWedge_;
  BoundaryTable boundaries_;
  GridFaces faces_;
  std::vector<vtkIdType> given_; // boundaries of its faces
  SideFaces side_;
  FlatCells flat_;
  vtkIdType front_; // the boundary; the back's is the next
};

}

void makeFlat(vtkUnstructuredGrid* grid, const SweepSpec& spec, vtkUnstructuredGrid* output,
  Execution& execution)
{
  FlatGrid(grid, spec, execution).write(output);
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "PatchesVTK.h"

#include "Base/Error.h"
#include "Base/Sorting.h"
#include "FieldData.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace cartesian
{

namespace
{

constexpr const char* KnowsEdgesField = "KnowsEdges";

vtkDataArray* cellArray(vtkPolyData* input, const char* name)
{
  vtkDataArray* array = input->GetCellData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw Error(Fault::MissingArray,
      std::string("The patches have no cell array \"") + name +
        "\": connect the output of Patcher.");
  }
  return array;
}

vtkDataArray* pointKinds(vtkPolyData* input)
{
  vtkDataArray* array = input->GetPointData()->GetArray("PointKind");
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw Error(Fault::MissingArray,
      "The patches have no point array \"PointKind\": connect the output of Patcher.");
  }
  return array;
}

[[noreturn]] void throwMismatch(vtkIdType patch)
{
  throw Error(Fault::MissingArray,
    "Patch " + std::to_string(patch) +
      " does not belong to the boxes: connect the same Cartesian Boxer here and to Patcher.");
}

// Reads the polygons box by box, in the order in which Patcher writes them.
class PatchReader
{
public:
  PatchReader(vtkPolyData* input, const Boxes& boxes)
    : input_(input)
    , boxes_(boxes)
    , boundary_(cellArray(input, "BoundaryId"))
    , box_(cellArray(input, "BoxId"))
    , reason_(cellArray(input, "PatchReason"))
    , enclosed_(cellArray(input, "EnclosedVolume"))
    , missing_(cellArray(input, "VolumeGap"))
    , kind_(pointKinds(input))
  {
  }

  Patches read()
  {
    Execution one;
    intersected_ = intersectedBoxes(boxes_, one);
    // New vectors: GCC 14 takes the size that assign() would keep for one beyond all memory, and warns.
    const std::size_t boxes = intersected_.size();
    patches_.boxStart = std::vector<std::size_t>(boxes + 1, 0);
    patches_.reason = std::vector<PatchReason>(boxes, PatchReason::MarchingCubes);
    patches_.missing.assign(boxes, 0);
    patches_.knowsEdges = input_->GetFieldData()->HasArray(KnowsEdgesField) != 0;
    readPoints();
    auto polygon = vtk::TakeSmartPointer(input_->GetPolys()->NewIterator());
    for (polygon->GoToFirstCell(); !polygon->IsDoneWithTraversal(); polygon->GoToNextCell())
    {
      const vtkIdType id = polygon->GetCurrentCellId();
      goToBoxOf(id);
      readReason(id);
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      polygon->GetCurrentCell(size, corners);
      readCorners(id, size, corners);
      patches_.boundary.push_back(static_cast<std::int32_t>(boundary_->GetComponent(id, 0)));
      patches_.triangle.push_back(static_cast<std::uint32_t>(id)); // what is known of the surface's
      patches_.enclosed.push_back(static_cast<float>(enclosed_->GetComponent(id, 0) / cubicStep_));
    }
    patches_.start.push_back(patches_.corners.size());
    scan(patches_.boxStart);
    return std::move(patches_);
  }

private:
  void readPoints()
  {
    const Lattice& lattice = boxes_.lattice;
    for (vtkIdType i = 0; i < input_->GetNumberOfPoints(); ++i)
    {
      std::array<double, 3> x;
      input_->GetPoint(i, x.data());
      patches_.points.push_back(
        { lattice.level(0, x[0]), lattice.level(1, x[1]), lattice.level(2, x[2]) });
      patches_.kinds.push_back(kindOf(i));
    }
  }

  PointKind kindOf(vtkIdType point) const
  {
    const double code = kind_->GetComponent(point, 0);
    return code == double(PointKind::Corner) ? PointKind::Corner
      : code == double(PointKind::OnEdge)    ? PointKind::OnEdge
                                             : PointKind::OnSurface;
  }

  void goToBoxOf(vtkIdType id)
  {
    const double wanted = box_->GetComponent(id, 0);
    while (n_ < intersected_.size() && intersected_[n_] < wanted)
    {
      ++n_;
    }
    if (n_ == intersected_.size() || intersected_[n_] != wanted)
    {
      throwMismatch(id);
    }
    ++patches_.boxStart[n_];
  }

  void readReason(vtkIdType id)
  {
    const double code = reason_->GetComponent(id, 0);
    if (!(code >= 0 && code < PatchReasons))
    {
      throwMismatch(id);
    }
    patches_.reason[n_] = static_cast<PatchReason>(code);
    patches_.missing[n_] =
      static_cast<float>(missing_->GetComponent(id, 0) / boxes_.lattice.step());
  }

  void readCorners(vtkIdType id, vtkIdType size, const vtkIdType* corners)
  {
    const Box box = boxes_.box(intersected_[n_]);
    patches_.start.push_back(patches_.corners.size());
    for (vtkIdType i = 0; i < size; ++i)
    {
      const Point& p = patches_.points[static_cast<std::size_t>(corners[i])];
      for (int axis = 0; axis < 3; ++axis)
      {
        if (p[axis] < box.low[axis] || p[axis] > box.high[axis])
        {
          throwMismatch(id);
        }
      }
      patches_.corners.push_back(static_cast<std::uint32_t>(corners[i]));
    }
  }

  vtkPolyData* input_;
  const Boxes& boxes_;
  vtkDataArray* boundary_;
  vtkDataArray* box_;
  vtkDataArray* reason_;
  vtkDataArray* enclosed_; // cubic user units
  vtkDataArray* missing_;  // user units
  vtkDataArray* kind_;     // of points
  const double cubicStep_ = std::pow(boxes_.lattice.step(), 3);
  std::vector<std::uint32_t> intersected_;
  std::size_t n_ = 0; // the intersected box at hand
  Patches patches_;
};

}

void toVTK(const Patches& patches, const Boxes& boxes, const std::vector<vtkIdType>& surfaceCells,
  vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(patches.points.size()));
  for (std::size_t i = 0; i < patches.points.size(); ++i)
  {
    const Point& p = patches.points[i];
    points->SetPoint(static_cast<vtkIdType>(i), boxes.lattice.position(0, p[0]),
      boxes.lattice.position(1, p[1]), boxes.lattice.position(2, p[2]));
  }

  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(patches.start.size()));
  std::copy(patches.start.begin(), patches.start.end(), offsets->GetPointer(0));
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(static_cast<vtkIdType>(patches.corners.size()));
  std::copy(patches.corners.begin(), patches.corners.end(), corners->GetPointer(0));
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, corners);

  const auto count = static_cast<vtkIdType>(patches.size());
  vtkNew<vtkIntArray> boundary;
  boundary->SetName("BoundaryId");
  boundary->SetNumberOfValues(count);
  std::copy(patches.boundary.begin(), patches.boundary.end(), boundary->GetPointer(0));
  vtkNew<vtkIdTypeArray> cell;
  cell->SetName("SurfaceCell");
  cell->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    cell->SetValue(i, surfaceCells[patches.triangle[static_cast<std::size_t>(i)]]);
  }
  vtkNew<vtkDoubleArray> enclosed;
  enclosed->SetName("EnclosedVolume");
  enclosed->SetNumberOfValues(count);
  const double cubicStep = std::pow(boxes.lattice.step(), 3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    enclosed->SetValue(
      i, patches.enclosed[patches.triangle[static_cast<std::size_t>(i)]] * cubicStep);
  }
  vtkNew<vtkIdTypeArray> box;
  box->SetName("BoxId");
  box->SetNumberOfValues(count);
  vtkNew<vtkDoubleArray> missing;
  missing->SetName("VolumeGap");
  missing->SetNumberOfValues(count);
  vtkNew<vtkUnsignedCharArray> reason;
  reason->SetName("PatchReason");
  reason->SetNumberOfValues(count);
  Execution one;
  const std::vector<std::uint32_t> intersected = intersectedBoxes(boxes, one);
  for (std::size_t n = 0; n < intersected.size(); ++n)
  {
    std::fill(reason->GetPointer(0) + patches.boxStart[n],
      reason->GetPointer(0) + patches.boxStart[n + 1],
      static_cast<unsigned char>(patches.reason[n]));
    std::fill(missing->GetPointer(0) + patches.boxStart[n],
      missing->GetPointer(0) + patches.boxStart[n + 1], patches.missing[n] * boxes.lattice.step());
    std::fill(box->GetPointer(0) + patches.boxStart[n],
      box->GetPointer(0) + patches.boxStart[n + 1], static_cast<vtkIdType>(intersected[n]));
  }

  vtkNew<vtkUnsignedCharArray> kind;
  kind->SetName("PointKind");
  kind->SetNumberOfValues(static_cast<vtkIdType>(patches.kinds.size()));
  std::transform(patches.kinds.begin(), patches.kinds.end(), kind->GetPointer(0),
    [](PointKind k) { return static_cast<unsigned char>(k); });

  if (patches.knowsEdges)
  {
    setField(output, KnowsEdgesField, { 1 });
  }
  output->SetPoints(points);
  output->GetPointData()->AddArray(kind);
  output->SetPolys(polygons);
  output->GetCellData()->AddArray(boundary);
  output->GetCellData()->AddArray(box);
  output->GetCellData()->AddArray(cell);
  output->GetCellData()->AddArray(reason);
  output->GetCellData()->AddArray(enclosed);
  output->GetCellData()->AddArray(missing);
}

Patches patchesFromVTK(vtkPolyData* input, const Boxes& boxes)
{
  return PatchReader(input, boxes).read();
}

}

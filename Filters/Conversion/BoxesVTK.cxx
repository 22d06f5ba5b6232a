// SPDX-License-Identifier: BSD-3-Clause
#include "BoxesVTK.h"

#include "FieldData.h"
#include "Numbering.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace cartesian
{

namespace
{

constexpr const char* LatticeOrigin = "LatticeOrigin";
constexpr const char* LatticeStep = "LatticeStep";
constexpr const char* SurfaceClosed = "SurfaceClosed";
constexpr std::array<const char*, 3> PlaneNames = { "PlanesX", "PlanesY", "PlanesZ" };

// Corners of all boxes, numbered.
Numbering numberCorners(const Boxes& boxes)
{
  std::vector<std::vector<PointUse>> uses(1);
  uses[0].reserve(8 * boxes.boxes.size());
  for (const Box& box : boxes.boxes)
  {
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const Point p = cornerOf(box, corner);
      uses[0].push_back({ p, rowOfPoint(p, boxes.planes, box.global[1], box.global[2]),
        static_cast<std::uint32_t>(uses[0].size()) });
    }
  }
  Execution execution;
  return numberPoints(uses, pointRows(boxes.planes), execution);
}

vtkDataArray* cellArray(vtkUnstructuredGrid* grid, const char* name, int components)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != components)
  {
    throw Error(Fault::MissingArray,
      std::string("The boxes have no cell array \"") + name +
        "\": connect the output of Cartesian Boxer.");
  }
  return array;
}

bool before(const Box& a, const Box& b)
{
  const std::array<std::uint32_t, 3> left = { a.global[2], a.global[1], a.global[0] };
  const std::array<std::uint32_t, 3> right = { b.global[2], b.global[1], b.global[0] };
  return left < right;
}

Meshlines readPlanes(vtkUnstructuredGrid* grid)
{
  Meshlines planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double level : getField(grid, PlaneNames[axis], 0))
    {
      const bool valid = level >= 0 && level <= LevelsOfTheDomain;
      planes[axis].push_back(valid ? static_cast<Level>(level) : 1);
      if (!onPlane(planes[axis].back()) ||
        (planes[axis].size() > 1 && planes[axis].back() <= planes[axis][planes[axis].size() - 2]))
      {
        throw Error(Fault::MissingArray,
          std::string("Field data array \"") + PlaneNames[axis] + "\" is not what Cartesian Boxer wrote.");
      }
    }
    if (planes[axis].size() < 2)
    {
      throw Error(Fault::MissingArray,
        std::string("Field data array \"") + PlaneNames[axis] + "\" has fewer than two planes.");
    }
  }
  return planes;
}

}

void toVTK(const Boxes& boxes, vtkUnstructuredGrid* grid)
{
  const Numbering corners = numberCorners(boxes);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(corners.points.size()));
  for (std::size_t i = 0; i < corners.points.size(); ++i)
  {
    const Point& p = corners.points[i];
    points->SetPoint(static_cast<vtkIdType>(i), boxes.lattice.position(0, p[0]),
      boxes.lattice.position(1, p[1]), boxes.lattice.position(2, p[2]));
  }

  const auto count = static_cast<vtkIdType>(boxes.boxes.size());
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(8 * count);
  for (vtkIdType i = 0; i < 8 * count; ++i)
  {
    connectivity->SetValue(i, corners.ofSlot[static_cast<std::size_t>(i)]);
  }
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  vtkNew<vtkIntArray> global;
  global->SetName("GlobalBox");
  global->SetNumberOfComponents(3);
  global->SetComponentName(0, "I");
  global->SetComponentName(1, "J");
  global->SetComponentName(2, "K");
  global->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> status;
  status->SetName("Status");
  status->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> cornerStatus;
  cornerStatus->SetName("CornerStatus");
  cornerStatus->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Box& box = boxes.boxes[static_cast<std::size_t>(i)];
    offsets->SetValue(i, 8 * i);
    for (int axis = 0; axis < 3; ++axis)
    {
      global->SetTypedComponent(i, axis, static_cast<int>(box.global[axis]));
    }
    status->SetValue(i, static_cast<unsigned char>(box.status));
    cornerStatus->SetValue(i, box.corners);
  }
  offsets->SetValue(count, 8 * count);

  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  grid->SetPoints(points);
  grid->SetCells(VTK_VOXEL, cells);
  grid->GetCellData()->AddArray(global);
  grid->GetCellData()->AddArray(status);
  grid->GetCellData()->AddArray(cornerStatus);
  setField(grid, LatticeOrigin,
    { boxes.lattice.origin()[0], boxes.lattice.origin()[1], boxes.lattice.origin()[2] });
  setField(grid, LatticeStep, { boxes.lattice.step() });
  setField(grid, SurfaceClosed, { boxes.closed ? 1.0 : 0.0 });
  for (int axis = 0; axis < 3; ++axis)
  {
    setField(grid, PlaneNames[axis], { boxes.planes[axis].begin(), boxes.planes[axis].end() });
  }
}

Boxes boxesFromVTK(vtkUnstructuredGrid* grid)
{
  Boxes boxes;
  const std::vector<double> origin = getField(grid, LatticeOrigin, 3);
  boxes.lattice =
    Lattice({ origin[0], origin[1], origin[2] }, getField(grid, LatticeStep, 1)[0]);
  boxes.closed = getField(grid, SurfaceClosed, 1)[0] != 0;
  boxes.planes = readPlanes(grid);

  vtkDataArray* global = cellArray(grid, "GlobalBox", 3);
  vtkDataArray* status = cellArray(grid, "Status", 1);
  vtkDataArray* corners = cellArray(grid, "CornerStatus", 1);
  boxes.rowStart.assign((boxes.planes[1].size() - 1) * (boxes.planes[2].size() - 1) + 1, 0);
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    Box box;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double index = global->GetComponent(i, axis);
      if (!(index >= 0) || index + 1 >= static_cast<double>(boxes.planes[axis].size()))
      {
        throw Error(Fault::MissingArray,
          "Box " + std::to_string(i) + " lies outside the grid: GlobalBox is not what Cartesian Boxer wrote.");
      }
      box.global[axis] = static_cast<std::uint32_t>(index);
      box.low[axis] = boxes.planes[axis][box.global[axis]];
      box.high[axis] = boxes.planes[axis][box.global[axis] + 1];
    }
    box.status = status->GetComponent(i, 0) == 1 ? BoxStatus::Inside : BoxStatus::Intersected;
    box.corners = static_cast<std::uint8_t>(corners->GetComponent(i, 0));
    if (!boxes.boxes.empty() && !before(boxes.boxes.back(), box))
    {
      throw Error(Fault::MissingArray,
        "Box " + std::to_string(i) + " is out of order: connect the output of Cartesian Boxer as it is.");
    }
    boxes.boxes.push_back(box);
    ++boxes.rowStart[boxes.row(box.global[1], box.global[2])];
  }
  scan(boxes.rowStart);
  return boxes;
}

void removeBoxFields(vtkDataObject* data)
{
  for (const char* name : { LatticeOrigin, LatticeStep, SurfaceClosed, PlaneNames[0], PlaneNames[1],
         PlaneNames[2] })
  {
    data->GetFieldData()->RemoveArray(name);
  }
}

}

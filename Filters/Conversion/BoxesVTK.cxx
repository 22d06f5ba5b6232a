// SPDX-License-Identifier: BSD-3-Clause
#include "BoxesVTK.h"

#include "FieldData.h"
#include "Lattice/Numbering.h"
#include "RefinementLevel.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"
#include "vtkUnstructuredGrid.h"

namespace cartesian
{

namespace
{

constexpr const char* LatticeOrigin = "LatticeOrigin";
constexpr const char* LatticeStep = "LatticeStep";
constexpr const char* PartsPerBox = "PartsPerBox";
constexpr std::array<const char*, 3> PlaneNames = { "PlanesX", "PlanesY", "PlanesZ" };
constexpr std::array<const char*, 3> MovedNames = { "MovedPlanesX", "MovedPlanesY",
  "MovedPlanesZ" };

// Numbers the corners of all boxes.
Numbering numberCorners(const Boxes& boxes)
{
  std::vector<std::vector<PointUse>> uses(1);
  uses[0].reserve(8 * boxes.packed.size());
  for (const PackedBox& packed : boxes.packed)
  {
    const Box box = boxes.placed(packed);
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const Point p = cornerOf(box, corner);
      const auto& global = boxes.globalOf(box).index;
      uses[0].push_back({ p, rowOfPoint(p, boxes.planes, global[1], global[2]),
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

// An array of three named components for each cell.
template <class Array>
vtkSmartPointer<Array> newTriples(
  const char* name, const std::array<const char*, 3>& components, vtkIdType count)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  for (int i = 0; i < 3; ++i)
  {
    array->SetComponentName(i, components[static_cast<std::size_t>(i)]);
  }
  array->SetNumberOfTuples(count);
  return array;
}

// The whole numbers of one cell, which must lie between 0 and `most`.
std::array<std::uint32_t, 3> readTriple(
  vtkDataArray* array, vtkIdType cell, const std::array<double, 3>& most)
{
  std::array<std::uint32_t, 3> result;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double value = array->GetComponent(cell, axis);
    if (!(value >= 0 && value <= most[static_cast<std::size_t>(axis)]))
    {
      throw Error(Fault::MissingArray,
        "Box " + std::to_string(cell) + " has " + array->GetName() + " " + number(value) +
          ", which Cartesian Boxer did not write: connect its output unchanged.");
    }
    result[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(value);
  }
  return result;
}

// Boxes come in order of the rows of their global boxes, and of the global boxes.
std::array<std::uint32_t, 3> orderOf(const GlobalBox& global)
{
  return { global.index[2], global.index[1], global.index[0] };
}

class BoxReader
{
public:
  // `step`: the unit of offsets in the file, fine.
  BoxReader(vtkUnstructuredGrid* grid, std::int64_t step)
    : step_(step)
    , global_(cellArray(grid, "GlobalBox", 3))
    , level_(cellArray(grid, "Level", 3))
    , offset_(cellArray(grid, "Offset", 3))
    , status_(cellArray(grid, "Status", 1))
    , corners_(cellArray(grid, "CornerStatus", 1))
  {
  }

  // Appends the grid's cell to the boxes.
  void read(vtkIdType cell, Boxes& boxes)
  {
    std::array<double, 3> last;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      last[axis] = static_cast<double>(boxes.planes[axis].size()) - 2;
    }
    const GlobalBox global{ readTriple(global_, cell, last),
      static_cast<std::uint32_t>(boxes.packed.size()), None, 0, 0 };
    const double deepest = boxes.planes.planeLevel;
    const std::int64_t parts = FinePerBox / step_;
    const auto widest = static_cast<double>(parts - 1);
    const auto level = readTriple(level_, cell, { deepest, deepest, deepest });
    const auto offset = readTriple(offset_, cell, { widest, widest, widest });
    PackedBox box;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box.level[axis] = static_cast<std::uint8_t>(level[axis]);
      box.offset[axis] = static_cast<std::uint16_t>(offset[axis] * step_);
    }
    box.status = status_->GetComponent(cell, 0) == 1 ? BoxStatus::Inside : BoxStatus::Intersected;
    box.corners = static_cast<std::uint8_t>(corners_->GetComponent(cell, 0));

    const auto order = orderOf(global);
    if (cell > 0 && order < before_)
    {
      throw Error(Fault::MissingArray,
        "Box " + std::to_string(cell) +
          " is out of order: connect the output of Cartesian Boxer unchanged.");
    }
    before_ = order;
    if (boxes.globals.empty() || boxes.globals.back().index != global.index)
    {
      boxes.globals.push_back(global);
      ++boxes.rowStart[boxes.row(global.index[1], global.index[2])];
    }
    place(box, boxes);
    boxes.packed.push_back(box);
  }

private:
  static void place(PackedBox& box, Boxes& boxes)
  {
    GlobalBox& global = boxes.globals.back();
    box.global = static_cast<std::uint32_t>(boxes.globals.size() - 1);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int64_t low = global.index[axis] * FinePerBox + box.offset[axis];
      const std::int64_t size = FinePerBox >> box.level[axis];
      if (low % size != 0)
      {
        throw Error(Fault::MissingArray,
          "Level and Offset of box " + std::to_string(boxes.packed.size()) +
            " are inconsistent: connect the output of Cartesian Boxer unchanged.");
      }
      global.depth = std::max(global.depth, box.level[axis]);
    }
  }

  const std::int64_t step_;
  vtkDataArray* global_;
  vtkDataArray* level_;
  vtkDataArray* offset_;
  vtkDataArray* status_;
  vtkDataArray* corners_;
  std::array<std::uint32_t, 3> before_{};
};

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
          std::string("Field data array \"") + PlaneNames[axis] +
            "\" is not what Cartesian Boxer wrote: connect its output unchanged.");
      }
    }
    if (planes[axis].size() < 2)
    {
      throw Error(Fault::MissingArray,
        std::string("Field data array \"") + PlaneNames[axis] +
          "\" has fewer than two planes: connect the output of Cartesian Boxer unchanged.");
    }
  }
  return planes;
}

// How often the unit of offsets and of moved planes halves global boxes. Boxes of earlier versions do not say.
int readPlaneLevel(vtkUnstructuredGrid* grid)
{
  if (!grid->GetFieldData()->HasArray(PartsPerBox))
  {
    return LeastPlaneLevel;
  }
  const double parts = getField(grid, PartsPerBox, 1)[0];
  for (int level = LeastPlaneLevel; level <= DeepestLevel; ++level)
  {
    if (parts == 1 << level)
    {
      return level;
    }
  }
  throw Error(Fault::MissingArray,
    std::string("Field data array \"") + PartsPerBox + "\" is " + number(parts) +
      ", which Cartesian Boxer did not write: connect its output unchanged.");
}

bool isBetween(
  const Meshlines& planes, std::size_t axis, double level, std::int64_t fine, std::int64_t step)
{
  return level > planeAt(planes, axis, fine - step) && level < planeAt(planes, axis, fine + step) &&
    onPlane(static_cast<Level>(level));
}

// `step`: their unit in the file, fine.
void readMoved(vtkUnstructuredGrid* grid, std::int64_t step, Meshlines& planes)
{
  const std::int64_t parts = FinePerBox / step;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<double> values = getField(grid, MovedNames[axis], 0);
    const double end = double(planes[axis].size() - 1) * double(parts);
    double before = 0;
    for (std::size_t i = 0; i < values.size(); i += 2)
    {
      const double part = values[i];
      const bool isInside = part > before && part < end;
      const std::int64_t fine = isInside ? static_cast<std::int64_t>(part) * step : step;
      if (i + 1 == values.size() || !isInside ||
        !isBetween(planes, axis, values[i + 1], fine, step))
      {
        throw Error(Fault::MissingArray,
          std::string("Field data array \"") + MovedNames[axis] +
            "\" is not what Cartesian Boxer wrote: connect its output unchanged.");
      }
      planes.moved[axis].push_back({ fine, static_cast<Level>(values[i + 1]) });
      before = part;
    }
  }
}

void setVoxels(const Boxes& boxes, vtkUnstructuredGrid* grid)
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

  const auto count = static_cast<vtkIdType>(boxes.packed.size());
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(8 * count);
  for (vtkIdType i = 0; i < 8 * count; ++i)
  {
    connectivity->SetValue(i, corners.ofSlot[static_cast<std::size_t>(i)]);
  }
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, 8 * i);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  grid->SetPoints(points);
  grid->SetCells(VTK_VOXEL, cells);
}

void setCellData(const Boxes& boxes, vtkCellData* data)
{
  const auto count = static_cast<vtkIdType>(boxes.packed.size());
  const auto global = newTriples<vtkIntArray>("GlobalBox", { "I", "J", "K" }, count);
  const auto level = newTriples<vtkUnsignedCharArray>("Level", { "X", "Y", "Z" }, count);
  const auto offset = newTriples<vtkUnsignedShortArray>("Offset", { "X", "Y", "Z" }, count);
  const std::int64_t step = FinePerBox / boxes.planes.partsPerBox();
  vtkNew<vtkUnsignedCharArray> status;
  status->SetName("Status");
  status->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> cornerStatus;
  cornerStatus->SetName("CornerStatus");
  cornerStatus->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const PackedBox& box = boxes.packed[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      global->SetTypedComponent(i, axis, static_cast<int>(boxes.globalOf(box).index[a]));
      level->SetTypedComponent(i, axis, box.level[a]);
      offset->SetTypedComponent(i, axis, static_cast<unsigned short>(box.offset[a] / step));
    }
    status->SetValue(i, static_cast<unsigned char>(box.status));
    cornerStatus->SetValue(i, box.corners);
  }
  data->AddArray(global);
  data->AddArray(level);
  data->AddArray(offset);
  data->AddArray(status);
  data->AddArray(cornerStatus);
  setRefinementLevel(data);
}

}

void toVTK(const Boxes& boxes, vtkUnstructuredGrid* grid)
{
  setVoxels(boxes, grid);
  setCellData(boxes, grid->GetCellData());
  setField(grid, LatticeOrigin,
    { boxes.lattice.origin()[0], boxes.lattice.origin()[1], boxes.lattice.origin()[2] });
  setField(grid, LatticeStep, { boxes.lattice.step() });
  const std::int64_t parts = boxes.planes.partsPerBox();
  const std::int64_t step = FinePerBox / parts;
  setField(grid, PartsPerBox, { static_cast<double>(parts) });
  for (std::size_t a = 0; a < 3; ++a)
  {
    setField(grid, PlaneNames[a], { boxes.planes[a].begin(), boxes.planes[a].end() });
    std::vector<double> moved;
    for (const MovedPlane& plane : boxes.planes.moved[a])
    {
      const std::int64_t part = plane.fine / step;
      moved.push_back(static_cast<double>(part));
      moved.push_back(plane.level);
    }
    setField(grid, MovedNames[a], moved);
  }
}

Boxes boxesFromVTK(vtkUnstructuredGrid* grid)
{
  Boxes boxes;
  const std::vector<double> origin = getField(grid, LatticeOrigin, 3);
  boxes.lattice = Lattice({ origin[0], origin[1], origin[2] }, getField(grid, LatticeStep, 1)[0]);
  boxes.planes = readPlanes(grid);
  boxes.planes.planeLevel = readPlaneLevel(grid);
  const std::int64_t step = FinePerBox / boxes.planes.partsPerBox();
  readMoved(grid, step, boxes.planes);
  boxes.core = boxes.allLayers();

  BoxReader reader(grid, step);
  boxes.rowStart.assign((boxes.planes[1].size() - 1) * (boxes.planes[2].size() - 1) + 1, 0);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    reader.read(cell, boxes);
  }
  scan(boxes.rowStart);
  boxes.globals.push_back(
    { { 0, 0, 0 }, static_cast<std::uint32_t>(boxes.packed.size()), None, 0, 0 });
  Execution execution;
  if (!boxes.plantTree(execution))
  {
    throw Error(
      Fault::MissingArray, "Boxes overlap: connect the output of Cartesian Boxer unchanged.");
  }
  return boxes;
}

void removeBoxFields(vtkDataObject* data)
{
  for (const char* name : { LatticeOrigin, LatticeStep, PartsPerBox, PlaneNames[0], PlaneNames[1],
         PlaneNames[2], MovedNames[0], MovedNames[1], MovedNames[2] })
  {
    data->GetFieldData()->RemoveArray(name);
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "DefectsToVTK.h"

#include "FieldData.h"
#include "GridFaces.h"

#include "Boxes/Sides.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cartesian
{

namespace
{

constexpr std::array<std::pair<DefectKind, const char*>, 12> CountNames = { {
  { DefectKind::OpenEdge, "OpenEdges" },
  { DefectKind::NonManifoldEdge, "NonManifoldEdges" },
  { DefectKind::InconsistentEdge, "InconsistentEdges" },
  { DefectKind::DegenerateTriangle, "DegenerateTriangles" },
  { DefectKind::DuplicateTriangle, "DuplicateTriangles" },
  { DefectKind::FoldedTriangle, "FoldedTriangles" },
  { DefectKind::OverlappedTriangle, "OverlappedTriangles" },
  { DefectKind::Intersection, "Intersections" },
  { DefectKind::SmallComponent, "TrianglesOfSmallComponents" },
  { DefectKind::Hole, "Holes" },
  { DefectKind::Leak, "Leaks" },
  { DefectKind::ClosedContact, "TrianglesOfClosedContacts" },
} };

constexpr const char* CellsLeftOut = "CellsLeftOut";
constexpr const char* FailingCells = "FailingCells";
constexpr std::array<std::pair<DefectKind, const char*>, 3> LayerNames = { {
  { DefectKind::LayersEndInGap, "LayersEndInGap" },
  { DefectKind::LayersEndAtCorner, "LayersEndAtCorner" },
  { DefectKind::LayersEndAtFault, "LayersEndAtFault" },
} };

const char* nameOf(DefectKind kind)
{
  const auto* found = std::find_if(CountNames.begin(), CountNames.end(),
    [kind](const auto& count) { return count.first == kind; });
  return found == CountNames.end() ? CellsLeftOut : found->second;
}

class DefectWriter
{
public:
  DefectWriter(const SurfaceDefects& defects, const std::vector<vtkIdType>& surfaceCells)
    : defects_(defects)
    , surfaceCells_(surfaceCells)
  {
    kind_->SetName("DefectKind");
    name_->SetName("DefectName");
    cell_->SetName("SurfaceCell");
    other_->SetName("OtherCell");
    width_->SetName("Width");
    volume_->SetName("Volume");
  }

  void write(vtkPolyData* output)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vector& p : defects_.points)
    {
      points->InsertNextPoint(p.data());
    }
    // VTK numbers the lines of a vtkPolyData before its polygons.
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkCellArray> polygons;
    writeCells(false, lines);
    writeCells(true, polygons);
    output->SetPoints(points);
    output->SetLines(lines);
    output->SetPolys(polygons);
    output->GetCellData()->SetScalars(kind_);
    output->GetCellData()->AddArray(name_);
    output->GetCellData()->AddArray(cell_);
    output->GetCellData()->AddArray(other_);
    output->GetCellData()->AddArray(width_);
    output->GetCellData()->AddArray(volume_);
  }

private:
  void writeCells(bool polygons, vtkCellArray* cells)
  {
    vtkIdType point = 0;
    for (const Defect& defect : defects_.defects)
    {
      if (defect.polygon == polygons)
      {
        cells->InsertNextCell(static_cast<int>(defect.size));
        for (std::uint32_t i = 0; i < defect.size; ++i)
        {
          cells->InsertCellPoint(point + i);
        }
        kind_->InsertNextValue(static_cast<int>(defect.kind));
        name_->InsertNextValue(nameOf(defect.kind));
        const vtkIdType cell = cellOf(defect.triangle);
        const vtkIdType other = cellOf(defect.other);
        const bool swaps = other >= 0 && other < cell; // of a pair the lower comes first
        cell_->InsertNextValue(swaps ? other : cell);
        other_->InsertNextValue(swaps ? cell : other);
        width_->InsertNextValue(defect.width);
        volume_->InsertNextValue(0);
      }
      point += defect.size;
    }
  }

  vtkIdType cellOf(std::uint32_t triangle) const
  {
    return triangle == SurfaceDefects::None ? -1 : surfaceCells_[triangle];
  }

  const SurfaceDefects& defects_;
  const std::vector<vtkIdType>& surfaceCells_;
  vtkNew<vtkIntArray> kind_;
  vtkNew<vtkStringArray> name_;
  vtkNew<vtkIdTypeArray> cell_;
  vtkNew<vtkIdTypeArray> other_;
  vtkNew<vtkDoubleArray> width_;
  vtkNew<vtkDoubleArray> volume_;
};

// To defects that are there.
class CellAdder
{
public:
  CellAdder(DefectKind kind, const char* name, vtkPolyData* output)
    : kind_(static_cast<int>(kind))
    , name_(name)
    , points_(output->GetPoints())
    , polygons_(output->GetPolys())
    , data_(output->GetCellData())
  {
  }

  void addBox(const Boxes& boxes, const RemovedCell& cell)
  {
    const Box box = boxes.box(cell.box);
    const vtkIdType first = points_->GetNumberOfPoints();
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const auto at = [&](int axis) {
        const Point& end = (corner >> axis & 1u) != 0 ? box.high : box.low;
        return boxes.lattice.position(axis, end[static_cast<std::size_t>(axis)]);
      };
      points_->InsertNextPoint(at(0), at(1), at(2));
    }
    const double volume = cell.volume * std::pow(boxes.lattice.step(), 3);
    for (int side = 0; side < 6; ++side)
    {
      polygons_->InsertNextCell(4);
      for (const unsigned corner : sideCorners(side / 2, static_cast<unsigned>(side % 2)))
      {
        polygons_->InsertCellPoint(first + static_cast<vtkIdType>(corner));
      }
      describe(volume);
    }
  }

  // `stream`: as CellFaceReader gives it.
  void addFaces(vtkUnstructuredGrid* mesh, const vtkIdType* stream)
  {
    for (vtkIdType faces = *stream++; faces > 0; --faces)
    {
      const vtkIdType corners = *stream++;
      polygons_->InsertNextCell(static_cast<int>(corners));
      for (vtkIdType i = 0; i < corners; ++i)
      {
        polygons_->InsertCellPoint(points_->InsertNextPoint(mesh->GetPoint(*stream++)));
      }
      describe(0);
    }
  }

  // Of another grid.
  void addFace(vtkPolyData* faces, vtkIdType face)
  {
    vtkNew<vtkIdList> corners;
    faces->GetCellPoints(face, corners);
    polygons_->InsertNextCell(static_cast<int>(corners->GetNumberOfIds()));
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      polygons_->InsertCellPoint(points_->InsertNextPoint(faces->GetPoint(corners->GetId(i))));
    }
    describe(0);
  }

private:
  void describe(double volume)
  {
    append("DefectKind", kind_);
    vtkStringArray::SafeDownCast(data_->GetAbstractArray("DefectName"))->InsertNextValue(name_);
    append("SurfaceCell", -1);
    append("OtherCell", -1);
    append("Width", 0);
    append("Volume", volume);
  }

  void append(const char* array, double value) { data_->GetArray(array)->InsertNextTuple1(value); }

  const int kind_;
  const char* const name_;
  vtkPoints* points_;
  vtkCellArray* polygons_;
  vtkCellData* data_;
};

// Whether there are arrays to add `count` cells to: made here, if need be.
bool isToAdd(std::size_t count, vtkPolyData* output)
{
  const bool isThere = output->GetCellData()->HasArray("DefectKind") != 0;
  if (!isThere && count > 0)
  {
    toVTK({}, {}, output);
  }
  return isThere || count > 0;
}

}

void toVTK(
  const SurfaceDefects& defects, const std::vector<vtkIdType>& surfaceCells, vtkPolyData* output)
{
  DefectWriter(defects, surfaceCells).write(output);
  for (const auto& [kind, name] : CountNames)
  {
    setField(output, name, { static_cast<double>(defects.counts[static_cast<std::size_t>(kind)]) });
  }
  setField(output, "Components", { static_cast<double>(defects.components) });
  setField(output, "TrianglesNotCompared", { static_cast<double>(defects.notCompared) });
  setField(output, CellsLeftOut, { 0 }); // so far: addCellsLeftOut()
  setField(output, FailingCells, { 0 });
}

void setRepairs(const SurfaceRepair& repair, vtkDataObject* output)
{
  const std::size_t leaks = repair.leaks();
  const std::array<std::pair<const char*, std::size_t>, 5> counts{ {
    { "TrianglesTurned", repair.turned },
    { "DuplicatesLeftOut", repair.duplicates.size() },
    { "LooseTrianglesLeftOut", repair.loose.size() },
    { "HolesClosed", repair.holes.size() - leaks },
    { "LeaksClosed", leaks },
  } };
  for (const auto& [name, count] : counts)
  {
    if (count > 0)
    {
      setField(output, name, { static_cast<double>(count) });
    }
  }
}

void addCellsLeftOut(const Assembly& assembly, vtkPolyData* output)
{
  const auto& removed = assembly.edits.removed;
  const auto& overlapping = assembly.edits.overlapping;
  const std::size_t count =
    removed.size() + overlapping.size() + assembly.separate.fragments.size();
  if (!isToAdd(count, output))
  {
    return;
  }
  CellAdder adder(DefectKind::CellLeftOut, CellsLeftOut, output);
  for (const auto* cells : { &removed, &overlapping, &assembly.separate.fragments })
  {
    for (const RemovedCell& cell : *cells)
    {
      adder.addBox(assembly.boxes, cell);
    }
  }
  setField(output, CellsLeftOut, { static_cast<double>(count) });
}

void addFailingCells(
  vtkUnstructuredGrid* mesh, const std::vector<vtkIdType>& cells, vtkPolyData* output)
{
  if (!isToAdd(cells.size(), output))
  {
    return;
  }
  CellAdder adder(DefectKind::FailingCell, FailingCells, output);
  CellFaceReader reader(mesh);
  for (const vtkIdType cell : cells)
  {
    adder.addFaces(mesh, reader.read(cell));
  }
  setField(output, FailingCells, { static_cast<double>(cells.size()) });
}

void addEndedLayers(const BoundaryLayers& layers, vtkPolyData* boundary, vtkPolyData* output)
{
  std::array<std::vector<vtkIdType>, LayerNames.size()> ended;
  const std::vector<StackMeasure>& stacks = layers.boundary.stacks;
  for (std::size_t f = 0; f < stacks.size(); ++f)
  {
    if (stacks[f].asked > 0 && !stacks[f].isWhole)
    {
      const LayerEnd end = stacks[f].end == LayerEnd::Nowhere ? LayerEnd::Fault : stacks[f].end;
      ended[static_cast<std::size_t>(end) - 1].push_back(static_cast<vtkIdType>(f));
    }
  }
  for (std::size_t i = 0; i < ended.size(); ++i)
  {
    if (!isToAdd(ended[i].size(), output))
    {
      continue;
    }
    CellAdder adder(LayerNames[i].first, LayerNames[i].second, output);
    for (const vtkIdType face : ended[i])
    {
      adder.addFace(boundary, face);
    }
    setField(output, LayerNames[i].second, { static_cast<double>(ended[i].size()) });
  }
}

}

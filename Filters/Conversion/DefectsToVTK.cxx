// SPDX-License-Identifier: BSD-3-Clause
#include "DefectsToVTK.h"

#include "FieldData.h"
#include "GridFaces.h"

#include "Boxes/Sides.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace cartesian
{

namespace
{

constexpr std::array<std::pair<DefectKind, const char*>, 14> CountNames = { {
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
  { DefectKind::JoinedCrack, "CracksJoined" },
  { DefectKind::ClosedGap, "Gaps" },
} };

constexpr std::size_t DefectsAChunk = 1 << 12;

constexpr const char* CellsLeftOut = "CellsLeftOut";
constexpr const char* FailingCells = "FailingCells";
constexpr std::array<std::pair<DefectKind, const char*>, 3> LayerNames = { {
  { DefectKind::LayersEndInGap, "LayersEndInGap" },
  { DefectKind::LayersEndAtCorner, "LayersEndAtCorner" },
  { DefectKind::LayersEndAtFault, "LayersEndAtFault" },
} };

constexpr std::array<std::pair<DefectKind, const char*>, 2> LeakNames = { {
  { DefectKind::LeakPath, "LeakPaths" },
  { DefectKind::LeakGap, "GapsOfLeak" },
} };

const char* nameOf(DefectKind kind)
{
  const auto is = [kind](const auto& count) { return count.first == kind; };
  const auto* found = std::find_if(CountNames.begin(), CountNames.end(), is);
  return found != CountNames.end() ? found->second
                                   : std::find_if(LeakNames.begin(), LeakNames.end(), is)->second;
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

  void write(vtkPolyData* output, Execution& execution)
  {
    // VTK numbers the lines of a vtkPolyData before its polygons.
    const std::vector<Place> lines = placesOf(false);
    const std::vector<Place> polygons = placesOf(true);
    vtkCellData* const data = output->GetCellData();
    const std::size_t cells = lines.size() + polygons.size();
    const auto count = static_cast<vtkIdType>(cells);
    for (vtkAbstractArray* const array :
      std::initializer_list<vtkAbstractArray*>{ kind_, name_, cell_, other_, width_, volume_ })
    {
      array->Allocate(count + count / 8); // cells of the mesh follow
      array->SetNumberOfTuples(count);
      array == kind_ ? data->SetScalars(kind_) : data->AddArray(array);
    }
    describe(lines, 0, execution);
    describe(polygons, static_cast<vtkIdType>(lines.size()), execution);
    output->SetPoints(points(execution));
    output->SetLines(cellsOf(lines, execution));
    output->SetPolys(cellsOf(polygons, execution));
  }

private:
  // Of a cell.
  struct Place
  {
    const Defect* defect;
    vtkIdType point; // the first
    vtkIdType corner;
  };

  std::vector<Place> placesOf(bool polygons) const
  {
    std::vector<Place> places;
    vtkIdType point = 0;
    vtkIdType corner = 0;
    for (const Defect& defect : defects_.defects)
    {
      if (defect.polygon == polygons)
      {
        places.push_back({ &defect, point, corner });
        corner += defect.size;
      }
      point += defect.size;
    }
    return places;
  }

  vtkSmartPointer<vtkPoints> points(Execution& execution) const
  {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(defects_.points.size()));
    auto* const xyz = static_cast<double*>(points->GetVoidPointer(0));
    execution.forEach(
      defects_.points.size(), DefectsAChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p)
        {
          std::copy(defects_.points[p].begin(), defects_.points[p].end(), xyz + 3 * p);
        }
      });
    return points;
  }

  static vtkSmartPointer<vtkCellArray> cellsOf(
    const std::vector<Place>& places, Execution& execution)
  {
    const vtkIdType size = places.empty() ? 0 : places.back().corner + places.back().defect->size;
    vtkNew<vtkIdTypeArray> offsets;
    vtkNew<vtkIdTypeArray> corners;
    const auto count = static_cast<vtkIdType>(places.size());
    offsets->SetNumberOfValues(count + 1);
    corners->SetNumberOfValues(size);
    execution.forEach(places.size(), DefectsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Place& place = places[i];
        offsets->SetValue(static_cast<vtkIdType>(i), place.corner);
        vtkIdType* const first = corners->GetPointer(place.corner);
        std::iota(first, first + place.defect->size, place.point);
      }
    });
    offsets->SetValue(count, size);
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(offsets, corners);
    return cells;
  }

  // Cells from `first` on.
  void describe(const std::vector<Place>& places, vtkIdType first, Execution& execution)
  {
    execution.forEach(places.size(), DefectsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Defect& defect = *places[i].defect;
        const vtkIdType at = first + static_cast<vtkIdType>(i);
        kind_->SetValue(at, static_cast<int>(defect.kind));
        name_->GetValue(at) = nameOf(defect.kind);
        const vtkIdType cell = cellOf(defect.triangle);
        const vtkIdType other = cellOf(defect.other);
        const bool swaps = other >= 0 && other < cell; // of a pair the lower comes first
        cell_->SetValue(at, swaps ? other : cell);
        other_->SetValue(at, swaps ? cell : other);
        width_->SetValue(at, defect.width);
        volume_->SetValue(at, 0);
      }
    });
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
    Execution alone;
    toVTK({}, {}, output, alone);
  }
  return isThere || count > 0;
}

}

void toVTK(const SurfaceDefects& defects, const std::vector<vtkIdType>& surfaceCells,
  vtkPolyData* output, Execution& execution)
{
  DefectWriter(defects, surfaceCells).write(output, execution);
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

void addLeak(const LeakPath& path, vtkPolyData* output, Execution& execution)
{
  SurfaceDefects leak;
  const auto add = [&](DefectKind kind, const Vector* points, std::size_t size, double width) {
    leak.defects.push_back({ kind, SurfaceDefects::None, SurfaceDefects::None,
      static_cast<std::uint32_t>(size), false, width });
    leak.points.insert(leak.points.end(), points, points + size);
  };
  if (!path.points.empty())
  {
    const auto narrowest = std::min_element(path.gaps.begin(), path.gaps.end(),
      [](const LeakGap& a, const LeakGap& b) { return a.width < b.width; });
    add(DefectKind::LeakPath, path.points.data(), path.points.size(),
      narrowest == path.gaps.end() ? 0 : narrowest->width);
  }
  for (const LeakGap& gap : path.gaps)
  {
    add(DefectKind::LeakGap, gap.across.data(), gap.across.size(), gap.width);
  }
  vtkNew<vtkPolyData> lines;
  toVTK(leak, {}, lines, execution);
  vtkNew<vtkAppendPolyData> all;
  all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  all->AddInputData(output);
  all->AddInputData(lines);
  all->Update();
  vtkNew<vtkFieldData> counts;
  counts->ShallowCopy(output->GetFieldData());
  output->ShallowCopy(all->GetOutput());
  output->SetFieldData(counts);
  setField(output, LeakNames[0].second, { path.points.empty() ? 0.0 : 1.0 });
  setField(output, LeakNames[1].second, { static_cast<double>(path.gaps.size()) });
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "MeshToVTK.h"

#include "BoundaryOfFaces.h"
#include "FieldData.h"
#include "Mesher/Stages.h"
#include "Mesher/Statistics.h"
#include "PolyhedronStorage.h"
#include "Quality/FaceMeasures.h"
#include "RefinementLevel.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace cartesian
{

static_assert(std::is_same<Id, vtkIdType>::value, "the kernel writes vtkIdType arrays directly");

namespace
{

constexpr std::size_t ItemsAChunk = 4096;

std::size_t layerCells(const Assembly& assembly)
{
  return assembly.layers ? assembly.layers->stacks.cells() : 0;
}

// Layers after all cells of the mesh.
void appendLayers(const OutputMesh& mesh, const PrismStacks& stacks, const CellArrays& arrays)
{
  for (std::size_t i = 0; i < stacks.cells(); ++i)
  {
    const Id cell = mesh.cellCount() + static_cast<Id>(i);
    arrays.offsets[cell] = mesh.connectivitySize() + stacks.offsets[i];
    arrays.types[cell] = arrays.polyhedron;
    arrays.faceStart[cell] = mesh.faceStreamSize() + stacks.faceStart[i];
  }
  std::copy(stacks.connectivity.begin(), stacks.connectivity.end(),
    arrays.connectivity + mesh.connectivitySize());
  std::copy(
    stacks.faceStream.begin(), stacks.faceStream.end(), arrays.faceStream + mesh.faceStreamSize());
  arrays.offsets[mesh.cellCount() + static_cast<Id>(stacks.cells())] =
    mesh.connectivitySize() + stacks.offsets.back();
}

// Cells at interfaces with layers have points of their own there. `regions`: of each cell of the mesh.
void setCopies(const OutputMesh& mesh, const BoundaryLayers& layers, const int* regions,
  const CellArrays& arrays)
{
  std::map<std::pair<int, Id>, Id> copyOf;
  std::vector<bool> isCopied(static_cast<std::size_t>(mesh.pointCount()));
  for (const PointCopy& copy : layers.copies)
  {
    copyOf[{ copy.region, copy.point }] = copy.copy;
    isCopied[static_cast<std::size_t>(copy.point)] = true;
  }
  const auto set = [&](Id cell, Id& point) {
    if (isCopied[static_cast<std::size_t>(point)])
    {
      const auto found = copyOf.find({ regions[cell], point });
      point = found == copyOf.end() ? point : found->second;
    }
  };
  for (Id cell = 0; cell < mesh.cellCount() && !copyOf.empty(); ++cell)
  {
    std::for_each(arrays.connectivity + arrays.offsets[cell],
      arrays.connectivity + arrays.offsets[cell + 1], [&](Id& point) { set(cell, point); });
    if (arrays.types[cell] == arrays.polyhedron)
    {
      Id* at = arrays.faceStream + arrays.faceStart[cell];
      for (Id faces = *at++; faces > 0; --faces)
      {
        const Id size = *at++;
        std::for_each(at, at + size, [&](Id& point) { set(cell, point); });
        at += size;
      }
    }
  }
}

void setCells(const Assembly& assembly, vtkUnstructuredGrid* grid, Execution& execution)
{
  const OutputMesh& mesh = *assembly.mesh;
  const PrismStacks* const stacks = assembly.layers ? &assembly.layers->stacks : nullptr;
  const Id cellCount = mesh.cellCount() + static_cast<Id>(layerCells(assembly));
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkIdTypeArray> faceStart;
  vtkNew<vtkIdTypeArray> faceStream;
  offsets->SetNumberOfValues(cellCount + 1);
  connectivity->SetNumberOfValues(
    mesh.connectivitySize() + (stacks ? static_cast<Id>(stacks->connectivity.size()) : 0));
  types->SetNumberOfValues(cellCount);
  faceStart->SetNumberOfValues(cellCount);
  faceStream->SetNumberOfValues(
    mesh.faceStreamSize() + (stacks ? static_cast<Id>(stacks->faceStream.size()) : 0));
  const CellArrays arrays{ offsets->GetPointer(0), connectivity->GetPointer(0),
    types->GetPointer(0), faceStart->GetPointer(0), faceStream->GetPointer(0), VTK_HEXAHEDRON,
    VTK_POLYHEDRON };
  mesh.writeCells(arrays, execution);
  if (stacks)
  {
    appendLayers(mesh, *stacks, arrays);
    auto* regions = vtkIntArray::SafeDownCast(grid->GetCellData()->GetArray("Region"));
    setCopies(mesh, *assembly.layers, regions->GetPointer(0), arrays);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  cartesian::setCells(grid, types, cells, faceStart, faceStream);
}

// Layer cells belong to the box below them and have the layer's number; other cells have 0.
void setLayers(const OutputMesh& mesh, const BoundaryLayers& layers, vtkUnstructuredGrid* grid)
{
  const PrismStacks& stacks = layers.stacks;
  vtkCellData* const data = grid->GetCellData();
  auto* number = vtkIdTypeArray::SafeDownCast(data->GetArray(CellId));
  std::vector<vtkIdType> places(static_cast<std::size_t>(mesh.cellCount()));
  for (vtkIdType cell = 0; cell < mesh.cellCount(); ++cell)
  {
    places[static_cast<std::size_t>(number->GetValue(cell))] = cell;
  }
  vtkNew<vtkUnsignedCharArray> layer;
  layer->SetName("Layer");
  layer->SetNumberOfValues(number->GetNumberOfTuples());
  layer->FillValue(0);
  for (std::size_t i = 0; i < stacks.cells(); ++i)
  {
    const vtkIdType cell = mesh.cellCount() + static_cast<vtkIdType>(i);
    const vtkIdType below = places[static_cast<std::size_t>(stacks.below[i])];
    for (const char* name : { "GlobalBox", "Level", "Region" })
    {
      data->GetArray(name)->SetTuple(cell, below, data->GetArray(name));
    }
    data->GetArray("VolumeFraction")->SetComponent(cell, 0, 1);
    number->SetValue(cell, layers.numbers[static_cast<std::size_t>(cell)]);
    layer->SetValue(cell, stacks.layer[i]);
  }
  for (vtkIdType cell = 0; cell < mesh.cellCount(); ++cell)
  {
    number->SetValue(cell, layers.numbers[static_cast<std::size_t>(number->GetValue(cell))]);
  }
  data->AddArray(layer);
  for (const ChangedCell& cell : layers.changed)
  {
    vtkDataArray* const fraction = data->GetArray("VolumeFraction");
    fraction->SetComponent(
      cell.place, 0, cell.volumeByFormer * fraction->GetComponent(cell.place, 0));
  }
}

void setCellData(const Assembly& assembly, vtkUnstructuredGrid* grid, Execution& execution)
{
  const OutputMesh& mesh = *assembly.mesh;
  const Id cellCount = mesh.cellCount() + static_cast<Id>(layerCells(assembly));
  vtkNew<vtkIdTypeArray> number;
  number->SetName(CellId);
  number->SetNumberOfTuples(cellCount);
  vtkNew<vtkIntArray> global;
  global->SetName("GlobalBox");
  global->SetNumberOfComponents(3);
  global->SetComponentName(0, "I");
  global->SetComponentName(1, "J");
  global->SetComponentName(2, "K");
  global->SetNumberOfTuples(cellCount);
  vtkNew<vtkUnsignedCharArray> level;
  level->SetName("Level");
  level->SetNumberOfComponents(3);
  level->SetComponentName(0, "X");
  level->SetComponentName(1, "Y");
  level->SetComponentName(2, "Z");
  level->SetNumberOfTuples(cellCount);
  vtkNew<vtkIntArray> region;
  region->SetName("Region");
  region->SetNumberOfTuples(cellCount);
  vtkNew<vtkDoubleArray> fraction;
  fraction->SetName("VolumeFraction");
  fraction->SetNumberOfTuples(cellCount);
  mesh.writeCellData({ number->GetPointer(0), global->GetPointer(0), level->GetPointer(0),
                       region->GetPointer(0), fraction->GetPointer(0) },
    execution);
  grid->GetCellData()->AddArray(global);
  grid->GetCellData()->AddArray(level);
  grid->GetCellData()->AddArray(region);
  grid->GetCellData()->AddArray(fraction);
  grid->GetCellData()->AddArray(number);
  if (assembly.layers)
  {
    setLayers(mesh, *assembly.layers, grid);
  }
  setRefinementLevel(grid->GetCellData());
}

void setStatistics(const Assembly& assembly, const Processes& processes, vtkUnstructuredGrid* grid)
{
  const std::vector<Statistic> statistics = cartesian::statistics(assembly);
  std::vector<double> values;
  values.reserve(statistics.size());
  for (const Statistic& statistic : statistics)
  {
    values.push_back(statistic.value);
  }
  values = processes.sum(values);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    setField(grid, statistics[i].name, { values[i] });
  }
}

// Of a piece they are not known.
void setParts(const Assembly& assembly, vtkUnstructuredGrid* grid)
{
  const std::vector<std::size_t>& parts = assembly.separate.ofRegions;
  if (!parts.empty())
  {
    setField(grid, "Parts",
      { static_cast<double>(std::accumulate(parts.begin(), parts.end(), std::size_t(0))) });
  }
}

void setMesh(const Assembly& assembly, vtkUnstructuredGrid* grid, Execution& execution)
{
  const OutputMesh& mesh = *assembly.mesh;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const std::vector<double> none;
  const std::vector<double>& ofLayers = assembly.layers ? assembly.layers->stacks.points : none;
  points->SetNumberOfPoints(mesh.pointCount() + static_cast<vtkIdType>(ofLayers.size() / 3));
  auto* const xyz = static_cast<double*>(points->GetVoidPointer(0));
  mesh.writePoints(xyz, execution);
  std::copy(ofLayers.begin(), ofLayers.end(), xyz + 3 * mesh.pointCount());
  if (assembly.layers)
  {
    for (const MovedPoint& moved : assembly.layers->stacks.moved)
    {
      std::copy(moved.to.begin(), moved.to.end(), xyz + 3 * moved.point);
    }
  }
  grid->SetPoints(points);
  setCellData(assembly, grid, execution);
  setCells(assembly, grid, execution);
}

// Data for solvers that follow the paper: the area vector (equation 1) and centre of each face, and which faces are
// IP patches (4.11).
void setFaceGeometry(const std::vector<BoundaryFace>& all, const BoundaryMesh& faces,
  vtkPolyData* boundary, Execution& execution)
{
  const vtkIdType count = boundary->GetNumberOfPolys();
  vtkNew<vtkDoubleArray> area;
  area->SetName("FaceArea");
  area->SetNumberOfComponents(3);
  area->SetNumberOfTuples(count);
  vtkNew<vtkDoubleArray> centre;
  centre->SetName("FaceCentre");
  centre->SetNumberOfComponents(3);
  centre->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> isIP;
  isIP->SetName("IPPatch");
  isIP->SetNumberOfValues(count);
  const double* const points =
    vtkDoubleArray::SafeDownCast(boundary->GetPoints()->GetData())->GetPointer(0);
  execution.forEach(
    static_cast<std::size_t>(count), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
      {
        const auto size = static_cast<std::size_t>(faces.start[f + 1] - faces.start[f]);
        const auto corner = [&](std::size_t i) {
          const auto place = static_cast<std::size_t>(faces.start[f]) + i;
          const double* const p = points + 3 * faces.corners[place];
          return Vector{ p[0], p[1], p[2] };
        };
        const FaceGeometry geometry = measureFace(size, corner);
        const auto at = static_cast<vtkIdType>(f);
        area->SetTuple(at, geometry.area.data());
        centre->SetTuple(at, geometry.centre.data());
        isIP->SetValue(at, all[f].isShaped() && isBent(size, corner, geometry.area) ? 1 : 0);
      }
    });
  boundary->GetCellData()->AddArray(area);
  boundary->GetCellData()->AddArray(centre);
  boundary->GetCellData()->AddArray(isIP);
}

// Points and polygons of some faces of the mesh.
void setFaces(
  const BoundaryMesh& faces, vtkUnstructuredGrid* grid, vtkPolyData* output, Execution& execution)
{
  const auto pointCount = static_cast<vtkIdType>(faces.meshPoint.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(pointCount);
  vtkNew<vtkIdTypeArray> meshPoint;
  meshPoint->SetName("MeshPointId");
  meshPoint->SetNumberOfValues(pointCount);
  std::copy(faces.meshPoint.begin(), faces.meshPoint.end(), meshPoint->GetPointer(0));
  const auto* const all = static_cast<const double*>(grid->GetPoints()->GetVoidPointer(0));
  auto* const own = static_cast<double*>(points->GetVoidPointer(0));
  execution.forEach(faces.meshPoint.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      std::copy_n(all + 3 * faces.meshPoint[i], 3, own + 3 * i);
    }
  });
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(faces.start.size()));
  std::copy(faces.start.begin(), faces.start.end(), offsets->GetPointer(0));
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(static_cast<vtkIdType>(faces.corners.size()));
  std::copy(faces.corners.begin(), faces.corners.end(), corners->GetPointer(0));
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, corners);
  output->SetPoints(points);
  output->SetPolys(polygons);
  output->GetPointData()->AddArray(meshPoint);
}

// A value for each of some faces, valueOf(index).
template <class Array, class ValueOf>
vtkSmartPointer<Array> arrayOf(
  const char* name, std::size_t faces, ValueOf&& valueOf, Execution& execution)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(faces));
  auto* const values = array->GetPointer(0);
  execution.forEach(faces, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      values[i] = valueOf(i);
    }
  });
  return array;
}

const std::vector<BoundaryFace>& boundaryOf(const Assembly& assembly)
{
  return assembly.layers ? assembly.layers->boundary.faces : assembly.mesh->boundary();
}

void setBoundary(
  const Assembly& assembly, vtkUnstructuredGrid* grid, vtkPolyData* boundary, Execution& execution)
{
  const BoundaryMesh faces =
    assembly.layers ? assembly.layers->boundary.mesh : assembly.mesh->boundaryMesh(execution);
  setFaces(faces, grid, boundary, execution);
  const std::vector<BoundaryFace>& all = boundaryOf(assembly);
  boundary->GetCellData()->SetScalars(arrayOf<vtkIntArray>( // the initial colouring
    "BoundaryId", all.size(), [&](std::size_t i) { return all[i].boundary; }, execution));
  boundary->GetCellData()->AddArray(arrayOf<vtkIdTypeArray>(
    "OwnerCell", all.size(), [&](std::size_t i) { return all[i].cell; }, execution));
  setFaceGeometry(all, faces, boundary, execution);
}

// For each boundary face, thickness and number of its layers; for each boundary and all walls with layers, the
// fractions of the area with at least half the requested thickness, with whole stacks and with the first layer as requested, the mean thickness, and the
// median of the last layer's volume by that of the cell beside it.
class LayerReport
{
public:
  LayerReport(const BoundaryLayers& layers, vtkPolyData* boundary, Execution& execution)
    : layers_(layers)
    , faces_(layers.boundary.faces)
    , stacks_(layers.boundary.stacks)
  {
    const auto made = [&](std::size_t i) { return stacks_[i].layers; };
    boundary->GetCellData()->AddArray(arrayOf<vtkDoubleArray>(
      "LayerThickness", faces_.size(), [&](std::size_t i) { return stacks_[i].thickness; },
      execution));
    boundary->GetCellData()->AddArray(
      arrayOf<vtkIntArray>("LayersMade", faces_.size(), made, execution));
    auto* areas = vtkDoubleArray::SafeDownCast(boundary->GetCellData()->GetArray("FaceArea"));
    for (std::size_t i = 0; i < faces_.size(); ++i)
    {
      Vector area;
      areas->GetTypedTuple(static_cast<vtkIdType>(i), area.data());
      add(faces_[i].boundary, norm(area), stacks_[i]);
    }
    for (const LayeredInterface& face : layers_.boundary.interfaces)
    {
      add(face.boundary, face.area, face.stack);
    }
  }

  // `names`: of all boundaries, in their order on the outputs.
  void write(const BoundaryNames& names, vtkDataObject* output)
  {
    setField(output, "LayerCoverage", { ofWalls_.coverage() });
    setField(output, "WholeStacks", { ofWalls_.wholeShare() });
    setField(output, "FirstLayersKept", { ofWalls_.firstShare() });
    setField(output, "LayersOfAStack", { static_cast<double>(layers_.spec.count) });
    setField(output, "BoxesForLayers", { static_cast<double>(layers_.boxesAdded) });
    if (const WallFlow& flow = layers_.spec.flow; flow.targetYPlus > 0)
    {
      setField(output, "FlowSpeed", { flow.speed });
      setField(output, "FlowViscosity", { flow.viscosity });
    }
    setField(output, "LastLayerRatio", { ofWalls_.lastByCell() });
    setField(output, "MeanLayerThickness", { ofWalls_.mean() });
    std::vector<double> coverages;
    std::vector<double> wholes;
    std::vector<double> firsts;
    std::vector<double> bare;
    std::vector<double> lasts;
    std::vector<double> means;
    std::vector<double> asked;
    for (const auto& named : names)
    {
      asked.push_back(ofBoundary_[named.first].area > 0 ? 1 : 0);
      coverages.push_back(ofBoundary_[named.first].coverage());
      wholes.push_back(ofBoundary_[named.first].wholeShare());
      firsts.push_back(ofBoundary_[named.first].firstShare());
      bare.push_back(ofBoundary_[named.first].bare);
      lasts.push_back(ofBoundary_[named.first].lastByCell());
      means.push_back(ofBoundary_[named.first].mean());
    }
    setField(output, "BoundaryLayerCoverages", coverages);
    setField(output, "BoundaryWholeStacks", wholes);
    setField(output, "BoundaryFirstLayersKept", firsts);
    setField(output, "BoundaryBareAreas", bare);
    setField(output, "BoundaryLastLayerRatios", lasts);
    setField(output, "BoundaryLayerThicknesses", means);
    setField(output, "BoundaryLayersAsked", asked);
  }

private:
  static constexpr double LeastOfAsked = 0.5;

  struct Sums
  {
    double area = 0;
    double covered = 0;
    double whole = 0;
    double first = 0; // with a first layer as high as requested
    double bare = 0;  // without any layer
    double volume = 0;
    std::vector<std::pair<double, double>> lasts{}; // ratio, area

    double coverage() const { return area > 0 ? covered / area : 0; }
    double wholeShare() const { return area > 0 ? whole / area : 0; }
    double firstShare() const { return area > 0 ? first / area : 0; }
    double mean() const { return area > 0 ? volume / area : 0; }

    // That of half the area; 0: there is none.
    double lastByCell()
    {
      std::sort(lasts.begin(), lasts.end());
      double left = 0;
      for (const auto& last : lasts)
      {
        left += last.second / 2;
      }
      for (const auto& last : lasts)
      {
        left -= last.second;
        if (left <= 0)
        {
          return last.first;
        }
      }
      return 0;
    }
  };

  // If none are requested there is nothing to report.
  void add(std::int32_t boundary, double area, const StackMeasure& stack)
  {
    for (Sums* sums : { &ofBoundary_[boundary], &ofWalls_ })
    {
      sums->area += stack.asked > 0 ? area : 0;
      const bool isCovered =
        stack.layers == layers_.spec.count && stack.thickness >= LeastOfAsked * stack.asked;
      sums->covered += stack.asked > 0 && isCovered ? area : 0;
      sums->whole += stack.isWhole ? area : 0;
      sums->first += stack.keepsFirst ? area : 0;
      sums->bare += stack.asked > 0 && stack.layers == 0 ? area : 0;
      sums->volume += area * stack.thickness;
      if (stack.lastByCell > 0)
      {
        sums->lasts.emplace_back(stack.lastByCell, area);
      }
    }
  }

  const BoundaryLayers& layers_;
  const std::vector<BoundaryFace>& faces_;
  const std::vector<StackMeasure>& stacks_;
  std::map<std::int32_t, Sums> ofBoundary_;
  Sums ofWalls_;
};

struct BoundaryMeasure
{
  vtkIdType faces = 0;
  double area = 0;
};

std::map<std::int32_t, BoundaryMeasure> measureBoundaries(vtkPolyData* boundary)
{
  std::map<std::int32_t, BoundaryMeasure> measures;
  auto* ids = vtkIntArray::SafeDownCast(boundary->GetCellData()->GetArray("BoundaryId"));
  auto* areas = vtkDoubleArray::SafeDownCast(boundary->GetCellData()->GetArray("FaceArea"));
  for (vtkIdType face = 0; face < boundary->GetNumberOfPolys(); ++face)
  {
    BoundaryMeasure& measure = measures[ids->GetValue(face)];
    Vector area;
    areas->GetTypedTuple(face, area.data());
    measure.area += norm(area);
    ++measure.faces;
  }
  return measures;
}

// Sums over all processes.
std::map<std::int32_t, BoundaryMeasure> sum(
  const std::map<std::int32_t, BoundaryMeasure>& mine, const Processes& processes)
{
  std::vector<double> rows;
  for (const auto& [id, measure] : mine)
  {
    rows.insert(rows.end(), { double(id), double(measure.faces), measure.area });
  }
  std::map<std::int32_t, BoundaryMeasure> sums;
  for (const std::vector<double>& ofProcess : processes.gather(rows))
  {
    for (std::size_t i = 0; i < ofProcess.size(); i += 3)
    {
      BoundaryMeasure& measure = sums[static_cast<std::int32_t>(ofProcess[i])];
      measure.faces += static_cast<vtkIdType>(ofProcess[i + 1]);
      measure.area += ofProcess[i + 2];
    }
  }
  return sums;
}

// Name, number of faces and area of each boundary, on both outputs.
void describeBoundaries(const Assembly& assembly, const BoundaryTexts& texts,
  const Processes& processes, vtkPolyData* boundary, vtkUnstructuredGrid* mesh,
  Execution& execution)
{
  BoundaryNames names = texts.names;
  std::map<std::int32_t, BoundaryMeasure> measures = sum(measureBoundaries(boundary), processes);
  for (const auto& measured : measures)
  {
    names.emplace(measured.first, unnamedBoundary(measured.first));
  }
  vtkNew<vtkIdTypeArray> faces;
  faces->SetName("BoundaryFaceCounts");
  vtkNew<vtkDoubleArray> areas;
  areas->SetName("BoundaryAreas");
  for (const auto& named : names)
  {
    faces->InsertNextValue(measures[named.first].faces);
    areas->InsertNextValue(measures[named.first].area);
  }
  for (vtkDataObject* output : std::initializer_list<vtkDataObject*>{ mesh, boundary })
  {
    setBoundaryNames(output, names);
    setBoundaryTypes(output, names, texts.types);
    output->GetFieldData()->AddArray(faces);
    output->GetFieldData()->AddArray(areas);
  }
  auto* ids = vtkIntArray::SafeDownCast(boundary->GetCellData()->GetArray("BoundaryId"));
  // Views show strings in categorical colours, with a legend of them.
  boundary->GetCellData()->AddArray(arrayOf<vtkStringArray>(
    "BoundaryName", static_cast<std::size_t>(ids->GetNumberOfValues()),
    [&](std::size_t i) { return names.at(ids->GetValue(static_cast<vtkIdType>(i))); }, execution));
  if (assembly.layers)
  {
    LayerReport report(*assembly.layers, boundary, execution);
    report.write(names, mesh);
    report.write(names, boundary);
  }
}

// By name, from FirstRegion.
std::string nameOfRegion(const std::vector<std::string>& names, std::int32_t region)
{
  const auto n = static_cast<std::size_t>(region - FirstRegion);
  return n < names.size() ? names[n] : "region_" + std::to_string(region);
}

// Name and volume of each region, on both outputs, and of which each boundary face is.
void setRegions(const Assembly& assembly, const std::vector<std::string>& names,
  const Processes& processes, vtkUnstructuredGrid* mesh, vtkPolyData* boundary,
  Execution& execution)
{
  const std::vector<double> volumes = processes.sum(assembly.regionVolumes);
  std::vector<double> parts(assembly.separate.ofRegions.begin(), assembly.separate.ofRegions.end());
  parts.resize(volumes.size());
  vtkNew<vtkStringArray> regionNames;
  regionNames->SetName("RegionNames");
  for (std::size_t n = 0; n < volumes.size(); ++n)
  {
    regionNames->InsertNextValue(nameOfRegion(names, FirstRegion + static_cast<std::int32_t>(n)));
  }
  for (vtkDataObject* output : std::initializer_list<vtkDataObject*>{ mesh, boundary })
  {
    output->GetFieldData()->AddArray(regionNames);
    setField(output, "RegionVolumes", volumes);
    setField(output, "RegionParts", parts);
  }
  auto* numbers = vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray(CellId));
  auto* regions = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray("Region"));
  std::vector<int> regionOf(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    regionOf[static_cast<std::size_t>(numbers->GetValue(cell))] = regions->GetValue(cell);
  }
  const std::vector<BoundaryFace>& faces = boundaryOf(assembly);
  boundary->GetCellData()->AddArray(arrayOf<vtkIntArray>(
    "Region", faces.size(),
    [&](std::size_t i) { return regionOf[static_cast<std::size_t>(faces[i].cell)]; }, execution));
}

// Behind and in front of each face between two regions; with layers, those of their stacks.
std::vector<std::array<Id, 2>> cellsAtInterfaces(const Assembly& assembly)
{
  const OutputMesh& mesh = *assembly.mesh;
  std::vector<std::array<Id, 2>> cells;
  for (std::size_t i = 0; i < mesh.interfaces().size(); ++i)
  {
    cells.push_back({ mesh.interfaces()[i].cell, mesh.inFrontOfInterfaces()[i] });
  }
  if (assembly.layers)
  {
    for (const LayeredInterface& face : assembly.layers->boundary.interfaces)
    {
      const auto wall = static_cast<std::size_t>(mesh.interfaces()[face.face].boundary);
      const bool isInFront = assembly.patches.walls.all[wall].front == face.region;
      cells[face.face][isInFront ? 1 : 0] = face.cell;
    }
  }
  return cells;
}

void setInterfaces(const Assembly& assembly, const std::vector<std::string>& names,
  vtkUnstructuredGrid* mesh, vtkPolyData* output, Execution& execution)
{
  const OutputMesh& from = *assembly.mesh;
  setFaces(from.interfaceMesh(execution), mesh, output, execution);
  const std::vector<BoundaryFace>& faces = from.interfaces();
  const auto wallOf = [&](std::size_t i) -> const Wall& {
    return assembly.patches.walls.all[static_cast<std::size_t>(faces[i].boundary)];
  };
  std::map<std::pair<std::int32_t, std::int32_t>, int> ids;
  for (const Wall& wall : assembly.patches.walls.all)
  {
    if (wall.isInterface())
    {
      ids.emplace(std::make_pair(wall.behind, wall.front), 0);
    }
  }
  vtkNew<vtkStringArray> interfaceNames;
  interfaceNames->SetName("InterfaceNames");
  for (auto& [regions, id] : ids)
  {
    id = static_cast<int>(interfaceNames->InsertNextValue(
      nameOfRegion(names, regions.first) + "_to_" + nameOfRegion(names, regions.second)));
  }
  output->GetFieldData()->AddArray(interfaceNames);
  vtkCellData* data = output->GetCellData();
  data->AddArray(arrayOf<vtkStringArray>(
    "InterfaceName", faces.size(),
    [&](std::size_t i) {
      return interfaceNames->GetValue(ids.at({ wallOf(i).behind, wallOf(i).front }));
    },
    execution));
  data->SetScalars(arrayOf<vtkIntArray>(
    "InterfaceId", faces.size(),
    [&](std::size_t i) {
      return ids.at({ wallOf(i).behind, wallOf(i).front });
    },
    execution));
  data->AddArray(arrayOf<vtkIntArray>(
    "OwnerRegion", faces.size(), [&](std::size_t i) { return wallOf(i).behind; }, execution));
  data->AddArray(arrayOf<vtkIntArray>(
    "NeighbourRegion", faces.size(), [&](std::size_t i) { return wallOf(i).front; }, execution));
  data->AddArray(arrayOf<vtkIntArray>(
    "OwnerBoundaryId", faces.size(), [&](std::size_t i) { return wallOf(i).boundary; }, execution));
  data->AddArray(arrayOf<vtkIntArray>(
    "NeighbourBoundaryId", faces.size(), [&](std::size_t i) { return wallOf(i).boundaryInFront; },
    execution));
  const std::vector<std::array<Id, 2>> cells = cellsAtInterfaces(assembly);
  data->AddArray(arrayOf<vtkIdTypeArray>(
    "OwnerCell", faces.size(), [&](std::size_t i) { return cells[i][0]; }, execution));
  data->AddArray(arrayOf<vtkIdTypeArray>(
    "NeighbourCell", faces.size(), [&](std::size_t i) { return cells[i][1]; }, execution));
}

}

void toVTK(const Assembly& assembly, const BoundaryTexts& texts, const MeshPiece& piece,
  vtkUnstructuredGrid* mesh, vtkPolyData* boundary, vtkPolyData* interfaces, Execution& execution)
{
  execution.stage("Writing the mesh", AfterLayers, 1);
  setMesh(assembly, mesh, execution);
  setStatistics(assembly, piece.processes, mesh);
  setParts(assembly, mesh);
  setBoundary(assembly, mesh, boundary, execution);
  setBoundaryOfFaces(mesh, boundary, execution);
  describeBoundaries(assembly, texts, piece.processes, boundary, mesh, execution);
  if (assembly.patches.walls.any())
  {
    setRegions(assembly, texts.regions, piece.processes, mesh, boundary, execution);
    setInterfaces(assembly, texts.regions, mesh, interfaces, execution);
  }
  if (!piece.isWhole)
  {
    setGlobalIds(*assembly.mesh, piece, mesh, boundary, execution);
  }
}

}

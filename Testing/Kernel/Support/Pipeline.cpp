#include "Support/Pipeline.h"

#include "Surface/LineCrossings.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace cartesian
{

namespace
{

// Moves the cells, hexahedra first as they were written, to the places that their numbers say.
void sortCells(MeshArrays& a, const std::vector<Id>& number)
{
  std::vector<std::size_t> order(number.size());
  for (std::size_t c = 0; c < number.size(); ++c)
  {
    order.at(static_cast<std::size_t>(number[c])) = c;
  }
  const MeshArrays written = a;
  a.offsets.assign(1, 0);
  a.connectivity.clear();
  a.faceStream.clear();
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const std::size_t c = order[i];
    const auto first = written.connectivity.begin();
    a.connectivity.insert(
      a.connectivity.end(), first + written.offsets[c], first + written.offsets[c + 1]);
    a.offsets.push_back(static_cast<Id>(a.connectivity.size()));
    a.types[i] = written.types[c];
    a.faceStart[i] = -1;
    if (const Id start = written.faceStart[c]; start >= 0)
    {
      a.faceStart[i] = static_cast<Id>(a.faceStream.size());
      const auto stream = written.faceStream.begin() + start;
      auto end = stream + 1;
      for (Id face = 0; face < *stream; ++face)
      {
        end += *end + 1;
      }
      a.faceStream.insert(a.faceStream.end(), stream, end);
    }
    std::copy_n(written.globalBox.begin() + 3 * std::ptrdiff_t(c), 3, &a.globalBox[3 * i]);
    std::copy_n(written.level.begin() + 3 * std::ptrdiff_t(c), 3, &a.level[3 * i]);
    a.region[i] = written.region[c];
    a.volumeFraction[i] = written.volumeFraction[c];
  }
}

}

MeshArrays arraysOf(const OutputMesh& mesh, const Boxes& boxes, Execution& execution)
{
  MeshArrays a;
  const auto cells = static_cast<std::size_t>(mesh.cellCount());
  a.points.resize(3 * static_cast<std::size_t>(mesh.pointCount()));
  a.offsets.resize(cells + 1);
  a.connectivity.resize(static_cast<std::size_t>(mesh.connectivitySize()));
  a.types.resize(cells);
  a.faceStart.resize(cells);
  a.faceStream.resize(static_cast<std::size_t>(mesh.faceStreamSize()));
  std::vector<Id> number(cells);
  a.globalBox.resize(3 * cells);
  a.level.resize(3 * cells);
  a.region.resize(cells);
  a.volumeFraction.resize(cells);
  mesh.writePoints(a.points.data(), execution);
  mesh.writeCells({ a.offsets.data(), a.connectivity.data(), a.types.data(), a.faceStart.data(),
                    a.faceStream.data(), MeshArrays::Hexahedron, MeshArrays::Polyhedron },
    execution);
  mesh.writeCellData(
    { number.data(), a.globalBox.data(), a.level.data(), a.region.data(), a.volumeFraction.data() },
    execution);
  EXPECT_TRUE(std::is_sorted(a.types.begin(), a.types.end())) << "hexahedra are not first";
  sortCells(a, number);

  const BoundaryMesh boundary = mesh.boundaryMesh(execution);
  a.boundaryStart = boundary.start;
  for (const Id corner : boundary.corners)
  {
    a.boundaryPoints.push_back(boundary.meshPoint.at(static_cast<std::size_t>(corner)));
  }
  for (const BoundaryFace& face : mesh.boundary())
  {
    a.boundaryCell.push_back(face.cell);
    a.boundaryIndex.push_back(face.boundary);
  }
  a.step = boxes.lattice.step();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const Level level : boxes.planes[axis])
    {
      a.meshlines[axis].push_back(boxes.lattice.position(axis, level));
    }
  }
  return a;
}

bool MeshArrays::operator==(const MeshArrays& other) const
{
  const auto all = [](const MeshArrays& a) {
    return std::tie(a.points, a.offsets, a.connectivity, a.types, a.faceStart, a.faceStream,
      a.globalBox, a.level, a.region, a.volumeFraction, a.boundaryStart, a.boundaryPoints,
      a.boundaryCell, a.boundaryIndex, a.meshlines, a.step);
  };
  return all(*this) == all(other);
}

PatchSpec exactFit()
{
  PatchSpec spec;
  spec.method = PatchMethod::ExactFit;
  return spec;
}

TestOptions asTheyAre(double smallCellRatio, const RefinementSpec& refinement, int threads)
{
  TestOptions options;
  options.refinement = refinement;
  options.patches = exactFit();
  options.collapse.ratio = 0;
  options.smallCells.ratio = smallCellRatio;
  options.smallCells.handling = SmallCells::Remove;
  options.shaping.splitConcave = false;
  options.threads = threads;
  return options;
}

namespace
{

// Cells of a region have points of their own on interfaces.
void copyPoints(MeshArrays& mesh, const std::vector<PointCopy>& copies)
{
  std::map<std::pair<std::int32_t, Id>, Id> copyOf;
  for (const PointCopy& copy : copies)
  {
    copyOf[{ copy.region, copy.point }] = copy.copy;
  }
  for (std::size_t c = 0; c < mesh.types.size() && !copyOf.empty(); ++c)
  {
    const auto set = [&](Id& point) {
      const auto found = copyOf.find({ mesh.region[c], point });
      point = found == copyOf.end() ? point : found->second;
    };
    std::for_each(mesh.connectivity.begin() + mesh.offsets[c],
      mesh.connectivity.begin() + mesh.offsets[c + 1], set);
    if (mesh.types[c] == MeshArrays::Polyhedron)
    {
      auto at = mesh.faceStream.begin() + mesh.faceStart[c];
      for (Id faces = *at++; faces > 0; --faces)
      {
        const Id size = *at++;
        std::for_each(at, at + size, set);
        at += size;
      }
    }
  }
}

}

MeshArrays withLayers(MeshArrays mesh, const BoundaryLayers& layers)
{
  copyPoints(mesh, layers.copies);
  const PrismStacks& stacks = layers.stacks;
  for (const MovedPoint& moved : stacks.moved)
  {
    std::copy(moved.to.begin(), moved.to.end(), mesh.points.begin() + 3 * moved.point);
  }
  mesh.points.insert(mesh.points.end(), stacks.points.begin(), stacks.points.end());
  const auto connectivity = static_cast<Id>(mesh.connectivity.size());
  const auto faceStream = static_cast<Id>(mesh.faceStream.size());
  mesh.connectivity.insert(
    mesh.connectivity.end(), stacks.connectivity.begin(), stacks.connectivity.end());
  mesh.faceStream.insert(mesh.faceStream.end(), stacks.faceStream.begin(), stacks.faceStream.end());
  mesh.offsets.pop_back();
  for (std::size_t c = 0; c < stacks.cells(); ++c)
  {
    const auto below = static_cast<std::size_t>(stacks.below[c]);
    mesh.offsets.push_back(connectivity + stacks.offsets[c]);
    mesh.faceStart.push_back(faceStream + stacks.faceStart[c]);
    mesh.types.push_back(MeshArrays::Polyhedron);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      mesh.globalBox.push_back(mesh.globalBox[3 * below + axis]);
      mesh.level.push_back(mesh.level[3 * below + axis]);
    }
    mesh.region.push_back(mesh.region[below]);
  }
  mesh.offsets.push_back(connectivity + stacks.offsets.back());
  mesh.volumeFraction.clear();
  const BoundaryMesh& boundary = layers.boundary.mesh;
  mesh.boundaryStart = boundary.start;
  mesh.boundaryPoints.clear();
  for (const Id corner : boundary.corners)
  {
    mesh.boundaryPoints.push_back(boundary.meshPoint.at(static_cast<std::size_t>(corner)));
  }
  mesh.boundaryCell.clear();
  mesh.boundaryIndex.clear();
  std::vector<Id> cellOf(layers.numbers.size());
  for (std::size_t c = 0; c < cellOf.size(); ++c)
  {
    cellOf[static_cast<std::size_t>(layers.numbers[c])] = static_cast<Id>(c);
  }
  for (const BoundaryFace& face : layers.boundary.faces)
  {
    mesh.boundaryCell.push_back(cellOf[static_cast<std::size_t>(face.cell)]);
    mesh.boundaryIndex.push_back(face.boundary);
  }
  return mesh;
}

std::map<std::string, double> statisticsOf(const Assembly& assembly)
{
  std::map<std::string, double> values;
  for (const Statistic& statistic : statistics(assembly))
  {
    values[statistic.name] = statistic.value;
  }
  return values;
}

GridSpec cellsOf(double size)
{
  GridSpec grid;
  grid.cellSize = size;
  return grid;
}

GridSpec cellsAlongLongest(const Soup& soup, double cells)
{
  return cellsOf(soup.longest() / cells);
}

RefinementSpec depth(int levels)
{
  RefinementSpec spec;
  spec.depth = levels;
  return spec;
}

PreparedSurface prepare(
  const Soup& soup, const GridSpec& grid, Execution& execution, double memoryLimit)
{
  Options options;
  options.grid = grid;
  options.memoryLimit = memoryLimit;
  return prepareSurface(soup.view(), options, execution);
}

PreparedSurface prepare(const Soup& soup, const GridSpec& grid, double memoryLimit)
{
  Execution execution;
  return prepare(soup, grid, execution, memoryLimit);
}

BoxedSurface boxSurface(
  const PreparedSurface& prepared, const RefinementSpec& refinement, Execution& execution)
{
  Options options;
  options.refinement = refinement;
  const auto decomposition = decompose(prepared, options, execution);
  Boxes boxes = decomposition->boxes(decomposition->allLayers(), execution);
  return { std::move(boxes), decomposition->shoeboxes(), decomposition->warnings() };
}

Meshlines randomPlanes(unsigned seed, int width)
{
  std::mt19937 random(seed);
  Meshlines planes;
  for (auto& levels : planes)
  {
    for (int i = 0; i <= width + 1; ++i)
    {
      levels.push_back(static_cast<Level>(2 * i));
    }
    std::shuffle(levels.begin(), levels.end(), random);
    levels.resize(2 + random() % static_cast<unsigned>(width + 1));
    std::sort(levels.begin(), levels.end());
  }
  return planes;
}

PreparedSurface prepareOnLevels(const Soup& soup, const Meshlines& planes)
{
  Execution execution;
  PreparedSurface prepared;
  prepared.bounds = boundsOf(soup.view());
  prepared.planes = planes;
  prepared.surface = onLattice(soup.view(), Lattice({ 0, 0, 0 }, 1), execution);
  prepared.repair = repair(prepared.surface, planes, {}, execution);
  prepared.memoryLimit = { 1e11 };
  return prepared;
}

std::unique_ptr<Assembly> assembledOf(
  const Soup& soup, const GridSpec& grid, const TestOptions& given, Execution& execution)
{
  Options options = given;
  options.grid = grid;
  options.memoryLimit = PlentyOfMemory;
  const PreparedSurface prepared = prepareSurface(soup.view(), options, execution);
  const auto decomposition = decompose(prepared, options, execution);
  return meshPart(prepared, *decomposition, decomposition->allLayers(), options, execution);
}

std::unique_ptr<Assembly> cutCellsOf(
  const Soup& soup, const GridSpec& grid, const TestOptions& given, Execution& execution)
{
  Options options = given;
  options.grid = grid;
  options.memoryLimit = PlentyOfMemory;
  const PreparedSurface prepared = prepareSurface(soup.view(), options, execution);
  const auto decomposition = decompose(prepared, options, execution);
  Boxes boxes = decomposition->boxes(decomposition->allLayers(), execution);
  Patches patches = makePatches(prepared, *decomposition, boxes, options, execution);
  return cutCells(std::move(boxes), std::move(patches), options, execution,
    { prepared.keepPoints, prepared.keepOut, &prepared.surface, prepared.isEnclosed });
}

Meshed meshPrepared(const PreparedSurface& prepared, const TestOptions& options)
{
  Execution execution(options.threads);
  const auto decomposition = decompose(prepared, options, execution);
  const auto assembly =
    meshPart(prepared, *decomposition, decomposition->allLayers(), options, execution);
  Meshed result;
  result.prepared = prepared;
  result.mesh = arraysOf(*assembly->mesh, assembly->boxes, execution);
  result.flawedBoxes = flawedBoxes(*assembly);
  result.statistics = statisticsOf(*assembly);
  result.patches = assembly->patches;
  result.boxed = { std::move(assembly->boxes), decomposition->shoeboxes(),
    decomposition->warnings() };
  return result;
}

Meshed meshOf(const Soup& soup, const GridSpec& grid, const TestOptions& options)
{
  Options whole = options;
  whole.grid = grid;
  whole.memoryLimit = PlentyOfMemory;
  Execution execution;
  return meshPrepared(prepareSurface(soup.view(), whole, execution), options);
}

std::vector<Winding> windings(const Surface& surface, const Meshlines& planes, int axis)
{
  Execution execution;
  const LineCrossings lines(surface, planes, axis, execution);
  const RowAxes& axes = lines.axes();
  std::vector<Winding> result;
  std::array<std::uint32_t, 3> v{};
  for (v[2] = 0; v[2] < planes[2].size(); ++v[2])
  {
    for (v[1] = 0; v[1] < planes[1].size(); ++v[1])
    {
      for (v[0] = 0; v[0] < planes[0].size(); ++v[0])
      {
        result.push_back(lines.at(v[axes.middle], v[axes.outer], v[axis]));
      }
    }
  }
  return result;
}

Shoeboxes shoeboxesOf(const Surface& surface, const Meshlines& planes)
{
  Execution execution;
  return fillShoeboxes(surface, planes, execution);
}

}

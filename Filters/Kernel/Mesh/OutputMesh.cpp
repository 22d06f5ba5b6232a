// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/OutputMesh.h"

#include "Parts/Halos.h"

#include <algorithm>
#include <atomic>

namespace cartesian
{

namespace
{

constexpr std::size_t RowsAChunk = 2; // few rows of deeply divided boxes have most of the cells
constexpr std::size_t CellsAChunk = 512;
constexpr std::size_t PointsAChunk = 1 << 13;

constexpr std::array<std::array<std::size_t, 4>, 6> SidesOfHexahedron{ { { 0, 4, 7, 3 },
  { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } } };

}

OutputMesh::OutputMesh(const MeshParts& parts, Execution& execution)
  : parts_(parts)
  , numbers_(numberCells(parts, execution))
  , points_(parts, parts.boxes.core, execution)
  , ownPoints_(pointCount())
{
  const SlabRange core = parts.boxes.core;
  // Cells that extend into other layers decide which points of those are used: where walls were edited, all are here.
  const SlabRange all = parts.boxes.allLayers();
  const bool areAllHere = parts.boxes.kept.begin == all.begin && parts.boxes.kept.end == all.end;
  const SlabRange around = areAllHere ? all : core.grown(HaloOfCells, all.end);
  if (around.begin != core.begin || around.end != core.end)
  {
    pointsAround_ = std::make_unique<PointNumbers>(parts, around, execution);
    const bool isLast = core.end == parts.boxes.allLayers().end;
    const std::size_t end = isLast ? pointsAround_->size() : pointsAround_->firstOfLayer(core.end);
    ownPoints_ = static_cast<Id>(end - pointsAround_->firstOfLayer(core.begin));
  }
  measureCells(execution);
  placeRows();
  boundary_ = collectBoundary(parts_, numbers_, execution);
  if (parts.patches.walls.any())
  {
    listInterfaces();
  }
  failures_ = countFailures(parts_, numbers_, execution);
}

void OutputMesh::listInterfaces()
{
  const WallMesh& wall = parts_.wall;
  for (std::size_t c = numbers_.coreBegin; c < numbers_.coreEnd; ++c)
  {
    wall.forEachUse(c, [&](const FaceUse& use) {
      if (wall.cells[c].removed || use.turned || !wall.isInterface(use.face))
      {
        return;
      }
      const std::uint32_t number = numbers_.ofCell[wall.faces.beyond(use)];
      const std::int32_t between = wall.faces.boundary[use.face];
      if (number != None && !parts_.patches.walls.isBaffle(between))
      {
        interfaces_.push_back({ numbers_.ofCell[c], use.face, between, kindOf(wall.faces, use) });
        inFront_.push_back(CellNumbers::isHere(number) ? static_cast<Id>(number) : Id(-1));
      }
    });
  }
}

void OutputMesh::measureCells(Execution& execution)
{
  const WallMesh& wall = parts_.wall;
  cellSizes_.resize(wall.size());
  const std::size_t first = numbers_.coreBegin;
  execution.nextLoop(0.4);
  execution.forEach(numbers_.coreEnd - first, CellsAChunk, [&](std::size_t begin, std::size_t end) {
    CellPoints points;
    for (std::size_t c = first + begin; c < first + end; ++c)
    {
      if (wall.cells[c].removed)
      {
        continue;
      }
      std::uint32_t stream = 1;
      wall.forEachUse(c, [&](const FaceUse& use) {
        const auto size = wall.faces.start[use.face + 1u] - wall.faces.start[use.face];
        stream += 1 + static_cast<std::uint32_t>(size);
      });
      points.reset(stream);
      wall.forEachUse(
        c, [&](const FaceUse& use) { forEachPoint(use, [&](Id point) { points.add(point); }); });
      cellSizes_[c] = { static_cast<std::uint32_t>(points.points.size()), stream };
    }
  });
}

void OutputMesh::placeRows()
{
  const auto [begin, end] = coreRows();
  RowOffsets sum{ numbers_.coreBegin, 0, 0 };
  for (std::size_t row = 0; row + 1 < parts_.boxes.rowStart.size(); ++row)
  {
    rows_.push_back(sum);
    if (row < begin || row >= end)
    {
      continue;
    }
    for (std::size_t& c = sum.cell;
         c < numbers_.coreEnd && parts_.wall.cells[c].box < firstBoxOfRow(row + 1); ++c)
    {
      sum.connectivity += cellSizes_[c].points;
      sum.faceStream += cellSizes_[c].faceStream;
    }
  }
  rows_.push_back(sum);
  hexahedra_ = hexahedraBefore(parts_.boxes.firstBoxOf(parts_.boxes.core.end));
}

std::size_t OutputMesh::hexahedraBefore(std::size_t box) const
{
  const std::vector<std::uint32_t>& polyhedral = parts_.sides.polyhedral;
  const std::size_t first = parts_.boxes.firstBoxOf(parts_.boxes.core.begin);
  const auto begin = std::lower_bound(polyhedral.begin(), polyhedral.end(), first);
  const auto end = std::lower_bound(begin, polyhedral.end(), box);
  return box - first - static_cast<std::size_t>(end - begin);
}

std::size_t OutputMesh::boxOf(Id cell) const
{
  const Boxes& boxes = parts_.boxes;
  const auto of = [&](std::uint32_t layer) {
    return numbers_.ofBox.begin() + static_cast<std::ptrdiff_t>(boxes.firstBoxOf(layer));
  };
  const auto next = std::upper_bound(of(boxes.core.begin), of(boxes.core.end), cell,
    [](Id number, std::uint32_t first) { return number < static_cast<Id>(first); });
  return static_cast<std::size_t>(next - numbers_.ofBox.begin()) - 1;
}

std::size_t OutputMesh::placeOfPolyhedron(std::size_t cell) const
{
  return hexahedra_ + numbers_.ofCell[cell] - hexahedraBefore(parts_.wall.cells[cell].box);
}

// Calls visitVertex(point, i, j, k) for vertices of the global mesh, and visitNode(point, node) for nodes,
// some of which are vertices.
template <class VertexVisitor, class NodeVisitor>
void OutputMesh::forEachPoint(
  VertexVisitor&& visitVertex, NodeVisitor&& visitNode, Execution& execution) const
{
  const std::size_t rowLength = parts_.boxes.planes[1].size();
  execution.forEach(
    pointRows(parts_.boxes.planes), RowsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
      {
        points_.forEachVertex(row, [&](std::size_t point, std::uint32_t i) {
          visitVertex(point, i, static_cast<std::uint32_t>(row % rowLength),
            static_cast<std::uint32_t>(row / rowLength));
        });
      }
    });
  execution.forEach(parts_.nodes.at.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
    {
      if (points_.ofNode(node) != None)
      {
        visitNode(points_.ofNode(node), node);
      }
    }
  });
}

void OutputMesh::writePoints(double* xyz, Execution& execution) const
{
  const auto write = [&](std::size_t point, const Point& at) {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      xyz[3 * point + axis] = parts_.boxes.lattice.position(static_cast<int>(axis), at[axis]);
    }
  };
  const Meshlines& planes = parts_.boxes.planes;
  forEachPoint(
    [&](std::size_t point, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      write(point, { planes[0][i], planes[1][j], planes[2][k] });
    },
    [&](std::size_t point, std::size_t node) { write(point, parts_.nodes.at[node]); }, execution);
}

void OutputMesh::writeGlobalPoints(Id before, Id* ids, Execution& execution) const
{
  const PointNumbers& around = pointsAround_ ? *pointsAround_ : points_;
  const Id offset = before - static_cast<Id>(around.firstOfLayer(parts_.boxes.core.begin));
  forEachPoint([&](std::size_t point, std::uint32_t i, std::uint32_t j,
                 std::uint32_t k) { ids[point] = offset + around.ofVertex(i, j, k); },
    [&](std::size_t point, std::size_t node) { ids[point] = offset + around.ofNode(node); },
    execution);
}

void OutputMesh::addFaces(const CellOfMesh& cell, CellFaces& cells) const
{
  const auto close = [&] { cells.firstCorner.push_back(cells.corners.size()); };
  const auto add = [&](Id point) { cells.corners.push_back(static_cast<std::uint32_t>(point)); };
  if (cell.ofWall == None)
  {
    for (const auto& side : SidesOfHexahedron)
    {
      std::for_each(side.begin(), side.end(), [&](std::size_t i) { add(cell.corners[i]); });
      close();
    }
  }
  else
  {
    parts_.wall.forEachUse(cell.ofWall, [&](const FaceUse& use) {
      forEachPoint(use, add);
      close();
    });
  }
  cells.firstFace.push_back(cells.faceCount());
}

void OutputMesh::writeCells(const CellArrays& arrays, Execution& execution) const
{
  const std::array<std::size_t, 2> rows = coreRows();
  execution.nextLoop(0.6);
  execution.forEach(rows[1] - rows[0], RowsAChunk, [&](std::size_t begin, std::size_t end) {
    CellPoints points;
    for (std::size_t row = rows[0] + begin; row < rows[0] + end; ++row)
    {
      writeRow(row, arrays, points);
    }
  });
  arrays.offsets[cellCount()] = connectivitySize();
}

void OutputMesh::writeRow(std::size_t row, const CellArrays& arrays, CellPoints& points) const
{
  forEachHexahedron(row, [&](const CellOfMesh& cell) {
    const Id start = CornersOfAHexahedron * static_cast<Id>(cell.place);
    std::copy(cell.corners.begin(), cell.corners.end(), arrays.connectivity + start);
    arrays.offsets[cell.place] = start;
    arrays.types[cell.place] = arrays.hexahedron;
    arrays.faceStart[cell.place] = -1;
  });
  RowOffsets at = rows_[row];
  at.connectivity += CornersOfAHexahedron * static_cast<Id>(hexahedra_);
  forEachPolyhedron(row, [&](const CellOfMesh& cell) {
    writeFaces(cell.ofWall, arrays.faceStream + at.faceStream, points);
    std::sort(points.points.begin(), points.points.end());
    std::copy(points.points.begin(), points.points.end(), arrays.connectivity + at.connectivity);
    arrays.offsets[cell.place] = at.connectivity;
    arrays.types[cell.place] = arrays.polyhedron;
    arrays.faceStart[cell.place] = at.faceStream;
    at.connectivity += cellSizes_[cell.ofWall].points;
    at.faceStream += cellSizes_[cell.ofWall].faceStream;
  });
}

// Also lists the points of the cell.
void OutputMesh::writeFaces(std::size_t cell, Id* stream, CellPoints& points) const
{
  points.reset(cellSizes_[cell].faceStream);
  const WallMesh& wall = parts_.wall;
  *stream++ = static_cast<Id>(wall.cells[cell + 1].firstUse - wall.cells[cell].firstUse);
  wall.forEachUse(cell, [&](const FaceUse& use) {
    Id* const size = stream++;
    forEachPoint(use, [&](Id point) {
      *stream++ = point;
      points.add(point);
    });
    *size = static_cast<Id>(stream - size - 1);
  });
}

void OutputMesh::writeCellData(const CellData& data, Execution& execution) const
{
  const auto write = [&](std::size_t id, std::uint32_t number, std::size_t b, std::int32_t region,
                       double fraction) {
    const PackedBox& box = parts_.boxes.packed[b];
    data.number[id] = number;
    for (int axis = 0; axis < 3; ++axis)
    {
      data.globalBox[3 * id + axis] = static_cast<int>(parts_.boxes.globalOf(box).index[axis]);
      data.level[3 * id + axis] = box.level[axis];
    }
    data.region[id] = parts_.patches.walls.givenOf(region);
    data.volumeFraction[id] = fraction;
  };
  const Boxes& boxes = parts_.boxes;
  const std::size_t firstBox = boxes.firstBoxOf(boxes.core.begin);
  execution.forEach(boxes.firstBoxOf(boxes.core.end) - firstBox, CellsAChunk,
    [&](std::size_t begin, std::size_t end) {
      std::size_t id = hexahedraBefore(firstBox + begin);
      for (std::size_t b = firstBox + begin; b < firstBox + end; ++b)
      {
        if (parts_.sides.polyhedralOrdinal(static_cast<std::uint32_t>(b)) == None)
        {
          write(id++, numbers_.ofBox[b], b, boxes.regionOf(b), 1);
        }
      }
    });
  const std::vector<Cell>& cells = parts_.wall.cells;
  const std::size_t first = numbers_.coreBegin;
  execution.forEach(numbers_.coreEnd - first, CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = first + begin; c < first + end; ++c)
    {
      if (!cells[c].removed)
      {
        write(placeOfPolyhedron(c), numbers_.ofCell[c], cells[c].box, cells[c].region,
          cells[c].volumeFraction);
      }
    }
  });
}

template <class Visitor>
void OutputMesh::forEachPoint(const BoundaryFace& face, Visitor&& visit) const
{
  if (face.kind != BoundaryFace::Kind::BoxSide)
  {
    forEachPoint(face.use(), visit);
    return;
  }
  const std::size_t box = face.index / 6;
  const auto& at = parts_.boxes.globalOf(parts_.boxes.packed[box]).index;
  const std::array<Id, 8> p = corners(box, [&](std::uint32_t line, std::uint32_t i) {
    return points_.ofVertex(i, at[1] + (line & 1), at[2] + (line >> 1));
  });
  const bool upper = face.index % 2 == 1;
  const std::array<unsigned, 4> side =
    sideCorners(static_cast<int>(face.index % 6 / 2), upper ? 1 : 0);
  for (int i = 0; i < 4; ++i)
  {
    visit(p[side[upper ? i : 3 - i]]);
  }
}

// Lists the points of faces, in order. Returns the index of each of the mesh's points there.
RawVector<std::uint32_t> OutputMesh::numberPointsOf(
  const std::vector<BoundaryFace>& faces, std::vector<Id>& points, Execution& execution) const
{
  const auto count = static_cast<std::size_t>(pointCount());
  std::vector<std::atomic<bool>> used(count);
  execution.forEach(faces.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
    {
      forEachPoint(faces[f], [&](Id point) {
        used[static_cast<std::size_t>(point)].store(true, std::memory_order_relaxed);
      });
    }
  });
  const auto isUsed = [&](std::size_t p) { return used[p].load(std::memory_order_relaxed); };
  std::vector<std::uint32_t> first(chunks(count, PointsAChunk));
  execution.forEach(count, PointsAChunk, [&](std::size_t begin, std::size_t end) {
    std::uint32_t sum = 0;
    for (std::size_t p = begin; p < end; ++p)
    {
      sum += isUsed(p) ? 1 : 0;
    }
    first[begin / PointsAChunk] = sum;
  });
  points.resize(scan(first));
  RawVector<std::uint32_t> places(count); // undefined for points of no such face
  execution.forEach(count, PointsAChunk, [&](std::size_t begin, std::size_t end) {
    std::uint32_t next = first[begin / PointsAChunk];
    for (std::size_t p = begin; p < end; ++p)
    {
      if (isUsed(p))
      {
        points[next] = static_cast<Id>(p);
        places[p] = next++;
      }
    }
  });
  return places;
}

BoundaryMesh OutputMesh::meshOf(const std::vector<BoundaryFace>& faces, Execution& execution) const
{
  BoundaryMesh result;
  result.start.assign(faces.size() + 1, 0);
  execution.forEach(faces.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
    {
      forEachPoint(faces[f], [&](Id) { ++result.start[f]; });
    }
  });
  result.corners.resize(static_cast<std::size_t>(scan(result.start)));
  const RawVector<std::uint32_t> local = numberPointsOf(faces, result.meshPoint, execution);
  execution.forEach(faces.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
    {
      auto next = static_cast<std::size_t>(result.start[f]);
      forEachPoint(faces[f],
        [&](Id point) { result.corners[next++] = local[static_cast<std::size_t>(point)]; });
    }
  });
  return result;
}

}

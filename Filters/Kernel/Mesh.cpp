#include "Mesh.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t RowsAChunk = 16;
constexpr std::size_t CellsAChunk = 1024;
constexpr Id CornersOfAHexahedron = 8;

}

// Corners of a face, counter-clockwise from outside its cell, as nodes passed on as points.
template <class Visitor>
void Mesh::forEachPoint(const FaceRef& face, Visitor&& visit) const
{
  forEachNode(face, parts_.patches, parts_.inner, parts_.cells.shaped,
    [&](std::uint32_t node) { visit(static_cast<Id>(nodePoint_[node])); });
}

Mesh::Mesh(const MeshParts& parts, Execution& execution)
  : parts_(parts)
  , numbers_(numberCells(parts))
  , used_(usedNodes())
  , vertices_(parts.boxes, parts.sides, parts.nodes, used_, execution)
{
  numberNodes();
  measureCells(execution);
  placeRows();
  boundary_ = collectBoundary(parts_, numbers_);
  failures_ = countFailures(parts_, numbers_, boundary_, execution);
}

std::vector<std::uint8_t> Mesh::usedNodes() const
{
  std::vector<std::uint8_t> used(parts_.nodes.at.size());
  const auto mark = [&](const FaceRef& face) {
    forEachNode(face, parts_.patches, parts_.inner, parts_.cells.shaped,
      [&](std::uint32_t node) { used[node] = 1; });
  };
  const Cells& cells = parts_.cells;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (std::size_t f = cells.cells[c].firstFace;
         !cells.cells[c].removed && f < cells.cells[c + 1].firstFace; ++f)
    {
      mark(cells.faces[f]);
    }
  }
  // A hexahedron keeps its faces, whatever became of the cells beyond.
  for (std::size_t s = 0; s < parts_.sides.sides.size(); ++s)
  {
    const Side& side = parts_.sides.sides[s];
    const std::uint32_t other =
      parts_.sides.polyhedralOrdinal(side.low) == None ? side.low : side.high;
    const bool hexahedron = other != None && parts_.sides.polyhedralOrdinal(other) == None;
    for (std::size_t f = parts_.inner.sideStart[s]; hexahedron && f < parts_.inner.sideStart[s + 1];
         ++f)
    {
      mark(FaceRef(f, FaceRef::Kind::Inner));
    }
  }
  for (std::size_t i = 0; i < parts_.nodes.ofDivided.size(); ++i)
  {
    const bool hexahedron = parts_.sides.polyhedralOrdinal(parts_.sides.divided[i]) == None;
    for (std::size_t corner = 0; hexahedron && corner < 8; ++corner)
    {
      used[parts_.nodes.ofDivided[i][corner]] = 1;
    }
  }
  return used;
}

void Mesh::numberNodes()
{
  const Nodes& nodes = parts_.nodes;
  const std::size_t rowLength = parts_.boxes.planes[1].size();
  nodePoint_.assign(used_.size(), None);
  points_ = vertices_.size();
  for (std::size_t row = 0; row + 1 < nodes.rowStart.size(); ++row)
  {
    const std::size_t j = row % rowLength;
    const std::size_t k = row / rowLength;
    for (std::size_t c = nodes.rowStart[row]; c < nodes.rowStart[row + 1]; ++c)
    {
      const std::size_t node = nodes.patchPoints + c;
      if (used_[node])
      {
        std::uint32_t i = 0;
        const bool vertex = VertexRows::isVertex(parts_.boxes.planes, nodes.grid[c], j, k, i);
        nodePoint_[node] = static_cast<std::uint32_t>(vertex
            ? vertices_.number(i, static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(k))
            : points_++);
      }
    }
  }
  for (const VertexNode& vertex : nodes.moreVertices)
  {
    if (used_[vertex.node])
    {
      nodePoint_[vertex.node] =
        static_cast<std::uint32_t>(vertices_.number(vertex.i, vertex.j, vertex.k));
    }
  }
  const auto number = [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
    {
      if (used_[node] && nodePoint_[node] == None)
      {
        nodePoint_[node] = static_cast<std::uint32_t>(points_++);
      }
    }
  };
  number(0, nodes.patchPoints);
  number(nodes.patchPoints + nodes.rowStart.back(), used_.size());
}

void Mesh::distinctPoints(std::size_t cell, std::vector<Id>& points) const
{
  points.clear();
  const Cells& cells = parts_.cells;
  for (std::size_t f = cells.cells[cell].firstFace; f < cells.cells[cell + 1].firstFace; ++f)
  {
    forEachPoint(cells.faces[f], [&](Id point) { points.push_back(point); });
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

void Mesh::measureCells(Execution& execution)
{
  const Cells& cells = parts_.cells;
  cellSizes_.resize(cells.size());
  execution.nextLoop(0.4);
  execution.forEach(cells.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    std::vector<Id> points;
    for (std::size_t c = begin; c < end; ++c)
    {
      if (cells.cells[c].removed)
      {
        continue;
      }
      distinctPoints(c, points);
      cellSizes_[c].points = static_cast<std::uint32_t>(points.size());
      std::uint32_t stream = 1;
      for (std::size_t f = cells.cells[c].firstFace; f < cells.cells[c + 1].firstFace; ++f)
      {
        ++stream;
        forEachPoint(cells.faces[f], [&](Id) { ++stream; });
      }
      cellSizes_[c].faceStream = stream;
    }
  });
}

void Mesh::placeRows()
{
  const Boxes& boxes = parts_.boxes;
  RowOffsets sum;
  std::size_t c = 0;
  for (std::size_t row = 0; row + 1 < boxes.rowStart.size(); ++row)
  {
    rows_.push_back(sum);
    for (std::size_t b = firstBoxOfRow(row); b < firstBoxOfRow(row + 1); ++b)
    {
      if (parts_.sides.polyhedralOrdinal(static_cast<std::uint32_t>(b)) == None)
      {
        sum.connectivity += CornersOfAHexahedron;
        continue;
      }
      for (; c < parts_.cells.size() && parts_.cells.cells[c].box == b; ++c)
      {
        sum.connectivity += cellSizes_[c].points;
        sum.faceStream += cellSizes_[c].faceStream;
      }
    }
  }
  rows_.push_back(sum);
}

std::array<Id, 8> Mesh::corners(std::size_t box) const
{
  std::array<Id, 8> p;
  const std::uint32_t ordinal = parts_.sides.ordinal[box];
  if (ordinal != None)
  {
    const auto& nodes = parts_.nodes.ofDivided[ordinal & ~Sides::HexahedronBit];
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      p[corner] = nodePoint_[nodes[corner]];
    }
    return p;
  }
  const auto& at = parts_.boxes.globalOf(parts_.boxes.boxes[box]).index;
  for (std::uint32_t corner = 0; corner < 8; corner += 2)
  {
    p[corner] =
      static_cast<Id>(vertices_.number(at[0], at[1] + (corner >> 1 & 1), at[2] + (corner >> 2)));
    p[corner + 1] = p[corner] + 1;
  }
  return p;
}

void Mesh::writePoints(double* xyz, Execution& execution) const
{
  const Lattice& lattice = parts_.boxes.lattice;
  const Meshlines& planes = parts_.boxes.planes;
  const std::size_t rowLength = planes[1].size();
  execution.forEach(
    rowLength * planes[2].size(), RowsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
      {
        vertices_.forEach(row, [&](std::size_t number, std::uint32_t i) {
          xyz[3 * number] = lattice.position(0, planes[0][i]);
          xyz[3 * number + 1] = lattice.position(1, planes[1][row % rowLength]);
          xyz[3 * number + 2] = lattice.position(2, planes[2][row / rowLength]);
        });
      }
    });
  execution.forEach(parts_.nodes.at.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
    {
      for (int axis = 0; used_[node] && axis < 3; ++axis)
      {
        xyz[3 * std::size_t(nodePoint_[node]) + axis] =
          lattice.position(axis, parts_.nodes.at[node][axis]);
      }
    }
  });
}

void Mesh::writeCells(const CellArrays& arrays, Execution& execution) const
{
  execution.nextLoop(0.6);
  execution.forEach(rows_.size() - 1, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    std::vector<Id> scratch;
    for (std::size_t row = begin; row < end; ++row)
    {
      writeRow(row, arrays, scratch);
    }
  });
  arrays.offsets[cellCount()] = connectivitySize();
}

void Mesh::writeRow(std::size_t row, const CellArrays& arrays, std::vector<Id>& scratch) const
{
  RowOffsets at = rows_[row];
  for (std::size_t b = firstBoxOfRow(row); b < firstBoxOfRow(row + 1); ++b)
  {
    std::size_t id = numbers_.ofBox[b];
    const std::uint32_t n = parts_.sides.polyhedralOrdinal(static_cast<std::uint32_t>(b));
    if (n == None)
    {
      const std::array<Id, 8> p = corners(b);
      constexpr std::array<int, 8> order = { 0, 1, 3, 2, 4, 5, 7, 6 };
      for (int i = 0; i < 8; ++i)
      {
        arrays.connectivity[at.connectivity + i] = p[order[i]];
      }
      arrays.offsets[id] = at.connectivity;
      arrays.types[id] = arrays.hexahedron;
      arrays.faceStart[id] = -1;
      at.connectivity += CornersOfAHexahedron;
      continue;
    }
    for (std::size_t c = parts_.cells.boxStart[n]; c < parts_.cells.boxStart[n + 1]; ++c)
    {
      if (parts_.cells.cells[c].removed)
      {
        continue;
      }
      distinctPoints(c, scratch);
      std::copy(scratch.begin(), scratch.end(), arrays.connectivity + at.connectivity);
      writeFaces(c, arrays.faceStream + at.faceStream);
      arrays.offsets[id] = at.connectivity;
      arrays.types[id] = arrays.polyhedron;
      arrays.faceStart[id] = at.faceStream;
      at.connectivity += cellSizes_[c].points;
      at.faceStream += cellSizes_[c].faceStream;
      ++id;
    }
  }
}

void Mesh::writeFaces(std::size_t cell, Id* stream) const
{
  const Cells& cells = parts_.cells;
  const std::size_t begin = cells.cells[cell].firstFace;
  const std::size_t end = cells.cells[cell + 1].firstFace;
  *stream++ = static_cast<Id>(end - begin);
  for (std::size_t f = begin; f < end; ++f)
  {
    Id* const size = stream++;
    forEachPoint(cells.faces[f], [&](Id point) { *stream++ = point; });
    *size = static_cast<Id>(stream - size - 1);
  }
}

void Mesh::writeCellData(const CellData& data, Execution& execution) const
{
  const auto write = [&](std::size_t id, const Box& box, double fraction) {
    for (int axis = 0; axis < 3; ++axis)
    {
      data.globalBox[3 * id + axis] = static_cast<int>(parts_.boxes.globalOf(box).index[axis]);
      data.level[3 * id + axis] = box.level[axis];
    }
    data.region[id] = FirstRegion;
    data.volumeFraction[id] = fraction;
  };
  const Boxes& boxes = parts_.boxes;
  execution.forEach(boxes.boxes.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
    {
      if (parts_.sides.polyhedralOrdinal(static_cast<std::uint32_t>(b)) == None)
      {
        write(numbers_.ofBox[b], boxes.boxes[b], 1);
      }
    }
  });
  const Cells& cells = parts_.cells;
  execution.forEach(cells.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      if (!cells.cells[c].removed)
      {
        write(numbers_.ofCell[c], boxes.boxes[cells.cells[c].box], cells.cells[c].volumeFraction);
      }
    }
  });
}

template <class Visitor>
void Mesh::forEachPoint(const BoundaryFace& face, Visitor&& visit) const
{
  switch (face.kind)
  {
    case BoundaryFace::Kind::Patch:
      forEachPoint(FaceRef(face.index, FaceRef::Kind::Patch), visit);
      break;
    case BoundaryFace::Kind::Inner:
      forEachPoint(FaceRef(face.index, FaceRef::Kind::Inner), visit);
      break;
    case BoundaryFace::Kind::TurnedInner:
      forEachPoint(FaceRef(face.index, FaceRef::Kind::TurnedInner), visit);
      break;
    case BoundaryFace::Kind::Shaped:
      forEachPoint(FaceRef(face.index, FaceRef::Kind::Shaped), visit);
      break;
    case BoundaryFace::Kind::TurnedShaped:
      forEachPoint(FaceRef(face.index, FaceRef::Kind::TurnedShaped), visit);
      break;
    case BoundaryFace::Kind::BoxSide:
    {
      const std::array<Id, 8> p = corners(face.index / 6);
      const bool upper = face.index % 2 == 1;
      const std::array<unsigned, 4> side =
        sideCorners(static_cast<int>(face.index % 6 / 2), upper ? 1 : 0);
      for (int i = 0; i < 4; ++i)
      {
        visit(p[side[upper ? i : 3 - i]]);
      }
      break;
    }
  }
}

BoundaryMesh Mesh::boundaryMesh(Execution& execution) const
{
  BoundaryMesh result;
  result.start.assign(boundary_.size() + 1, 0);
  execution.forEach(boundary_.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
    {
      forEachPoint(boundary_[f], [&](Id) { ++result.start[f]; });
    }
  });
  result.corners.resize(static_cast<std::size_t>(scan(result.start)));
  std::vector<std::uint32_t> local(static_cast<std::size_t>(pointCount()));
  for (const BoundaryFace& face : boundary_)
  {
    forEachPoint(face, [&](Id point) { local[static_cast<std::size_t>(point)] = 1; });
  }
  for (std::size_t p = 0; p < local.size(); ++p)
  {
    if (local[p])
    {
      local[p] = static_cast<std::uint32_t>(result.meshPoint.size());
      result.meshPoint.push_back(static_cast<Id>(p));
    }
  }
  execution.forEach(boundary_.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
    {
      auto next = static_cast<std::size_t>(result.start[f]);
      forEachPoint(boundary_[f],
        [&](Id point) { result.corners[next++] = local[static_cast<std::size_t>(point)]; });
    }
  });
  return result;
}

}

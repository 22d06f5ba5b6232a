// SPDX-License-Identifier: BSD-3-Clause
// The finished mesh (section 6, steps 11 and 13): cells and points numbered and written.
//
// Cells are hexahedra (inside boxes without hanging nodes) and polyhedra, numbered in order of their boxes;
// points are in the order of PointNumbers.h. They are written directly into the caller's arrays: first all
// hexahedra, then all polyhedra, each in order of their numbers. VTK's Clip needs this: it loses cells of
// grids in which hexahedra come after polyhedra.
//
// The mesh of a part of the grid (Decomposition.h) has the cells of its core and the points that these use. The
// number of a cell in the whole mesh is its own plus the number of cells of all parts before;
// writeGlobalPoints gives those of points.
#pragma once

#include "Base/EdgeTable.h"
#include "Mesh/CellConditions.h"
#include "Mesh/PointNumbers.h"
#include "Quality/FaceList.h"

#include <algorithm>
#include <memory>

namespace cartesian
{

// The caller's arrays, of the sizes that OutputMesh gives. Hexahedra first.
struct CellArrays
{
  Id* offsets;              // cellCount() + 1
  Id* connectivity;         // connectivitySize(): points of each cell, hexahedra in VTK's order
  unsigned char* types;     // cellCount()
  Id* faceStart;            // cellCount(): where in faceStream, -1 for hexahedra
  Id* faceStream;           // faceStreamSize(): number of faces, then for each its size and points
  unsigned char hexahedron; // what to write into types
  unsigned char polyhedron;
};

// Of the cells as they are in CellArrays.
struct CellData
{
  Id* number;             // cellCount(): CellNumbers, by which BoundaryFace names cells
  int* globalBox;         // 3 * cellCount(): I, J, K
  unsigned char* level;   // 3 * cellCount(): halvings of the global box along x, y, z
  int* region;            // cellCount()
  double* volumeFraction; // cellCount(): volume divided by its box's; above 1 for merged cells
};

// A cell, to be read from where the mesh has it.
struct CellOfMesh
{
  std::size_t place;           // as CellArrays has them
  std::uint32_t ofWall;        // its number in the wall mesh, or None: a hexahedron
  std::array<Id, 8> corners{}; // of a hexahedron, in VTK's order
};

// The boundary faces by themselves, with points numbered in the order of the mesh's.
struct BoundaryMesh
{
  std::vector<Id> start;     // first corner of each face, and the end
  std::vector<Id> corners;   // indices into meshPoint, counter-clockwise from outside
  std::vector<Id> meshPoint; // the mesh's point
};

class OutputMesh
{
public:
  OutputMesh(const MeshParts& parts, Execution& execution);

  Id pointCount() const { return static_cast<Id>(points_.size()); }

  // The number of points that this part adds to those of the parts before: the points on its upper end
  // belong to the next part.
  Id ownPointCount() const { return ownPoints_; }
  Id cellCount() const { return numbers_.ofBox.back(); }
  Id connectivitySize() const
  {
    return CornersOfAHexahedron * static_cast<Id>(hexahedra_) + rows_.back().connectivity;
  }
  Id faceStreamSize() const { return rows_.back().faceStream; }
  const std::vector<BoundaryFace>& boundary() const { return boundary_; }
  const CellConditions& failures() const { return failures_; }
  const Boxes& boxes() const { return parts_.boxes; }

  // The box of a cell; the first of them if it has several. `cell`: as BoundaryFace names it.
  std::size_t boxOf(Id cell) const;

  void writePoints(double* xyz, Execution& execution) const;

  // Writes the number of each point in the whole mesh. `before`: the sum of ownPointCount() of the parts
  // before.
  void writeGlobalPoints(Id before, Id* ids, Execution& execution) const;

  void writeCells(const CellArrays& arrays, Execution& execution) const;

  // Calls visit(cell) for all cells, in the order of CellArrays.
  template <class Visitor>
  void forEachCell(Visitor&& visit) const
  {
    const auto [begin, end] = coreRows();
    forEachCellInRows(begin, end, visit);
  }

  // The rows of boxes with cells, and calls visit(cell) for all cells in some of these, hexahedra first.
  std::array<std::size_t, 2> coreRows() const
  {
    return { parts_.boxes.row(0, parts_.boxes.core.begin),
      parts_.boxes.row(0, parts_.boxes.core.end) };
  }
  template <class Visitor>
  void forEachCellInRows(std::size_t begin, std::size_t end, Visitor&& visit) const
  {
    for (std::size_t row = begin; row < end; ++row)
    {
      forEachHexahedron(row, visit);
    }
    for (std::size_t row = begin; row < end; ++row)
    {
      forEachPolyhedron(row, visit);
    }
  }

  // Calls visit(point) for the points of a cell, those of a polyhedron for each of its faces.
  template <class Visitor>
  void forEachPoint(const CellOfMesh& cell, Visitor&& visit) const
  {
    if (cell.ofWall == None)
    {
      std::for_each(cell.corners.begin(), cell.corners.end(), visit);
      return;
    }
    parts_.wall.forEachUse(cell.ofWall, [&](const FaceUse& use) { forEachPoint(use, visit); });
  }

  // Adds a cell with its faces, corners counter-clockwise from outside.
  void addFaces(const CellOfMesh& cell, CellFaces& cells) const;

  void writeCellData(const CellData& data, Execution& execution) const;

  // Faces as in boundary().
  BoundaryMesh meshOf(const std::vector<BoundaryFace>& faces, Execution& execution) const;
  BoundaryMesh boundaryMesh(Execution& execution) const { return meshOf(boundary_, execution); }

  // The faces between two regions, as those of the cell of the region behind; BoundaryFace::boundary is the
  // wall (Walls.h).
  const std::vector<BoundaryFace>& interfaces() const { return interfaces_; }

  // The cell in front of each, or -1: it belongs to another part.
  const std::vector<Id>& inFrontOfInterfaces() const { return inFront_; }
  BoundaryMesh interfaceMesh(Execution& execution) const { return meshOf(interfaces_, execution); }

private:
  // Calls visit(point) for the corners of a face, counter-clockwise from outside its cell.
  template <class Visitor>
  void forEachPoint(const BoundaryFace& face, Visitor&& visit) const;

  static constexpr Id CornersOfAHexahedron = 8;

  // Where the polyhedra of a row of boxes start in the wall mesh, and in the output arrays after all hexahedra; only
  // the core has any.
  struct RowOffsets
  {
    std::size_t cell = 0;
    Id connectivity = 0;
    Id faceStream = 0;
  };
  struct CellSize
  {
    std::uint32_t points = 0;
    std::uint32_t faceStream = 0;
  };

  // The points of one cell, each once, in any order. Keeps its storage from cell to cell.
  struct CellPoints
  {
    EdgeTable seen; // from a point to itself
    std::vector<Id> points;

    // Starts with a cell that has this many corners at most.
    void reset(std::size_t corners)
    {
      seen.reset(corners);
      points.clear();
    }

    void add(Id id)
    {
      const auto point = static_cast<std::uint32_t>(id);
      if (std::uint32_t& number = seen.at(point, point); number == EdgeTable::Fresh)
      {
        number = 0;
        points.push_back(id);
      }
    }
  };

  template <class VertexVisitor, class NodeVisitor>
  void forEachPoint(
    VertexVisitor&& visitVertex, NodeVisitor&& visitNode, Execution& execution) const;
  void measureCells(Execution& execution);
  void placeRows();

  // How many boxes of the core before this one are hexahedra: the place of a hexahedron among the cells.
  std::size_t hexahedraBefore(std::size_t box) const;

  // The place of a cell of a polyhedral box among the cells.
  std::size_t placeOfPolyhedron(std::size_t cell) const;

  template <class NumberOf>
  std::array<Id, 8> corners(std::size_t box, NumberOf&& numberOf) const;
  std::size_t firstBoxOfRow(std::size_t row) const
  {
    return parts_.boxes.globals[parts_.boxes.rowStart[row]].firstBox;
  }
  template <class Visitor>
  void forEachHexahedron(std::size_t row, Visitor&& visit) const;
  template <class Visitor>
  void forEachPolyhedron(std::size_t row, Visitor&& visit) const;
  void writeRow(std::size_t row, const CellArrays& arrays, CellPoints& points) const;
  void writeFaces(std::size_t cell, Id* stream, CellPoints& points) const;
  void listInterfaces();
  RawVector<std::uint32_t> numberPointsOf(
    const std::vector<BoundaryFace>& faces, std::vector<Id>& points, Execution& execution) const;

  template <class Visitor>
  void forEachPoint(const FaceUse& use, Visitor&& visit) const
  {
    parts_.wall.faces.forEachNode(
      use, [&](std::uint32_t node) { visit(static_cast<Id>(points_.ofNode(node))); });
  }

  MeshParts parts_;
  CellNumbers numbers_;
  PointNumbers points_;
  std::unique_ptr<PointNumbers> pointsAround_; // for a part: includes the points of cells around it
  Id ownPoints_ = 0;
  std::size_t hexahedra_ = 0;
  std::vector<CellSize> cellSizes_; // of each cell of polyhedral boxes
  std::vector<RowOffsets> rows_;
  std::vector<BoundaryFace> boundary_;
  std::vector<BoundaryFace> interfaces_;
  std::vector<Id> inFront_;
  CellConditions failures_;
};

// The corners of a hexahedron, as bits (x + 2 y + 4 z). If its box is not divided, numberOf(line, i) gives the number
// of vertex i of the global mesh on one of the box's four lines along x (line: y + 2 z).
template <class NumberOf>
std::array<Id, 8> OutputMesh::corners(std::size_t box, NumberOf&& numberOf) const
{
  std::array<Id, 8> p;
  const std::uint32_t ordinal = parts_.sides.ordinal[box];
  if (ordinal != None)
  {
    const auto& nodes = parts_.nodes.ofDivided[ordinal & ~Sides::HexahedronBit];
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      p[corner] = points_.ofNode(nodes[corner]);
    }
    return p;
  }
  const std::uint32_t i = parts_.boxes.globalOf(parts_.boxes.packed[box]).index[0];
  for (std::uint32_t line = 0; line < 4; ++line)
  {
    const std::size_t low = 2 * std::size_t(line);
    p[low] = static_cast<Id>(numberOf(line, i));
    p[low + 1] = p[low] + 1;
  }
  return p;
}

// Calls visit(cell) for the hexahedra of a row of boxes.
template <class Visitor>
void OutputMesh::forEachHexahedron(std::size_t row, Visitor&& visit) const
{
  const std::size_t rowLength = parts_.boxes.planes[1].size();
  const std::size_t line = row + row / (rowLength - 1); // the row of points of its lower vertices
  std::array<PointNumbers::Walk, 4> lines{ PointNumbers::Walk(points_, line),
    PointNumbers::Walk(points_, line + 1), PointNumbers::Walk(points_, line + rowLength),
    PointNumbers::Walk(points_, line + rowLength + 1) };
  std::size_t place = hexahedraBefore(firstBoxOfRow(row));
  for (std::size_t b = firstBoxOfRow(row); b < firstBoxOfRow(row + 1); ++b)
  {
    if (parts_.sides.polyhedralOrdinal(static_cast<std::uint32_t>(b)) == None)
    {
      const std::array<Id, 8> p =
        corners(b, [&](std::uint32_t l, std::uint32_t i) { return lines[l].ofVertex(i); });
      visit(CellOfMesh{ place++, None, { p[0], p[1], p[3], p[2], p[4], p[5], p[7], p[6] } });
    }
  }
}

// ... for its polyhedra.
template <class Visitor>
void OutputMesh::forEachPolyhedron(std::size_t row, Visitor&& visit) const
{
  const std::size_t box = firstBoxOfRow(row);
  std::size_t place = hexahedra_ + numbers_.ofBox[box] - hexahedraBefore(box);
  for (std::size_t c = rows_[row].cell; c < rows_[row + 1].cell; ++c)
  {
    if (!parts_.wall.cells[c].removed)
    {
      visit(CellOfMesh{ place++, static_cast<std::uint32_t>(c), {} });
    }
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
// The mesh at the wall: the cells of polyhedral boxes with all their faces, from their assembly (section 6, part B) until
// they are written. Hexahedra stay implicit: of their faces, only those are here that a cell at the wall has too.
#pragma once

#include "Faces/InnerFaces.h"

namespace cartesian
{

// A cell of the wall mesh; or FirstHexahedron + box; or None.
using CellKey = std::uint32_t;

constexpr CellKey FirstHexahedron = 1u << 30;
constexpr CellKey EndOfKeys = 3u << 30;

constexpr CellKey keyOfHexahedron(std::uint32_t box)
{
  return FirstHexahedron + box;
}
constexpr bool isHexahedron(CellKey key)
{
  return key >= FirstHexahedron && key < EndOfKeys;
}
constexpr std::uint32_t boxOfHexahedron(CellKey key)
{
  return key - FirstHexahedron;
}

// A face of a cell. The corners are counter-clockwise from outside the cell below; the cell above has the face
// reversed.
struct FaceUse
{
  std::uint32_t face : 31;
  std::uint32_t turned : 1;

  FaceUse() = default;
  FaceUse(std::size_t f, bool isTurned)
    : face(static_cast<std::uint32_t>(f) & Most)
    , turned(isTurned ? 1 : 0)
  {
  }

  static constexpr std::uint32_t Most = 0x7fffffffu;
};

// As they are cut: patches, as Patches has them, then those of sides (InnerFaces.h), then patches between two regions
// (Interfaces.h). Once they were edited: those that no edit has changed, then the others; none without a cell.
struct WallFaces
{
  std::vector<std::uint32_t> start{ 0 };     // first corner of each face, and the end
  std::vector<std::uint32_t> corners;        // nodes
  std::vector<std::array<CellKey, 2>> cells; // below and above

  // The wall (Walls.h) of patches, of faces between two regions, and of those with no cell on one side.
  std::vector<std::int32_t> boundary;

  std::vector<std::uint32_t> sideStart; // as cut: first face of each side, and the end
  std::uint32_t firstShaped = 0;        // once edited: of those that edits have made or changed

  std::size_t size() const { return cells.size(); }

  // As cut.
  std::uint32_t firstOfSides() const { return sideStart.front(); } // the number of patches
  std::uint32_t firstInterface() const { return sideStart.back(); }
  bool isPatch(std::size_t face) const { return face < firstOfSides(); }
  bool isOfSide(std::size_t face) const { return !isPatch(face) && face < firstInterface(); }

  // The cell on the other side of a cell's face.
  CellKey beyond(const FaceUse& use) const { return cells[use.face][use.turned ? 0 : 1]; }

  // Calls visit(node) for the corners of a face, counter-clockwise from outside its cell.
  template <class Visitor>
  void forEachNode(const FaceUse& use, Visitor&& visit) const
  {
    const std::size_t begin = start[use.face];
    const std::size_t end = start[use.face + 1u];
    for (std::size_t i = begin; i < end; ++i)
    {
      visit(corners[use.turned ? begin + end - 1 - i : i]);
    }
  }

  void reserve(std::size_t count, std::size_t ofCorners)
  {
    start.reserve(count + 1);
    corners.reserve(ofCorners);
    cells.reserve(count);
    boundary.reserve(count);
  }

  // Closes the face whose corners were added last.
  void add(const std::array<CellKey, 2>& of, std::int32_t wall)
  {
    start.push_back(static_cast<std::uint32_t>(corners.size()));
    cells.push_back(of);
    boundary.push_back(wall);
  }
};

// A separated volume (B2) of a polyhedral box (Sides.h).
struct Cell
{
  std::uint32_t box;
  std::int32_t boundary; // of most of its patches by area, or NoBoundary
  std::int32_t region;
  double volumeFraction; // of its box
  std::size_t firstUse;  // in WallMesh::uses; up to the next cell's first
  bool sliver;           // its volume is mere rounding
  bool removed;          // a sliver, or smaller than R of its box (4.10)
};

struct WallMesh
{
  WallFaces faces;
  std::vector<Cell> cells;           // of polyhedral boxes, in order; then a sentinel
  std::vector<FaceUse> uses;         // of faces, by cells
  std::vector<std::size_t> boxStart; // first cell of the n-th polyhedral box, and the end
  std::vector<std::uint8_t> flawed;  // 1: the faces of the box do not close; it has no cells
  std::size_t folds = 0;             // walls without thickness inside a cell, which were dropped
  std::size_t voids = 0;             // closed pieces of surface inside a cell, which are its holes

  std::size_t size() const { return cells.size() - 1; }

  // Once it is opened for edits (Editing/WallOpening.h), until these are written: only cells stay.
  void forgetFaces()
  {
    faces = WallFaces();
    std::vector<FaceUse>().swap(uses);
  }

  bool isRemoved(CellKey key) const { return key < FirstHexahedron && cells[key].removed; }

  // Whether a face is between two regions. Hexahedra are in boxes that no wall passes through.
  bool isInterface(std::size_t face) const
  {
    const auto& [below, above] = faces.cells[face];
    return below < FirstHexahedron && above < FirstHexahedron &&
      cells[below].region != cells[above].region;
  }

  // Calls visit(use) for the faces of a cell.
  template <class Visitor>
  void forEachUse(std::size_t cell, Visitor&& visit) const
  {
    for (std::size_t u = cells[cell].firstUse; u < cells[cell + 1].firstUse; ++u)
    {
      visit(uses[u]);
    }
  }

  // Calls visit(node) for the corners of a cell's faces.
  template <class Visitor>
  void forEachNodeOf(std::size_t cell, Visitor&& visit) const
  {
    forEachUse(cell, [&](const FaceUse& use) { faces.forEachNode(use, visit); });
  }
};

// The cells of the boxes in these layers: begin and end.
std::array<CellKey, 2> cellsIn(
  const Boxes& boxes, const Sides& sides, const WallMesh& wall, SlabRange layers);

// What is on a side of a hexahedron (0: low x, 1: high x, low y, ...).
struct BesideHexahedron
{
  std::uint32_t box;          // beyond, or None
  bool isPolyhedral;          // that box: its cells have faces here
  std::vector<FaceUse> faces; // of the wall mesh, as the hexahedron has them
};

// Fills in the side of a hexahedron, as cut. Without faces, its only one there is implicit.
void lookBeside(const Boxes& boxes, const Sides& sides, const WallMesh& wall, std::uint32_t box,
  unsigned side, BesideHexahedron& beside);

}

// SPDX-License-Identifier: BSD-3-Clause
// Assembly of cells (section 6, part B; 4.10).
#pragma once

#include "Cells/SmallCellSpec.h"
#include "Faces/InnerFaces.h"

namespace cartesian
{

// A face of a cell: a patch, an inner face of a side, or a face that shaping made (CellShaping.h). The
// cell below a face of the latter two kinds, outside of which it is counter-clockwise, has it as it is;
// the cell above has it turned over. So it is with patches between two regions, until they are inner faces
// too (Interfaces.h).
struct FaceOfCell
{
  enum class Kind : std::uint32_t
  {
    Patch,
    Inner,
    TurnedInner,
    Shaped,
    TurnedShaped,
    TurnedPatch,
  };

  std::uint32_t index : 29;
  std::uint32_t kindBits : 3;

  FaceOfCell(std::size_t i, Kind kind)
    : index(static_cast<std::uint32_t>(i) & MostFaces)
    , kindBits(static_cast<std::uint32_t>(kind) & 7u)
  {
  }
  Kind kind() const { return static_cast<Kind>(kindBits); }
  bool isPatch() const { return kind() == Kind::Patch || kind() == Kind::TurnedPatch; }
  bool turned() const
  {
    return kind() == Kind::TurnedInner || kind() == Kind::TurnedShaped ||
      kind() == Kind::TurnedPatch;
  }

  static constexpr std::uint32_t MostFaces = (1u << 29) - 1;
};

// A separated volume (B2) of a polyhedral box (Sides.h).
struct Cell
{
  std::uint32_t box;
  std::int32_t boundary; // of most of its patches by area, or NoBoundary
  std::int32_t region;
  double volumeFraction; // of its box
  std::size_t firstFace; // in Cells::faces; up to the next cell's first
  bool sliver;           // its volume is mere rounding
  bool removed;          // a sliver, or smaller than R of its box (4.10)

  // The number of layers of global boxes that it extends below and above its box's, by merging.
  std::array<std::uint8_t, 2> reach{ 0, 0 };
};

// Faces that differ from the patches and the faces of sides: pieces of those, faces with new nodes on their
// edges, cutting polygons, sides between hexahedra.
struct ShapedFaces
{
  static constexpr std::uint32_t SomeHexahedron = None - 1;

  std::vector<std::size_t> start{ 0 }; // first node of each face, and the end
  std::vector<std::uint32_t> nodes;
  std::vector<std::array<std::uint32_t, 2>> cells; // below and above, or SomeHexahedron, or None
  std::vector<std::int32_t> boundary; // where one of the cells is None, or between two regions

  // Of the hexahedra: the box, its side (as in BoundaryFace) and the face there.
  struct HexahedronSide
  {
    std::uint32_t box;
    std::uint32_t side;
    std::uint32_t face;
  };
  std::vector<HexahedronSide> ofHexahedra; // in order of boxes and sides

  std::size_t size() const { return cells.size(); }
};

struct Cells
{
  std::vector<Cell> all; // of polyhedral boxes, in order; then a sentinel
  std::vector<FaceOfCell> faces;
  std::vector<std::size_t> boxStart; // first cell of the n-th polyhedral box, and the end
  std::vector<std::uint8_t> flawed;  // 1: the faces of the box do not close; it has no cells
  std::size_t folds = 0;             // walls without thickness inside a cell, which were dropped
  std::size_t voids = 0;             // closed pieces of surface inside a cell, which are its holes

  // The cells below and above each inner face, or None where there is no box, or a hexahedron.
  std::vector<std::array<std::uint32_t, 2>> ofInnerFace;

  ShapedFaces shaped;

  std::size_t size() const { return all.size() - 1; }
};

// Calls visit(node) for the corners of a face, counter-clockwise from outside its cell.
template <class Visitor>
void forEachNode(const FaceOfCell& face, const Patches& patches, const InnerFaces& inner,
  const ShapedFaces& shaped, Visitor&& visit)
{
  const auto run = [&](const auto& start, const auto& nodes) {
    const std::size_t begin = start[face.index];
    const std::size_t end = start[face.index + 1];
    for (std::size_t i = begin; i < end; ++i)
    {
      visit(nodes[face.turned() ? begin + end - 1 - i : i]);
    }
  };
  switch (face.kind())
  {
    case FaceOfCell::Kind::Patch:
    case FaceOfCell::Kind::TurnedPatch:
      run(patches.start, patches.corners);
      break;
    case FaceOfCell::Kind::Inner:
    case FaceOfCell::Kind::TurnedInner:
      run(inner.start, inner.nodes);
      break;
    case FaceOfCell::Kind::Shaped:
    case FaceOfCell::Kind::TurnedShaped:
      run(shaped.start, shaped.nodes);
      break;
  }
}

// Fills Cells::ofInnerFace.
void findCellsOfInnerFaces(const InnerFaces& inner, Cells& cells, Execution& execution);

// Gives Cells::flawed.
std::vector<std::uint8_t> findFlawed(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, Execution& execution);

// Finds the separated volumes of each polyhedral box, and marks small ones as removed. Cells thinner than a
// hundredth of a lattice step (slivers due to rounding) are removed whatever R is.
Cells assembleCells(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, const SmallCellSpec& spec, Execution& execution);

}

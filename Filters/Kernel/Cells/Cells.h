// SPDX-License-Identifier: BSD-3-Clause
// Assembling of cells (section 6, part B; 4.10).
#pragma once

#include "Cells/SmallCellSpec.h"
#include "Faces/InnerFaces.h"

namespace cartesian
{

// A face of a cell: a patch, or an inner face of a side, or one that shaping made (CellShaping.h).
// The latter two as they are (the cell is the one below, that they are counter-clockwise from) or
// turned over.
struct FaceRef
{
  enum class Kind : std::uint32_t
  {
    Patch,
    Inner,
    TurnedInner,
    Shaped,
    TurnedShaped,
  };

  std::uint32_t index : 29;
  std::uint32_t kindBits : 3;

  FaceRef(std::size_t i, Kind kind)
    : index(static_cast<std::uint32_t>(i) & MostFaces)
    , kindBits(static_cast<std::uint32_t>(kind) & 7u)
  {
  }
  Kind kind() const { return static_cast<Kind>(kindBits); }
  bool turned() const { return kind() == Kind::TurnedInner || kind() == Kind::TurnedShaped; }

  static constexpr std::uint32_t MostFaces = (1u << 29) - 1;
};

// A separated volume (B2) of a polyhedral box (Sides.h).
struct Cell
{
  std::uint32_t box;
  std::int32_t boundary; // that most of its patches (by area) belong to, or NoBoundary
  double volumeFraction; // of its box
  std::size_t firstFace; // in Cells::faces; up to the next cell's first
  bool sliver;           // of no volume but that of rounding
  bool removed;          // a sliver, or smaller than R of its box (4.10)

  // How many layers of global boxes it reaches beyond its box's, below and above, by merging.
  std::array<std::uint8_t, 2> reach{ 0, 0 };
};

// Faces that are not as the patches and sides have them: pieces of those, faces with new nodes on
// their edges, cutting polygons, sides between hexahedra.
struct ShapedFaces
{
  static constexpr std::uint32_t SomeHexahedron = None - 1;

  std::vector<std::size_t> start{ 0 }; // first node of each face, and the end
  std::vector<std::uint32_t> nodes;
  std::vector<std::array<std::uint32_t, 2>> cells; // below and above, or SomeHexahedron, or None
  std::vector<std::int32_t> boundary;              // where one of the cells is None

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
  std::vector<Cell> cells; // of polyhedral boxes, in order; one more at the end
  std::vector<FaceRef> faces;
  std::vector<std::size_t> boxStart; // first cell of the n-th polyhedral box, and the end
  std::vector<std::uint8_t> flawed;  // 1: the box's faces do not close (a hole), it has no cells
  std::size_t folds = 0;             // walls without thickness inside one cell, left out
  std::size_t voids = 0;             // closed pieces of surface inside one cell, now holes of it

  // The cells below and above each inner face, or None: there is no box, or it is a hexahedron.
  std::vector<std::array<std::uint32_t, 2>> ofInnerFace;

  ShapedFaces shaped;

  std::size_t size() const { return cells.size() - 1; }
};

// Calls visit(node) for the corners of a face, counter-clockwise from outside its cell.
template <class Visitor>
void forEachNode(const FaceRef& face, const Patches& patches, const InnerFaces& inner,
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
    case FaceRef::Kind::Patch:
      run(patches.start, patches.corners);
      break;
    case FaceRef::Kind::Inner:
    case FaceRef::Kind::TurnedInner:
      run(inner.start, inner.nodes);
      break;
    case FaceRef::Kind::Shaped:
    case FaceRef::Kind::TurnedShaped:
      run(shaped.start, shaped.nodes);
      break;
  }
}

// Fills Cells::ofInnerFace.
void findCellsOfInnerFaces(const InnerFaces& inner, Cells& cells, Execution& execution);

// Of each polyhedral box, Cells::flawed.
std::vector<std::uint8_t> findFlawed(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, Execution& execution);

// Distinguishes the separated volumes of each polyhedral box and marks small ones as removed.
// Cells less thick than a hundredth of a lattice step (slivers that rounding closed) are removed
// whatever R is.
Cells assembleCells(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, const SmallCellSpec& spec, Execution& execution);

}

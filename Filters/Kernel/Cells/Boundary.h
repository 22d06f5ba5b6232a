// SPDX-License-Identifier: BSD-3-Clause
// The boundary of the mesh, once it was edited: faces with a cell on one side.
#pragma once

#include "Cells/WallMesh.h"

namespace cartesian
{

using Id = long long;

// Everything that the mesh is made of.
struct MeshParts
{
  const Boxes& boxes;
  const Patches& patches;
  const Sides& sides;
  const Nodes& nodes;
  const WallMesh& wall;
};

// Numbers the cells of the core that were not removed, in order of boxes: 0, 1, 2, ...
struct CellNumbers
{
  static constexpr std::uint32_t Elsewhere = None - 1; // the cell is in the halo

  RawVector<std::uint32_t> ofBox;    // of the (first) cell of each box; the total at the end
  std::vector<std::uint32_t> ofCell; // of each cell of polyhedral boxes, or None where removed
  std::size_t coreBegin = 0;         // cells of polyhedral boxes in the core
  std::size_t coreEnd = 0;

  static bool isHere(std::uint32_t number) { return number < Elsewhere; }
};

CellNumbers numberCells(const MeshParts& parts, Execution& execution);

struct BoundaryFace
{
  enum class Kind : std::uint8_t
  {
    Cut,       // as it was cut
    TurnedCut, // ... reversed
    Shaped,    // a face that edits made or changed
    TurnedShaped,
    BoxSide, // of a hexahedron: 6 * box + (low x, high x, low y, high y, low z, high z)
  };
  Id cell;           // its owner
  std::size_t index; // in WallFaces
  std::int32_t boundary;
  Kind kind;

  bool isShaped() const { return kind == Kind::Shaped || kind == Kind::TurnedShaped; }

  // Of one of the wall's faces, as its owner has it.
  FaceUse use() const { return { index, kind == Kind::TurnedCut || kind == Kind::TurnedShaped }; }

  bool operator<(const BoundaryFace& other) const
  {
    return cell != other.cell ? cell < other.cell
                              : (kind != other.kind ? kind < other.kind : index < other.index);
  }
};

// The kind of a face of the wall.
BoundaryFace::Kind kindOf(const WallFaces& faces, const FaceUse& use);

// Lists the boundary faces, in order of their cells.
std::vector<BoundaryFace> collectBoundary(
  const MeshParts& parts, const CellNumbers& numbers, Execution& execution);

}

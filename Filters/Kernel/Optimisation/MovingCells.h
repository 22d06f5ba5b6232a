// SPDX-License-Identifier: BSD-3-Clause
// Which nodes of a slab (Slabs.h) may move, and which cells change with them.
#pragma once

#include "Base/EdgeTable.h"
#include "Cells/WallMesh.h"
#include "Parts/Slabs.h"

namespace cartesian
{

// Nodes of wall cells move if all their cells may change, except at the ends of the grid.
class MovingCells
{
public:
  MovingCells(const Boxes& boxes, const Sides& sides, const Nodes& nodes, const WallMesh& wall,
    const Slab& slab);

  bool isMovable(std::uint32_t node)
  {
    const std::uint32_t state = stateOf_.at(node, node);
    return state == Movable || state == Listed;
  }

  // With a node that may move: cells of polyhedral boxes, and the boxes of hexahedra; both in order.
  const std::vector<CellKey>& cells() const { return cells_; }
  const std::vector<std::uint32_t>& hexahedra() const { return hexahedra_; }

  // At least as many as the cells of polyhedral boxes that the slab sees have.
  std::size_t mostNodes() const { return mostNodes_; }
  std::size_t mostFaces() const
  {
    return wall_.cells[range_[1]].firstUse - wall_.cells[range_[0]].firstUse;
  }

private:
  // In stateOf_:
  static constexpr std::uint32_t Fixed = 0;
  static constexpr std::uint32_t Movable = 1;
  static constexpr std::uint32_t Listed = 2; // movable; the hexahedra around it are known

  std::array<std::size_t, 2> dividedHere() const;
  std::size_t countNodes() const;
  bool isFree(CellKey c) const;
  bool isAtWall(CellKey c) const;
  void findMovable();
  bool mayEverMove(std::uint32_t node) const;
  void listChanging();
  void listDivided();
  void listUndividedAt(std::uint32_t node);

  const Boxes& boxes_;
  const Sides& sides_;
  const Nodes& nodes_;
  const WallMesh& wall_;
  const Slab& slab_;
  std::array<CellKey, 2> range_; // of polyhedral boxes in the slab's layers: begin and end
  std::size_t mostNodes_;
  std::vector<std::uint8_t>
    isVertex_;        // of nodes that shaping added: 1 at vertices of the global mesh
  EdgeTable stateOf_; // of nodes
  std::vector<CellKey> cells_;
  std::vector<std::uint32_t> hexahedra_;
};

}

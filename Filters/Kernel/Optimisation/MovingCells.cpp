// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/MovingCells.h"

#include "Faces/UsedVertices.h"

#include <algorithm>

namespace cartesian
{

MovingCells::MovingCells(const Boxes& boxes, const Sides& sides, const Nodes& nodes,
  const WallMesh& wall, const Slab& slab)
  : boxes_(boxes)
  , sides_(sides)
  , nodes_(nodes)
  , wall_(wall)
  , slab_(slab)
  , range_(cellsIn(boxes, sides, wall, slab.layers))
  , mostNodes_(countNodes())
  , isVertex_(nodes.at.size() - nodes.patchPoints - nodes.grid.size())
{
  for (const VertexNode& vertex : nodes.moreVertices)
  {
    isVertex_[vertex.node - nodes.patchPoints - nodes.grid.size()] = 1;
  }
  const auto [first, last] = dividedHere();
  stateOf_.reset(mostNodes_ + 8 * (last - first));
  findMovable();
  listChanging();
}

// Hexahedra smaller than their global box, in the layers where nodes move: begin and end in Sides::divided.
std::array<std::size_t, 2> MovingCells::dividedHere() const
{
  const auto& divided = sides_.divided;
  const auto firstOf = [&](std::uint32_t layer) {
    const auto at = std::lower_bound(divided.begin(), divided.end(), boxes_.firstBoxOf(layer));
    return static_cast<std::size_t>(at - divided.begin());
  };
  return { firstOf(slab_.moving.begin), firstOf(slab_.moving.end) };
}

// Each node of a closed cell is at two of its faces or more: at no more than two where it lies within an edge.
std::size_t MovingCells::countNodes() const
{
  std::size_t corners = 0;
  for (CellKey c = range_[0]; c < range_[1]; ++c)
  {
    wall_.forEachNodeOf(c, [&](std::uint32_t) { ++corners; });
  }
  return corners / 2;
}

bool MovingCells::isFree(CellKey c) const
{
  const Cell& cell = wall_.cells[c];
  const std::uint32_t layer = boxes_.globalOf(boxes_.packed[cell.box]).index[2];
  return layer - cell.reach[0] >= slab_.moving.begin && layer + cell.reach[1] < slab_.moving.end;
}

bool MovingCells::isAtWall(CellKey c) const
{
  bool wall = false;
  wall_.forEachUse(c, [&](const FaceUse& use) {
    const CellKey other = wall_.faces.beyond(use);
    wall = wall || other == None || wall_.isRemoved(other) || wall_.isInterface(use.face);
  });
  return wall;
}

void MovingCells::findMovable()
{
  for (CellKey c = range_[0]; c < range_[1]; ++c)
  {
    if (!wall_.cells[c].removed && isFree(c) && isAtWall(c))
    {
      wall_.forEachNodeOf(c, [&](std::uint32_t node) {
        std::uint32_t& state = stateOf_.at(node, node);
        state = state == EdgeTable::Fresh ? (mayEverMove(node) ? Movable : Fixed) : state;
      });
    }
  }
  for (CellKey c = range_[0]; c < range_[1]; ++c)
  {
    if (!wall_.cells[c].removed && !isFree(c))
    {
      wall_.forEachNodeOf(c, [&](std::uint32_t node) { stateOf_.at(node, node) = Fixed; });
    }
  }
}

// Not at the ends of the grid, nor where plain hexahedra that are not free, or know no node, have a corner.
bool MovingCells::mayEverMove(std::uint32_t node) const
{
  const Point& at = nodes_.at[node];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto& planes = boxes_.planes[axis];
    if (at[axis] <= planes.front() || at[axis] >= planes.back())
    {
      return false;
    }
  }
  if (node < nodes_.patchPoints)
  {
    return true;
  }
  const std::size_t ofGrid = node - nodes_.patchPoints;
  if (ofGrid >= nodes_.grid.size())
  {
    return isVertex_[ofGrid - nodes_.grid.size()] == 0;
  }
  const Level z = nodes_.grid[ofGrid][2];
  const auto& planes = boxes_.planes[2];
  const bool atEnd = slab_.moving.end == boxes_.allLayers().end;
  return (slab_.moving.begin == 0 || z > planes[slab_.moving.begin]) &&
    (atEnd || z < planes[slab_.moving.end]);
}

void MovingCells::listChanging()
{
  for (CellKey c = range_[0]; c < range_[1]; ++c)
  {
    bool changes = false;
    if (!wall_.cells[c].removed && isFree(c))
    {
      wall_.forEachNodeOf(c, [&](std::uint32_t node) { changes = changes || isMovable(node); });
    }
    if (changes)
    {
      cells_.push_back(c);
      wall_.forEachNodeOf(c, [&](std::uint32_t node) {
        if (std::uint32_t& state = stateOf_.at(node, node); state == Movable)
        {
          state = Listed;
          listUndividedAt(node);
        }
      });
    }
  }
  listDivided();
  std::sort(hexahedra_.begin(), hexahedra_.end());
  hexahedra_.erase(std::unique(hexahedra_.begin(), hexahedra_.end()), hexahedra_.end());
}

void MovingCells::listDivided()
{
  const auto [first, last] = dividedHere();
  for (std::size_t d = first; d < last; ++d)
  {
    const auto& nodes = nodes_.ofDivided[d];
    const std::uint32_t box = sides_.divided[d];
    if (sides_.polyhedralOrdinal(box) == None &&
      std::any_of(nodes.begin(), nodes.end(), [&](std::uint32_t node) { return isMovable(node); }))
    {
      hexahedra_.push_back(box);
    }
  }
}

// Appends the undivided hexahedra with a corner at a node.
void MovingCells::listUndividedAt(std::uint32_t node)
{
  const std::size_t c = std::size_t(node) - nodes_.patchPoints;
  if (node < nodes_.patchPoints || c >= nodes_.grid.size())
  {
    return;
  }
  const auto& rows = nodes_.rowStart;
  const auto row =
    static_cast<std::size_t>(std::upper_bound(rows.begin(), rows.end(), c) - rows.begin()) - 1;
  const std::size_t rowLength = boxes_.planes[1].size();
  const std::size_t j = row % rowLength;
  const std::size_t k = row / rowLength;
  std::uint32_t i = 0;
  if (!UsedVertices::isVertex(boxes_.planes, nodes_.grid[c], j, k, i))
  {
    return;
  }
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const std::uint32_t global = boxes_.globalAt(std::int64_t(i) - (corner & 1),
      std::int64_t(j) - (corner >> 1 & 1), std::int64_t(k) - (corner >> 2));
    if (global != None && boxes_.globals[global].depth == 0 &&
      sides_.ordinal[boxes_.globals[global].firstBox] == None)
    {
      hexahedra_.push_back(boxes_.globals[global].firstBox);
    }
  }
}

}

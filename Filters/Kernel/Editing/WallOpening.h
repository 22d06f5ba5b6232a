// SPDX-License-Identifier: BSD-3-Clause
// The wall mesh opened for edits: the cells of intersected boxes and others with a wall, and one ring of cells around
// them. What lies beyond is there as ghosts, whose nodes are held: all other polyhedra, and hexahedra beside any.
//
// Nothing depends on how the input is ordered: cells are in the order of their boxes, several in a box in that of their
// nodes' places; nodes in the order of their places; faces in that of the cell below, then of their corners, the first of
// which is the lowest.
#pragma once

#include "Cells/Boundary.h"
#include "Editing/MeshEditor.h"
#include "Surface/WallLayerSpec.h"

#include <limits>

namespace cartesian
{

// EditFace::wall of what lies on an end of the grid (0: low x, 1: high x, low y, ...): neither an index of Walls nor
// NoBoundary.
constexpr std::int32_t FirstOfEnds = std::numeric_limits<std::int32_t>::min();

constexpr std::int32_t wallOfEnd(std::size_t side)
{
  return FirstOfEnds + static_cast<std::int32_t>(side);
}
constexpr bool isWallOfEnd(std::int32_t wall)
{
  return wall < FirstOfEnds + 6;
}

struct EditableWall
{
  MeshEditor mesh;
  Point origin{};
  std::uint32_t nodes = 0;            // before edits made more
  std::uint32_t cells = 0;            // before the ghosts
  std::vector<VertexNode> onVertices; // nodes on vertices of the global mesh that are not in Nodes

  Vector inside(const Point& place) const { return scaled(minus(place, origin), mesh.level()); }
  Point placeOf(std::uint32_t node) const;
};

struct OpeningSpec
{
  double featureAngle = 30;              // degrees: edges of the wall that turn by more are sharp
  const WallLayerSpec* layers = nullptr; // that some walls will have, or null
};

EditableWall openWall(const MeshParts& parts, const OpeningSpec& spec, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// The cells at the wall as an MeshEditor, and back: those of intersected boxes and others with a wall, and one ring of
// cells around them. What lies beyond is there as ghosts, whose nodes are held.
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

// What the mesh was when it was opened: cells before the ghosts, and the corners of faces.
struct AsOpened
{
  std::uint32_t nodes = 0;
  std::uint32_t cells = 0;
  RawVector<std::uint16_t> facesOf; // how many each cell had
  RawVector<std::uint32_t> start;   // first corner of each face, and the end
  RawVector<std::uint32_t> corners;
  RawVector<std::array<std::uint32_t, 2>> cellsOf; // below and above each face, or None
  RawVector<std::uint8_t> turned;     // 1: the face has the cell below that WallFaces has above
  std::vector<VertexNode> onVertices; // nodes on vertices of the global mesh that are not in Nodes
};

struct EditableWall
{
  MeshEditor mesh;
  Point origin{};
  AsOpened opened;

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

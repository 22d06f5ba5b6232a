// SPDX-License-Identifier: BSD-3-Clause
// Neighbouring faces of a cell that can be one: between the same two cells, or of one boundary, with
// normals close to each other; none with a fixed cell beyond.
#pragma once

#include "Shaping/CellView.h"

namespace cartesian
{

struct JoinedFaces
{
  struct Group
  {
    std::vector<std::uint32_t> members; // faces of the view
    std::vector<std::uint32_t> ring;    // nodes of the view, counter-clockwise from outside
  };
  std::vector<Group> groups; // each face is in one; none: no faces are joined
};

// Cells of more faces keep them all: the time to join grows with the square of their number.
constexpr std::size_t MostFacesJoined = 1000;

// Cosines of the angle between the normals of what is joined.
struct JoinSpec
{
  double boundary = 1; // 1: on one plane only
  double inner = 1;
};

// `shape`: the view's.
JoinedFaces joinFaces(const CellView& view, const CellShape& shape, const JoinSpec& spec);

// All ways to make a boundary face and one neighbour of the same boundary one, whatever their angle.
std::vector<JoinedFaces> joinFace(const CellView& view, const CellShape& shape, std::uint32_t face);

// The view's shape with the groups, if any, for faces, and what is beyond them.
Polyhedron shapeOf(
  const CellView& view, const JoinedFaces& joined, std::vector<NeighbourCell>& beyond);

}

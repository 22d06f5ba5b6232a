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
    bool recut = false;                 // with another group: together they cover what they did

    bool isNew() const { return recut || members.size() > 1; }
  };
  std::vector<Group> groups; // each face is in one; none: no faces are joined
};

// Cells of more faces keep them all: the time to join grows with the square of their number.
constexpr std::size_t MostFacesJoined = 200;

// Cosines of the angle between the normals of what is joined.
struct JoinSpec
{
  double boundary = 1; // 1: on one plane only
  double inner = 1;
};

// `shape`: the view's.
JoinedFaces joinFaces(const CellView& view, const CellShape& shape, const JoinSpec& spec);

// All ways to make one of the groups (where there is none: a face) and one neighbour one, where
// their normals make no smaller cosine; where they cannot be one, they are cut apart along another diagonal.
std::vector<JoinedFaces> joinOneMore(const CellView& view, const CellShape& shape,
  const JoinedFaces& joined, std::uint32_t group, double leastCosine);

// The view's shape with the groups, if any, for faces, and what is beyond them.
Polyhedron shapeOf(
  const CellView& view, const JoinedFaces& joined, std::vector<NeighbourCell>& beyond);

}

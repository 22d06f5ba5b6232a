// SPDX-License-Identifier: BSD-3-Clause
// Edges of the wall: which of them are sharp, and how far the wall is from what it was.
#pragma once

#include "Editing/FixedList.h"
#include "Editing/MeshEditor.h"

namespace cartesian
{

// An edge between two nodes, as the faces of walls have it.
struct WallEdge
{
  bool isWall = false;
  bool isSharp = false; // the wall turns there, ends, or has a border between boundaries
};

WallEdge wallEdgeOf(const MeshView& mesh, std::uint32_t u, std::uint32_t v);

// The other ends of the sharp edges at a node.
using SharpEnds = FixedList<std::uint32_t, 16>;
SharpEnds sharpEndsAt(const MeshView& mesh, std::uint32_t u);

// The length of what two faces share, edges of the one that the other has in reverse.
double sharedLength(const MeshView& mesh, std::uint32_t f, std::uint32_t g);

// Between the normals of two faces that have a cell in common, both out of it.
double cosineBetween(const MeshView& mesh, std::uint32_t f, std::uint32_t g);

// How sharp what two wall faces share is (SharpRule.h): 0 to 1.
double sharpnessBetween(const MeshView& mesh, std::uint32_t f, std::uint32_t g);

// Whether they have two corners in common.
bool areAdjacent(const MeshView& mesh, std::uint32_t f, std::uint32_t g);

double distanceToSegment(const Vector& p, const Vector& a, const Vector& b);
double distanceToFace(const MeshView& mesh, const Vector& p, std::uint32_t f);

// The largest distance between the walls that changed since the mark, as they were and as they are: from nodes and
// centres of the one to faces of the other, both ways. Nothing left of them: their extent; infinite: they are too many to tell.
double distanceOfWalls(const MeshEditor& mesh, const MeshEditor::Mark& mark);

}

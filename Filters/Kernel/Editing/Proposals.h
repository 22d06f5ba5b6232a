// SPDX-License-Identifier: BSD-3-Clause
// Edits that might help a face or a cell: the most likely first.
#pragma once

#include "Editing/EditDecision.h"
#include "Editing/FixedList.h"

#include <vector>

namespace cartesian
{

enum class EditKind : std::uint8_t
{
  Collapse,  // node a becomes b, at `at`
  Join,      // face b becomes part of a
  Merge,     // cell b becomes part of a
  Remove,    // cell a goes
  Move,      // node a to `at`
  SplitFace, // face a between corners b and c
  Flatten,   // wall a and the small walls around it, of the same cell, become one
  Cut        // cell a by the plane through `at`, across `normal`
};

struct Proposal
{
  EditKind kind;
  std::uint32_t a;
  std::uint32_t b = 0;
  std::uint32_t c = 0;
  Vector at{};
  Vector normal{};
};

// How far a search goes.
struct SearchSpec
{
  std::size_t edges = 3;       // the shortest of a face
  std::size_t neighbours = 2;  // of a cell, by the area between them
  std::size_t cuts = 2;        // re-entrant edges of a cell
  std::size_t nodes = 3;       // that move, by their gradients
  bool cutsAlongFaces = false; // in the planes of the walls beside an edge too
  bool cutsFailing = false;    // in the plane of a failing face, through the middle of its cells
  double enough = 0.4;         // the first proposal that gains so much of an item's cost is taken
  double longestEdge = 0.5;    // in boxes: that may collapse
  double removedShare = 0;     // of its box: a cell below may be removed
};

using Proposals = std::vector<Proposal>;

void proposeForFace(
  const MeshView& mesh, const SearchSpec& search, std::uint32_t f, Proposals& proposals);
void proposeForCell(
  const MeshView& mesh, const SearchSpec& search, std::uint32_t c, Proposals& proposals);

// The free cells beside a cell, those with the largest area between them first.
using Neighbours = FixedList<std::uint32_t, 64>;
Neighbours largestNeighbours(const MeshView& mesh, std::uint32_t c);

// Whether a cell may be removed as far as its place goes: at a wall, at no other region; the body is not as thin there, and
// its boundary's own ratio allows it.
bool couldRemove(const MeshView& mesh, std::uint32_t c);

// Whether faces may be joined as far as their place goes: adjacent, between the same cells, walls not across a sharp turn.
bool couldJoin(const MeshView& mesh, std::uint32_t f, std::uint32_t g, std::uint32_t c);

}

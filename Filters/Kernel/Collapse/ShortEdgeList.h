// SPDX-License-Identifier: BSD-3-Clause
// Edges that are short against their boxes: what may collapse (ShortEdges.h).
#pragma once

#include "Faces/InnerFaces.h"
#include "Faces/Nodes.h"

#include <functional>

namespace cartesian
{

struct ShortEdge
{
  std::uint32_t a; // nodes
  std::uint32_t b;
  float unit;          // shortest edge of the smallest box that has it
  bool banned = false; // a face turned over
};

struct PolyhedralFaces
{
  const Boxes& boxes;
  const Sides& sides;
  const Patches& patches;
  const Nodes& nodes;
  const InnerFaces& inner;
};

// Those shorter than twice `ratio` of the unit, as moves may shorten an edge, by nodes; each once. Not
// between two nodes of the grid, nor those of boxes that stay, by their place among the polyhedral ones.
std::vector<ShortEdge> listShortEdges(const PolyhedralFaces& faces, double ratio,
  const std::function<bool(std::size_t)>& stays, Execution& execution);

}

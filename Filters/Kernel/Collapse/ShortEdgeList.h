// SPDX-License-Identifier: BSD-3-Clause
// The edges that are short compared with their boxes, and so may collapse (EdgeCollapse.h).
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
  float unit;          // shortest edge of the smallest box around it
  bool banned = false; // it must not collapse

  bool operator<(const ShortEdge& other) const
  {
    return a != other.a ? a < other.a : (b != other.b ? b < other.b : unit < other.unit);
  }
};

struct PolyhedralFaces
{
  const Boxes& boxes;
  const Sides& sides;
  const Patches& patches;
  const Nodes& nodes;
  const InnerFaces& inner;
};

// Lists the edges shorter than `ratio` times their unit, each once and in order of nodes. Omits edges between two grid
// nodes, and those of boxes for which stays(n) holds, n being the index among the polyhedral boxes.
std::vector<ShortEdge> listShortEdges(const PolyhedralFaces& faces, double ratio,
  const std::function<bool(std::size_t)>& stays, Execution& execution);

}

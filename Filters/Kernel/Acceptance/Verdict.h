// SPDX-License-Identifier: BSD-3-Clause
// The quality of one or several cells, as they are or after an edit: Acceptance.h compares two.
#pragma once

#include "Acceptance/CellFaults.h"

#include <limits>

namespace cartesian
{

// The cost of what must not be.
constexpr double Never = 1e30;

struct Verdict
{
  double cost = 0;          // the objective: the sum of all costs (CellCost.h)
  double worst = 0;         // the largest of these
  std::size_t refused = 0;  // faces that fail, or may fail (CellFaults.h)
  std::size_t invalid = 0;  // of these, the inverted ones
  std::uint32_t toMend = 0; // of a cell's failing faces, or else of all, the one that costs most
  std::size_t faces = std::numeric_limits<std::size_t>::max(); // of the cell with the fewest
  double volume = 0;
  double costBeyond = 0; // by how much the costs of cells of other regions rise

  // All but toMend.
  Verdict& operator+=(const Verdict& other);
};

// Of the cell's faces; beyond[f] lies across face f. Those for which counts[face] is 0 are left out; if it is empty, all
// count. Ends where the cost is larger than `most`.
Verdict evaluate(const Polyhedron& cell, const CellShape& shape,
  const std::vector<NeighbourCell>& beyond, const std::vector<std::uint8_t>& counts = {},
  double most = Never);

// ... and of itself: its volume, `share` of its box's, and its determinant cost too. Too few faces count as one more
// failure.
Verdict evaluateCell(const Polyhedron& cell, const CellShape& shape,
  const std::vector<NeighbourCell>& beyond, double share,
  const std::vector<std::uint8_t>& counts = {});

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellCession.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// The interface moves by no more than this part of the box's edge.
constexpr double LargestShift = 0.02;

// Whether the walls of a cell between two regions may go to its other side.
bool isThin(const CellComplex& cells, CellKey key)
{
  MeasuredCell cell;
  cells.lookAround(key, cell);
  double walls = 0;
  for (std::size_t f = 0; f < cell.across.size(); ++f)
  {
    walls += cell.shape.isBoundary[f] ? norm(cell.measures.faces[f].area) : 0;
  }
  return cell.measures.volume <= LargestShift * walls * std::cbrt(cells.volumeOfBox(key));
}

std::size_t refusedFaces(const CellComplex& cells, CellKey key)
{
  MeasuredCell cell;
  cells.lookAround(key, cell);
  return costsOf(cell.shape, cell.measures, cell.beyond).refused +
    (cell.across.size() < LeastFaces ? 1 : 0);
}

}

bool cede(CellComplex& cells, CellKey key, CellMerger& merger)
{
  const std::optional<std::int32_t> wall = cells.onlyWallOf(key);
  if (!wall || !isThin(cells, key))
  {
    return false;
  }
  std::vector<std::pair<CellKey, std::size_t>> left; // of its region, and refused faces of each
  for (const auto& [other, area] : cells.neighbours(key))
  {
    cells.open(other);
    left.emplace_back(other, refusedFaces(cells, other));
  }
  cells.changeRegion(key, *wall);
  if (std::all_of(left.begin(), left.end(),
        [&](const auto& cell) { return refusedFaces(cells, cell.first) <= cell.second; }))
  {
    merger.improve(key);
    if (!cells.isAlive(key) || (cells.share(key) >= FlatCell && refusedFaces(cells, key) == 0))
    {
      return true;
    }
  }
  cells.changeRegion(key, *wall);
  return false;
}

bool cedeCells(CellComplex& cells, const std::vector<CellKey>& keys, double largest,
  CellMerger& merger, Execution& execution)
{
  bool any = false;
  for (const CellKey key : keys)
  {
    execution.poll();
    any = (cells.isAlive(key) && cells.share(key) < largest && cede(cells, key, merger)) || any;
  }
  return any;
}

}

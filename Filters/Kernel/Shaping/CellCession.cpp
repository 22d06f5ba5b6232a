// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellCession.h"

#include <algorithm>

namespace cartesian
{

namespace
{

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
  if (!wall)
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

void cedeCells(CellComplex& cells, const std::vector<CellKey>& keys, double largest,
  CellMerger& merger, Execution& execution)
{
  for (const CellKey key : keys)
  {
    execution.poll();
    if (cells.isAlive(key) && cells.share(key) < largest)
    {
      cede(cells, key, merger);
    }
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/FewFaces.h"

#include "Shaping/CellUnion.h"

#include <algorithm>

namespace cartesian
{

namespace
{

bool hasFewFaces(const CellComplex& cells, CellKey key, MeasuredCell& cell)
{
  cells.lookAround(key, cell);
  return cell.across.size() < LeastFaces;
}

bool mergeWithAny(CellComplex& cells, CellKey key)
{
  auto neighbours = cells.neighbours(key);
  std::stable_sort(neighbours.begin(), neighbours.end(),
    [](const auto& a, const auto& b) { return a.second > b.second; });
  const UnionTrial trial(cells);
  for (const auto& [other, area] : neighbours)
  {
    if (!cells.mayMerge({ key, other }))
    {
      continue;
    }
    cells.open(other);
    UnionView view;
    view.keys = { other, key };
    trial.look(view);
    CellUnion both;
    both.of = &view;
    if (trial.isSound(both))
    {
      cells.merge(key, other);
      return true;
    }
  }
  return false;
}

bool mergeBeyondWall(CellComplex& cells, CellKey key)
{
  const std::optional<std::int32_t> wall = cells.onlyWallOf(key);
  if (!wall)
  {
    return false;
  }
  cells.changeRegion(key, *wall);
  const bool isDone = mergeWithAny(cells, key);
  if (!isDone)
  {
    cells.changeRegion(key, *wall);
  }
  return isDone;
}

bool removeAtBoundary(CellComplex& cells, CellKey key)
{
  const bool mayGo = cells.isAtBoundary(key) && !cells.neighbours(key).empty();
  if (mayGo)
  {
    cells.remove(key);
  }
  return mayGo;
}

}

std::size_t mergeFewFaced(
  CellComplex& cells, const std::vector<CellKey>& keys, Execution& execution)
{
  std::size_t gone = 0;
  MeasuredCell cell;
  for (const CellKey key : keys)
  {
    execution.poll();
    if (!cells.isAlive(key) || !cells.isFree(key) || !hasFewFaces(cells, key, cell))
    {
      continue;
    }
    cells.open(key);
    const std::size_t counts = cells.counts(key);
    gone += mergeWithAny(cells, key) || mergeBeyondWall(cells, key) || removeAtBoundary(cells, key)
      ? counts
      : 0;
  }
  return gone;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellCession.h"

#include "Shaping/RefusedCells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// The interface moves by no more than this part of the box's edge.
constexpr double LargestShift = 0.02;

// The wall of a cell between two regions if it may go to its other side.
std::optional<std::int32_t> wallOfThin(const CellComplex& cells, CellKey key)
{
  const std::optional<std::int32_t> wall = cells.onlyWallOf(key);
  if (!wall)
  {
    return {};
  }
  MeasuredCell cell;
  cells.lookAround(key, cell);
  double walls = 0;
  for (std::size_t f = 0; f < cell.across.size(); ++f)
  {
    walls += cell.shape.isBoundary[f] ? norm(cell.measures.faces[f].area) : 0;
  }
  const double most = LargestShift * walls * std::cbrt(cells.volumeOfBox(key));
  return cell.measures.volume <= most ? wall : std::nullopt;
}

Verdict verdictOf(const CellComplex& cells, CellKey key)
{
  MeasuredCell cell;
  return verdictOf(cells, key, cell);
}

using Keys = std::vector<CellKey>;

void changeRegion(CellComplex& cells, const Keys& thin, std::int32_t wall)
{
  std::for_each(thin.begin(), thin.end(), [&](CellKey key) { cells.changeRegion(key, wall); });
}

// Of its region, as they are.
std::vector<std::pair<CellKey, Verdict>> leftBehind(CellComplex& cells, const Keys& thin)
{
  std::set<CellKey> found;
  for (const CellKey key : thin)
  {
    for (const auto& [other, area] : cells.neighbours(key))
    {
      found.insert(other);
    }
  }
  for (const CellKey key : thin)
  {
    found.erase(key);
  }
  std::vector<std::pair<CellKey, Verdict>> left;
  for (const CellKey key : found)
  {
    cells.open(key);
    left.emplace_back(key, verdictOf(cells, key));
  }
  return left;
}

// Cells side by side at a wall.
bool cede(CellComplex& cells, const Keys& thin, std::int32_t wall, CellMerger& merger)
{
  // Nothing is worse than a wall without thickness.
  const bool areFlat =
    std::all_of(thin.begin(), thin.end(), [&](CellKey key) { return cells.share(key) < FlatCell; });
  const auto left = leftBehind(cells, thin);
  changeRegion(cells, thin, wall);
  if (!areFlat && std::any_of(left.begin(), left.end(), [&](const auto& cell) {
        return !accepts(Accepted::LeftBehind, cell.second, verdictOf(cells, cell.first));
      }))
  {
    changeRegion(cells, thin, wall);
    return false;
  }
  bool any = false;
  for (const CellKey key : thin)
  {
    if (cells.isAlive(key))
    {
      merger.improve(key);
    }
    if (!cells.isAlive(key) ||
      (cells.share(key) >= FlatCell && accepts(Accepted::Ceded, {}, verdictOf(cells, key))))
    {
      any = true;
    }
    else
    {
      cells.changeRegion(key, wall);
    }
  }
  return any;
}

}

bool cede(CellComplex& cells, CellKey key, CellMerger& merger)
{
  const std::optional<std::int32_t> wall = wallOfThin(cells, key);
  return wall && cede(cells, { key }, *wall, merger);
}

bool cedeCells(CellComplex& cells, const std::vector<CellKey>& keys, double largest,
  CellMerger& merger, Execution& execution)
{
  std::map<CellKey, std::int32_t> thin;
  for (const CellKey key : keys)
  {
    execution.poll();
    const bool isSmall = cells.isAlive(key) && cells.share(key) < largest;
    if (const auto wall = isSmall ? wallOfThin(cells, key) : std::nullopt)
    {
      thin[key] = *wall;
    }
  }
  bool any = false;
  for (const Keys& group : sideBySide(cells, thin))
  {
    execution.poll();
    const bool all = cells.isAlive(group.front()) && group.size() > 1 &&
      cede(cells, group, thin[group.front()], merger);
    any = any || all;
    for (std::size_t i = 0; !all && i < group.size(); ++i)
    {
      any = (cells.isAlive(group[i]) && cede(cells, group[i], merger)) || any;
    }
  }
  return any;
}

}

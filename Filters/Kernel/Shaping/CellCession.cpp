// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellCession.h"

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

// Cells side by side at the same wall.
struct ThinCells
{
  std::vector<CellKey> keys;
  std::int32_t wall;
};

void changeRegion(CellComplex& cells, const ThinCells& thin)
{
  for (const CellKey key : thin.keys)
  {
    cells.changeRegion(key, thin.wall);
  }
}

// Of its region, as they are.
std::vector<std::pair<CellKey, Verdict>> leftBehind(CellComplex& cells, const ThinCells& thin)
{
  std::set<CellKey> found;
  for (const CellKey key : thin.keys)
  {
    for (const auto& [other, area] : cells.neighbours(key))
    {
      found.insert(other);
    }
  }
  for (const CellKey key : thin.keys)
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

bool cede(CellComplex& cells, const ThinCells& thin, CellMerger& merger)
{
  // Nothing is worse than a wall without thickness.
  const bool areFlat = std::all_of(
    thin.keys.begin(), thin.keys.end(), [&](CellKey key) { return cells.share(key) < FlatCell; });
  const auto left = leftBehind(cells, thin);
  changeRegion(cells, thin);
  if (!areFlat && std::any_of(left.begin(), left.end(), [&](const auto& cell) {
        return !accepts(Accepted::LeftBehind, cell.second, verdictOf(cells, cell.first));
      }))
  {
    changeRegion(cells, thin);
    return false;
  }
  bool any = false;
  for (const CellKey key : thin.keys)
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
      cells.changeRegion(key, thin.wall);
    }
  }
  return any;
}

// Each cell in one group, in the order of their first.
std::vector<ThinCells> sideBySide(const CellComplex& cells, std::map<CellKey, std::int32_t> thin)
{
  std::vector<ThinCells> groups;
  while (!thin.empty())
  {
    ThinCells group{ { thin.begin()->first }, thin.begin()->second };
    thin.erase(thin.begin());
    for (std::size_t i = 0; i < group.keys.size(); ++i)
    {
      for (const auto& [other, area] : cells.neighbours(group.keys[i]))
      {
        const auto at = thin.find(other);
        if (at != thin.end() && at->second == group.wall)
        {
          group.keys.push_back(other);
          thin.erase(at);
        }
      }
    }
    std::sort(group.keys.begin(), group.keys.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

}

bool cede(CellComplex& cells, CellKey key, CellMerger& merger)
{
  const std::optional<std::int32_t> wall = wallOfThin(cells, key);
  return wall && cede(cells, { { key }, *wall }, merger);
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
  for (const ThinCells& group : sideBySide(cells, std::move(thin)))
  {
    execution.poll();
    bool all =
      cells.isAlive(group.keys.front()) && group.keys.size() > 1 && cede(cells, group, merger);
    any = any || all;
    for (std::size_t i = 0; !all && i < group.keys.size(); ++i)
    {
      any = (cells.isAlive(group.keys[i]) && cede(cells, group.keys[i], merger)) || any;
    }
  }
  return any;
}

}

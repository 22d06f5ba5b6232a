// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellSplitting.h"

#include "Shaping/CutSearch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace cartesian
{

namespace
{

// A part smaller than this part of the cell is no use.
constexpr double LeastPart = 1e-3;

// Ends a search that never came to rest; a cell is cut some ten times at most.
constexpr int MostRounds = 100;

// The fittest last.
std::vector<CellCut> findCuts(
  const CellComplex& cells, double leastFraction, CellKey key, CellView& view)
{
  cells.view({ key }, view);
  cells.lookBeyond(key, view);
  CellShape shape;
  measure(view.shape, shape);
  const CellFaults before = faultsOf(view.shape, shape, view.beyond);
  const double least = std::max(LeastPart * shape.volume, leastFraction * cells.volumeOfBox(key));
  FoundCuts found = searchCuts(
    view, shape, before, [&](const CellCut& cut) { return faultsAfter(view, cut, least); });
  // Without concave edges nothing of the boundary fails.
  if (found.helpful.empty() && found.harmless && before.counts[CellFaults::BoundaryAngle] > 0)
  {
    found.helpful.push_back(std::move(*found.harmless));
  }
  return std::move(found.helpful);
}

bool fails(const CellComplex& cells, CellKey key)
{
  return cells.isAlive(key) && cells.isAtFault(key);
}

class Splitter
{
public:
  Splitter(CellComplex& cells, double leastFraction, Execution& execution)
    : cells_(cells)
    , leastFraction_(leastFraction)
    , execution_(execution)
  {
  }

  Splitting run(std::vector<CellKey> failing)
  {
    for (int round = 0; !failing.empty() && round < MostRounds; ++round)
    {
      next_.clear();
      const std::vector<CellKey> order = worstFirst(failing);
      for (std::size_t i = 0; i < order.size(); ++i)
      {
        const CellKey key = order[i];
        execution_.reach(doneBefore(round) +
          (doneBefore(round + 1) - doneBefore(round)) * double(i) / double(order.size()));
        if (fails(cells_, key))
        {
          split(key);
        }
      }
      failing.clear();
      for (const CellKey key : next_)
      {
        failed_.erase(key);
        if (fails(cells_, key))
        {
          failing.push_back(key);
        }
      }
    }
    failed_.insert(failing.begin(), failing.end());
    result_.failed.assign(failed_.begin(), failed_.end());
    return result_;
  }

private:
  // Each round does half of what is left, about.
  static double doneBefore(int round) { return 1 - std::ldexp(1.0, -round); }

  std::vector<CellKey> worstFirst(const std::vector<CellKey>& failing) const
  {
    std::vector<std::pair<float, CellKey>> order; // equal but for rounding is equal
    MeasuredCell cell;
    for (const CellKey key : failing)
    {
      execution_.poll();
      cells_.lookAround(key, cell);
      const double area = faultsOf(cell.shape, cell.measures, cell.beyond).area;
      order.emplace_back(-static_cast<float>(area), key);
    }
    std::sort(order.begin(), order.end());
    std::vector<CellKey> keys;
    keys.reserve(order.size());
    for (const auto& [area, key] : order)
    {
      keys.push_back(key);
    }
    return keys;
  }

  // By the fittest cut that spoils no cell beyond.
  void split(CellKey key)
  {
    CellView view;
    const std::vector<CellCut> cuts = findCuts(cells_, leastFraction_, key, view);
    cells_.open(key);
    for (auto cut = cuts.rbegin(); cut != cuts.rend(); ++cut)
    {
      const std::vector<CellKey> touched = cells_.touchedBy(key, view, *cut);
      if (cells_.allows(touched, view, *cut))
      {
        next_.insert(touched.begin(), touched.end());
        std::vector<CellKey> parts;
        cells_.cut(key, view, *cut, parts);
        next_.insert(parts.begin(), parts.end());
        result_.cellsSplit += cells_.counts(key);
        return;
      }
    }
    failed_.insert(key);
  }

  CellComplex& cells_;
  double leastFraction_;
  Execution& execution_;
  Splitting result_;
  std::set<CellKey> failed_;
  std::set<CellKey> next_; // to be looked at in the next round
};

}

std::optional<CellFaults> faultsAfter(const CellView& view, const CellCut& cut, double least)
{
  std::vector<Polyhedron> parts;
  parts.reserve(cut.parts);
  std::vector<CellShape> shapes(cut.parts);
  for (std::uint32_t p = 0; p < cut.parts; ++p)
  {
    parts.push_back(partOf(view.shape, cut, p));
    measure(parts[p], shapes[p]);
    if (!(shapes[p].volume > least))
    {
      return {};
    }
  }
  CellFaults sum;
  std::vector<NeighbourCell> beyond;
  std::vector<std::uint8_t> counts;
  beyond.reserve(cut.faces.size());
  counts.reserve(cut.faces.size());
  for (std::uint32_t p = 0; p < cut.parts; ++p)
  {
    beyond.clear();
    counts.clear();
    for (const CellCut::Face& face : cut.faces) // in the order of partOf
    {
      const bool inner = face.source == CellCut::NoSource;
      if (face.below == p || (inner && face.above == p))
      {
        const CellShape& other = shapes[face.below == p ? face.above : face.below];
        beyond.push_back(
          inner ? NeighbourCell{ other.centre, other.volume } : view.beyond[face.source]);
        counts.push_back(face.below == p ? 1 : 0);
      }
    }
    sum += faultsOf(parts[p], shapes[p], beyond, counts);
  }
  return sum;
}

Splitting splitCells(
  CellComplex& cells, std::vector<CellKey> failing, double leastFraction, Execution& execution)
{
  return Splitter(cells, leastFraction, execution).run(std::move(failing));
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellSplitting.h"

#include "Shaping/CellTrial.h"
#include "Shaping/CutSearch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace cartesian
{

namespace
{

// Ends a search that never came to rest; a cell is cut some ten times at most.
constexpr int MostRounds = 100;

// The fittest last.
std::vector<CellCut> findCuts(
  const CellComplex& cells, double leastFraction, CellKey key, CellView& view)
{
  CellShape shape;
  takeOut(cells, { key }, view, shape);
  const CellFaults before = faultsOf(view.shape, shape, view.beyond);
  const double least =
    std::max(AcceptedCut::LeastOfSplit * shape.volume, leastFraction * cells.volumeOfBox(key));
  CutParts made(view, shape);
  FoundCuts found = searchCuts(view, shape, before, [&](const CellCut& cut) {
    return made.make(cut, least) ? std::optional(made.faults()) : std::nullopt;
  });
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
      const std::vector<std::pair<float, CellKey>> order = worstFirst(failing);
      for (std::size_t i = 0; i < order.size(); ++i)
      {
        const CellKey key = order[i].second;
        execution_.reach(doneBefore(round) +
          (doneBefore(round + 1) - doneBefore(round)) * double(i) / double(order.size()));
        if (fails(cells_, key))
        {
          split(key);
        }
      }
      failing.clear();
      std::copy_if(next_.begin(), next_.end(), std::back_inserter(failing),
        [&](CellKey key) { return fails(cells_, key); });
    }
    return result_;
  }

private:
  // Each round does about half of the rest.
  static double doneBefore(int round) { return 1 - std::ldexp(1.0, -round); }

  std::vector<std::pair<float, CellKey>> worstFirst(const std::vector<CellKey>& failing) const
  {
    std::vector<std::pair<float, CellKey>> order; // equal up to rounding counts as equal
    MeasuredCell cell;
    for (const CellKey key : failing)
    {
      execution_.poll();
      cells_.lookAround(key, cell);
      const double area = faultsOf(cell.shape, cell.measures, cell.beyond).area;
      order.emplace_back(-static_cast<float>(area), key);
    }
    std::sort(order.begin(), order.end());
    return order;
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
  }

  CellComplex& cells_;
  double leastFraction_;
  Execution& execution_;
  Splitting result_;
  std::set<CellKey> next_; // to be looked at in the next round
};

}

Splitting splitCells(
  CellComplex& cells, std::vector<CellKey> failing, double leastFraction, Execution& execution)
{
  return Splitter(cells, leastFraction, execution).run(std::move(failing));
}

}

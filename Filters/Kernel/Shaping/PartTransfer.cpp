// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/PartTransfer.h"

#include "Shaping/CellCession.h"
#include "Shaping/CutSearch.h"
#include "Shaping/RefusedCells.h"

#include <algorithm>

namespace cartesian
{

namespace
{

bool isAtBoundary(const Polyhedron& part)
{
  return std::find(part.isBoundary.begin(), part.isBoundary.end(), 1) != part.isBoundary.end();
}

// The faults of the largest part where nothing is beyond the cut, or nothing where the other parts are
// too large, or all inside.
std::optional<CellFaults> faultsOfRest(
  CutParts& made, const CellCut& cut, double volume, double mostGiven)
{
  made.make(cut, -Never);
  const auto inside = std::count_if(made.parts.begin(), made.parts.end(),
    [](const Polyhedron& part) { return !isAtBoundary(part); });
  const auto largest = std::max_element(made.shapes.begin(), made.shapes.end(),
    [](const CellShape& a, const CellShape& b) { return a.volume < b.volume; });
  const auto part = static_cast<std::size_t>(largest - made.shapes.begin());
  if (volume - largest->volume > mostGiven || inside > (isAtBoundary(made.parts[part]) ? 0 : 1))
  {
    return {};
  }
  return made.faultsAlone(part);
}

// All parts but the largest.
void giveAway(CellComplex& cells, const std::vector<CellKey>& parts, LeftOver leftOver,
  CellMerger& merger, std::vector<RemovedCell>& removed)
{
  const CellKey largest = *std::max_element(parts.begin(), parts.end(),
    [&](CellKey a, CellKey b) { return cells.volume(a) < cells.volume(b); });
  for (const CellKey part : parts)
  {
    if (part == largest || merger.improve(part) || !cells.isAlive(part) || !cells.isAlive(largest))
    {
      continue;
    }
    if (leftOver == LeftOver::IsRemoved && cells.share(part) < LargestRefused &&
      cells.isAtBoundary(part) && keepsWall(cells, part) && sparesOthers(cells, part))
    {
      remove(cells, part, removed);
    }
    else if (leftOver == LeftOver::ComesBack || !cede(cells, part, merger))
    {
      cells.merge(part, largest);
    }
  }
}

void transfer(CellComplex& cells, CellKey key, LeftOver leftOver, CellMerger& merger,
  std::vector<RemovedCell>& removed)
{
  CellView view;
  CellShape shape;
  takeOut(cells, { key }, view, shape);
  const double mostGiven = AcceptedCut::MostGiven * cells.volumeOfBox(key);
  CutParts made(view, shape);
  const FoundCuts found = searchCuts(view, shape, faultsOf(view.shape, shape, view.beyond),
    [&](const CellCut& cut) { return faultsOfRest(made, cut, shape.volume, mostGiven); });
  for (auto cut = found.helpful.rbegin(); cut != found.helpful.rend(); ++cut)
  {
    cells.open(key);
    if (cells.allows(cells.touchedBy(key, view, *cut), view, *cut))
    {
      std::vector<CellKey> parts;
      cells.cut(key, view, *cut, parts);
      giveAway(cells, parts, leftOver, merger, removed);
      return;
    }
  }
}

}

void transferParts(CellComplex& cells, const std::vector<CellKey>& keys, LeftOver leftOver,
  CellMerger& merger, Execution& execution, std::vector<RemovedCell>& removed)
{
  for (const CellKey key : keys)
  {
    execution.poll();
    if (cells.isAlive(key))
    {
      transfer(cells, key, leftOver, merger, removed);
    }
  }
}

}

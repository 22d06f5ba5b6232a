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

constexpr double LargestPart = 0.5; // of the cell's box

bool isAtBoundary(const Polyhedron& part)
{
  return std::find(part.isBoundary.begin(), part.isBoundary.end(), 1) != part.isBoundary.end();
}

// The fitness of the largest part where nothing is beyond the cut, or nothing where the other parts are
// too large, or all inside.
std::optional<CellFaults> fitnessOfRest(
  const CellView& view, const CellCut& cut, double volume, double mostGiven)
{
  Polyhedron rest;
  CellShape shape;
  std::uint32_t largest = 0;
  std::uint32_t inside = 0; // parts
  for (std::uint32_t p = 0; p < cut.parts; ++p)
  {
    Polyhedron part = partOf(view.shape, cut, p);
    CellShape measures;
    measure(part, measures);
    inside += isAtBoundary(part) ? 0 : 1;
    if (p == 0 || measures.volume > shape.volume)
    {
      largest = p;
      rest = std::move(part);
      shape = std::move(measures);
    }
  }
  if (volume - shape.volume > mostGiven || inside > (isAtBoundary(rest) ? 0 : 1))
  {
    return {};
  }
  std::vector<NeighbourCell> beyond;
  std::size_t face = 0;
  for (const CellCut::Face& f : cut.faces) // in the order of partOf
  {
    const bool isCut = f.source == CellCut::NoSource;
    if (f.below == largest || (isCut && f.above == largest))
    {
      rest.isBoundary[face] = isCut || view.shape.isBoundary[f.source];
      beyond.push_back(isCut ? NeighbourCell{} : view.beyond[f.source]);
      ++face;
    }
  }
  return faultsOf(rest, shape, beyond);
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
  cells.view({ key }, view);
  cells.lookBeyond(key, view);
  measure(view.shape, shape);
  const double mostGiven = LargestPart * cells.volumeOfBox(key);
  const FoundCuts found = searchCuts(view, shape, faultsOf(view.shape, shape, view.beyond),
    [&](const CellCut& cut) { return fitnessOfRest(view, cut, shape.volume, mostGiven); });
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

// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellCarving.h"

#include "Shaping/CutSearch.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// A cell loses a part as often as that.
constexpr int MostCuts = 3;

bool isAtBoundary(const Polyhedron& part)
{
  return std::find(part.isBoundary.begin(), part.isBoundary.end(), 1) != part.isBoundary.end();
}

// The fitness of the largest part, the others being gone, or nothing where these are too large, or
// would leave a hole inside the mesh.
std::optional<CellFaults> fitnessOfRest(
  const CellView& view, const CellCut& cut, double volume, double mostLost)
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
  if (volume - shape.volume > mostLost || inside > (isAtBoundary(rest) ? 0 : 1))
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

// Removes all parts but the largest; returns how many those are.
std::size_t keepLargest(CellComplex& cells, const std::vector<CellKey>& parts)
{
  const CellKey largest = *std::max_element(parts.begin(), parts.end(),
    [&](CellKey a, CellKey b) { return cells.volume(a) < cells.volume(b); });
  for (const CellKey part : parts)
  {
    if (part != largest)
    {
      cells.remove(part);
    }
  }
  return parts.size() - 1;
}

// Returns how many parts were removed.
std::size_t carve(CellComplex& cells, CellKey key, double largest)
{
  CellView view;
  CellShape shape;
  cells.view({ key }, view);
  cells.lookBeyond(key, view);
  measure(view.shape, shape);
  const double mostLost = largest * cells.volumeOfBox(key);
  const FoundCuts found = searchCuts(view, shape, faultsOf(view.shape, shape, view.beyond),
    [&](const CellCut& cut) { return fitnessOfRest(view, cut, shape.volume, mostLost); });
  for (auto cut = found.helpful.rbegin(); cut != found.helpful.rend(); ++cut)
  {
    cells.open(key);
    if (cells.allows(cells.touchedBy(key, view, *cut), view, *cut))
    {
      std::vector<CellKey> parts;
      cells.cut(key, view, *cut, parts);
      return keepLargest(cells, parts);
    }
  }
  return 0;
}

}

std::size_t carveCells(
  CellComplex& cells, const std::vector<CellKey>& keys, double largest, Execution& execution)
{
  std::size_t carved = 0;
  for (const CellKey key : keys)
  {
    execution.poll();
    std::size_t parts = 1;
    for (int i = 0; i < MostCuts && parts > 0 && cells.isAlive(key) && cells.isAtFault(key); ++i)
    {
      parts = carve(cells, key, largest);
      carved += parts * cells.counts(key);
    }
  }
  return carved;
}

}

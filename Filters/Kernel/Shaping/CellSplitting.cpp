// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellSplitting.h"

#include "Shaping/CutSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace cartesian
{

namespace
{

// A part smaller than this part of the cell is no use.
constexpr double LeastPart = 1e-3;

// ... of one that is invalid.
constexpr double LeastPartOfInvalid = 1e-6;

// ... by a cut that only makes room for another.
constexpr double LeastHalf = 0.02;

const Turns TurnsOfInvalid{ 0, 0.4, -0.4 };

constexpr std::uint32_t None = ~std::uint32_t(0);

// Ends a search that never came to rest; a cell is cut some ten times at most.
constexpr int MostRounds = 100;

// The parts' fitness, or nothing where one is smaller than `least`.
std::optional<CellFaults> fitnessAfter(const CellView& view, const CellCut& cut, double least)
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

CellFaults faultsBefore(
  const CellComplex& cells, CellKey key, CellView& view, CellShape& shape)
{
  cells.view({ key }, view);
  cells.lookBeyond(key, view);
  measure(view.shape, shape);
  return faultsOf(view.shape, shape, view.beyond);
}

// The fittest last.
std::vector<CellCut> findCuts(
  const CellComplex& cells, double leastFraction, CellKey key, CellView& view)
{
  CellShape shape;
  const CellFaults before = faultsBefore(cells, key, view, shape);
  const double least = std::max(LeastPart * shape.volume, leastFraction * cells.volumeOfBox(key));
  FoundCuts found = searchCuts(
    view, shape, before, [&](const CellCut& cut) { return fitnessAfter(view, cut, least); });
  // Without concave edges nothing of the boundary fails.
  if (found.helpful.empty() && found.harmless && before.counts[CellFaults::BoundaryAngle] > 0)
  {
    found.helpful.push_back(std::move(*found.harmless));
  }
  return std::move(found.helpful);
}

// What is invalid of faces between two regions as the cells beyond them see them: of those that a cut divides, or of
// all if there is none.
class FaultsBeyond
{
public:
  FaultsBeyond(const CellComplex& cells, CellKey key, const CellView& view)
    : view_(view)
    , beyond_(view.faces.size())
  {
    for (std::size_t f = 0; f < view.faces.size(); ++f)
    {
      if (view.across[f] != None && view.shape.isBoundary[f])
      {
        beyond_[f] = cells.placeFrom(key, view.across[f]);
      }
    }
  }

  CellFaults asTheyAre() const
  {
    CellFaults sum;
    for (std::uint32_t f = 0; f < view_.faces.size(); ++f)
    {
      sum += faultsOf(f, ringOf(view_.shape, f), view_.shape.nodes);
    }
    return sum;
  }

  CellFaults after(const CellCut& cut) const
  {
    RawVector<Vector> nodes = view_.shape.nodes;
    for (const CellCut::NewNode& point : cut.points)
    {
      nodes.push_back(point.at);
    }
    CellFaults sum;
    for (const CellCut::Face& face : cut.faces)
    {
      const CellCut::FaceCorners corners = cut.cornersOf(face);
      if (face.source != CellCut::NoSource)
      {
        sum += faultsOf(face.source, { nodes.data(), corners.first, corners.size() }, nodes);
      }
    }
    return sum;
  }

private:
  CellFaults faultsOf(std::uint32_t face, const Ring& ring, const RawVector<Vector>& nodes) const
  {
    const NeighbourCell& beyond = beyond_[face];
    if (beyond.volume <= 0)
    {
      return {};
    }
    Polyhedron seen;
    seen.nodes = nodes;
    for (std::size_t i = ring.size; i-- > 0;)
    {
      seen.addCorner(ring.corners[i]);
    }
    seen.closeFace(true);
    CellShape shape;
    shape.volume = beyond.volume;
    shape.centre = beyond.centre;
    shape.faces.push_back(measure(ringOf(seen, 0)));
    return cartesian::faultsOf(seen, shape, { {} }).invalid();
  }

  const CellView& view_;
  std::vector<NeighbourCell> beyond_; // of each face, in another region
};

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

Splitting splitCells(
  CellComplex& cells, std::vector<CellKey> failing, double leastFraction, Execution& execution)
{
  return Splitter(cells, leastFraction, execution).run(std::move(failing));
}

double smallestPart(const CellView& view, const CellCut& cut)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (std::uint32_t p = 0; p < cut.parts; ++p)
  {
    CellShape shape;
    measure(partOf(view.shape, cut, p), shape);
    smallest = std::min(smallest, shape.volume);
  }
  return smallest;
}

// A cell that has been removed is in nobody's way.
bool allowsBesideRemoved(
  CellComplex& cells, CellKey key, const CellView& view, const CellCut& cut)
{
  std::vector<CellKey> touched = cells.touchedBy(key, view, cut);
  touched.erase(std::remove_if(touched.begin(), touched.end(),
                  [&](CellKey other) { return !cells.isAlive(other); }),
    touched.end());
  return cells.allows(touched, view, cut);
}

bool splitInvalid(CellComplex& cells, CellKey key, std::vector<CellKey>& parts)
{
  CellView view;
  CellShape shape;
  CellFaults before = faultsBefore(cells, key, view, shape).invalid();
  const FaultsBeyond beyond(cells, key, view);
  before += beyond.asTheyAre();
  cells.open(key);
  std::optional<CellCut> halves; // does no harm
  double smallest = LeastHalf * shape.volume;
  FoundCuts found = searchCuts(
    view, shape, before,
    [&](const CellCut& cut) -> std::optional<CellFaults> {
      std::optional<CellFaults> after =
        fitnessAfter(view, cut, LeastPartOfInvalid * shape.volume);
      if (!after || !allowsBesideRemoved(cells, key, view, cut))
      {
        return {};
      }
      after = after->invalid();
      *after += beyond.after(cut);
      if (after->weight() == before.weight() && smallestPart(view, cut) > smallest)
      {
        smallest = smallestPart(view, cut);
        halves = cut;
      }
      return after;
    },
    TurnsOfInvalid);
  if (found.helpful.empty() && halves && before.count() > 0)
  {
    found.helpful.push_back(std::move(*halves));
  }
  if (!found.helpful.empty())
  {
    cells.cut(key, view, found.helpful.back(), parts);
  }
  return !found.helpful.empty();
}

}

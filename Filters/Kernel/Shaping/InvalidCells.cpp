// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/InvalidCells.h"

#include "Shaping/CellTrial.h"
#include "Shaping/CutSearch.h"

#include <algorithm>
#include <optional>

namespace cartesian
{

namespace
{

constexpr std::uint32_t None = ~std::uint32_t(0);

// Volume of the smallest part of a cut that only makes room for another, of the cell's.
constexpr double LeastOfNeutral = 0.02;

// Of planes through concave edges, in radians: the one that halves the angle may meet a node.
const Turns TurnsTried{ 0, 0.4, -0.4 };

// Each cuts the parts of the one before.
constexpr int MostRounds = 8;

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

// A removed cell does not obstruct anything.
std::vector<CellKey> touchedBy(
  CellComplex& cells, CellKey key, const CellView& view, const CellCut& cut)
{
  std::vector<CellKey> touched = cells.touchedBy(key, view, cut);
  touched.erase(std::remove_if(touched.begin(), touched.end(),
                  [&](CellKey other) { return !cells.isAlive(other); }),
    touched.end());
  return touched;
}

// Appends the parts' keys; false: nothing is invalid, or no cut is allowed.
bool split(CellComplex& cells, CellKey key, std::vector<CellKey>& parts)
{
  CellView view;
  CellShape shape;
  takeOut(cells, { key }, view, shape);
  const FaultsBeyond beyond(cells, key, view);
  CellFaults before = faultsOf(view.shape, shape, view.beyond).invalid();
  before += beyond.asTheyAre();
  if (before.weight() == 0)
  {
    return false;
  }
  cells.open(key);
  std::optional<CellCut> neutral;
  double smallest = LeastOfNeutral * shape.volume;
  CutParts made(view, shape);
  FoundCuts found = searchCuts(
    view, shape, before,
    [&](const CellCut& cut) -> std::optional<CellFaults> {
      if (!made.make(cut, AcceptedCut::LeastOfInvalid * shape.volume))
      {
        return {};
      }
      const std::vector<CellKey> touched = touchedBy(cells, key, view, cut);
      CellFaults after = made.faults().invalid();
      after += beyond.after(cut);
      if (after.weight() > before.weight() || made.largestAspect() > AcceptedCut::AspectOfInvalid ||
        !cells.allows(touched, view, cut))
      {
        return {};
      }
      if (after.weight() == before.weight() && made.smallest > smallest)
      {
        smallest = made.smallest;
        neutral = cut;
      }
      return after;
    },
    TurnsTried);
  if (found.helpful.empty() && !neutral)
  {
    return false;
  }
  cells.cut(key, view, found.helpful.empty() ? *neutral : found.helpful.back(), parts);
  return true;
}

}

std::size_t splitInvalid(CellComplex& cells, std::vector<CellKey> keys, Execution& execution)
{
  std::size_t cuts = 0;
  for (int round = 0; round < MostRounds && !keys.empty(); ++round)
  {
    std::vector<CellKey> parts;
    for (const CellKey key : keys)
    {
      execution.poll();
      const bool mayChange = cells.isAlive(key) && cells.isFree(key);
      cuts += mayChange && split(cells, key, parts) ? cells.counts(key) : 0;
    }
    keys = std::move(parts);
  }
  return cuts;
}

}

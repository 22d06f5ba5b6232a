// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/TipRemoval.h"

#include "Polyhedra/CellCost.h"
#include "Shaping/CellUnion.h"

#include <algorithm>
#include <set>

namespace cartesian
{

namespace
{

// Cosine of 45 degrees: what leans more from the surface is a step.
constexpr double LeastCosine = 0.7071;

class TipSearch
{
public:
  TipSearch(CellComplex& cells, const JoinSpec& joins)
    : cells_(cells)
    , joins_(joins)
    , trying_(cells)
  {
  }

  bool mayGo(CellKey key)
  {
    cells_.lookAround(key, tip_);
    const bool isAlone = std::all_of(
      tip_.across.begin(), tip_.across.end(), [](CellKey other) { return other == None; });
    if (isAlone || leavesStep())
    {
      return false;
    }
    const double worst = std::max({ costsOf(tip_.shape, tip_.measures, tip_.beyond).worst,
      costOfShare(cells_.share(key)), costOfDeterminant(tip_.shape, tip_.measures) });
    std::vector<CellKey> around = tip_.across;
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return std::all_of(around.begin(), around.end(),
      [&](CellKey other) { return other == None || isFairWithout(other, key, worst); });
  }

private:
  bool leavesStep() const
  {
    Vector boundary{};
    for (std::size_t f = 0; f < tip_.across.size(); ++f)
    {
      boundary = tip_.across[f] == None ? plus(boundary, tip_.measures.faces[f].area) : boundary;
    }
    const Vector normal = unit(boundary);
    for (std::size_t f = 0; f < tip_.across.size(); ++f)
    {
      if (tip_.across[f] != None && -dot(unit(tip_.measures.faces[f].area), normal) < LeastCosine)
      {
        return true;
      }
    }
    return false;
  }

  // Whether solvers accept a cell with boundary faces towards one that is gone, which become one with others where
  // that helps, and nothing is worse than it was, or costs more than `most`.
  bool isFairWithout(CellKey other, CellKey gone, double most)
  {
    if (!cells_.isFree(other))
    {
      return false;
    }
    cells_.open(other); // a hexahedron has no faces of its own
    CellView& view = without_.view;
    without_.keys.assign(1, other);
    cells_.view(without_.keys, view);
    cells_.lookBeyond(other, view);
    measure(view.shape, beside_);
    const double before = costsOf(view.shape, beside_, view.beyond).worst;
    for (std::size_t f = 0; f < view.across.size(); ++f)
    {
      if (view.across[f] == gone)
      {
        view.shape.isBoundary[f] = 1;
        view.across[f] = None;
        view.boundary[f] = cells_.mainBoundary(gone);
        view.beyond[f] = {};
      }
    }
    const double cost = trying_.tryOutView(without_, joins_);
    return cost < Never && trying_.simplify(without_, cost) < Never && without_.costs.refused == 0 &&
      without_.costs.worst <= std::max({ most, before, StrainedCost });
  }

  CellComplex& cells_;
  const JoinSpec& joins_;
  UnionTrial trying_;

  // Kept for their memory:
  MeasuredCell tip_;
  CellShape beside_;
  CellUnion without_;
};

}

void removeTips(CellComplex& cells, const std::vector<CellKey>& keys, const SmallCellSpec& small,
  double largest, const JoinSpec& joins)
{
  TipSearch search(cells, joins);
  std::set<CellKey> beside;
  for (const CellKey key : keys)
  {
    const double share = cells.share(key);
    if (share < largest && beside.count(key) == 0 && cells.isAtBoundary(key) &&
      share < ratioOf(small, cells.mainBoundary(key), largest) && search.mayGo(key))
    {
      for (const auto& [other, area] : cells.neighbours(key))
      {
        beside.insert(other);
      }
      cells.remove(key);
    }
  }
}

}

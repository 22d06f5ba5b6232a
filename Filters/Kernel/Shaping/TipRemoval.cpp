// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/TipRemoval.h"

#include "Acceptance/CellCost.h"
#include "Shaping/CellUnion.h"
#include "Shaping/RefusedCells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace cartesian
{

namespace
{

// Cosine of 45 degrees: what leans more from the surface is a step.
constexpr double StepCosine = 0.7071;

// Cosine of 30 degrees: where the surface turns more, a ledge of this part of a box's side is none.
constexpr double TurnCosine = 0.866;
constexpr double LargestLedge = 0.02;

// Cells with a poor determinant are tips up to a size that is larger by this factor.
constexpr double LargerOfPoorDeterminant = 2;

// Adjacent tips that hold more than this many of the largest are not a tip.
constexpr double MostSideBySide = 2;

class TipSearch
{
public:
  TipSearch(CellComplex& cells, const JoinSpec& joins)
    : cells_(cells)
    , joins_(joins)
    , trying_(cells)
  {
  }

  // Smaller than this part of its box, or not much larger where its determinant is poor.
  bool isSmall(CellKey key, double largest)
  {
    const double share = cells_.share(key);
    if (share < largest || share >= LargerOfPoorDeterminant * largest)
    {
      return share < largest;
    }
    cells_.shape(key, cell_.shape);
    measure(cell_.shape, cell_.measures);
    return costOfDeterminant(cell_.shape, cell_.measures) > PoorCost;
  }

  // Cells side by side.
  bool mayGo(const std::vector<CellKey>& keys)
  {
    cells_.view(keys, tip_);
    measure(tip_.shape, shape_);
    std::set<CellKey> around(tip_.across.begin(), tip_.across.end());
    around.erase(None);
    if (around.empty() || leavesStep(keys.front()))
    {
      return false;
    }
    Verdict tip;
    for (const CellKey key : keys)
    {
      tip += verdictOf(cells_, key, cell_);
    }
    return std::all_of(
      around.begin(), around.end(), [&](CellKey other) { return isFairWithout(other, keys, tip); });
  }

private:
  // Whether the exposed faces lean away from all patches that they replace.
  bool leavesStep(CellKey key) const
  {
    std::vector<Vector> normals;
    for (std::size_t f = 0; f < tip_.across.size(); ++f)
    {
      if (tip_.across[f] == None)
      {
        normals.push_back(unit(shape_.faces[f].area));
      }
    }
    const double side = std::pow(cells_.volumeOfBox(key), 2.0 / 3);
    const double ledge = turns(normals) ? LargestLedge * side : 0;
    for (std::size_t f = 0; f < tip_.across.size(); ++f)
    {
      const Vector normal = scaled(unit(shape_.faces[f].area), -1);
      if (tip_.across[f] != None && norm(shape_.faces[f].area) > ledge &&
        std::none_of(normals.begin(), normals.end(),
          [&](const Vector& patch) { return dot(patch, normal) >= StepCosine; }))
      {
        return true;
      }
    }
    return false;
  }

  static bool turns(const std::vector<Vector>& normals)
  {
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      for (std::size_t k = 0; k < i; ++k)
      {
        if (dot(normals[i], normals[k]) < TurnCosine)
        {
          return true;
        }
      }
    }
    return false;
  }

  // Whether a cell passes with boundary faces towards the removed ones, joined with others if that helps, and nothing
  // is worse than it was, or than in the removed ones.
  bool isFairWithout(CellKey other, const std::vector<CellKey>& gone, Verdict before)
  {
    if (!cells_.isFree(other))
    {
      return false;
    }
    cells_.open(other); // a hexahedron has no faces of its own
    CellView& view = rest_.view;
    rest_.keys.assign(1, other);
    trying_.look(rest_);
    before += evaluate(view.shape, rest_.shape, view.beyond);
    for (std::size_t f = 0; f < view.across.size(); ++f)
    {
      if (std::find(gone.begin(), gone.end(), view.across[f]) != gone.end())
      {
        view.shape.isBoundary[f] = 1;
        view.boundary[f] = cells_.mainBoundary(view.across[f]);
        view.across[f] = None;
        view.beyond[f] = {};
      }
    }
    CellUnion without;
    without.of = &rest_;
    trying_.tryOut(without, joins_);
    trying_.simplify(without);
    return accepts(Accepted::TipRemoval, before, without.verdict);
  }

  CellComplex& cells_;
  const JoinSpec& joins_;
  UnionTrial trying_;

  // Kept for their memory:
  CellView tip_;
  CellShape shape_;
  MeasuredCell cell_;
  UnionView rest_;
};

}

void removeTips(CellComplex& cells, const std::vector<CellKey>& keys, const SmallCellSpec& small,
  double largest, const JoinSpec& joins)
{
  TipSearch search(cells, joins);
  std::map<CellKey, std::int32_t> tips;
  for (const CellKey key : keys)
  {
    if (cells.isAtBoundary(key) &&
      search.isSmall(key, ratioOf(small, cells.mainBoundary(key), largest)))
    {
      tips[key] = 0;
    }
  }
  std::set<CellKey> beside;
  const auto tryOut = [&](const std::vector<CellKey>& group) {
    const auto isBeside = [&](CellKey key) { return beside.count(key) > 0; };
    if (std::any_of(group.begin(), group.end(), isBeside) || !search.mayGo(group))
    {
      return false;
    }
    for (const CellKey key : group)
    {
      for (const auto& [other, area] : cells.neighbours(key))
      {
        beside.insert(other);
      }
    }
    std::for_each(group.begin(), group.end(), [&](CellKey key) { cells.remove(key); });
    return true;
  };
  const auto shareOf = [&](double sum, CellKey key) { return sum + cells.share(key); };
  for (const std::vector<CellKey>& group : sideBySide(cells, std::move(tips)))
  {
    const bool isTip =
      std::accumulate(group.begin(), group.end(), 0.0, shareOf) < MostSideBySide * largest;
    if (!isTip || !tryOut(group))
    {
      for (std::size_t i = 0; group.size() > 1 && i < group.size(); ++i)
      {
        tryOut({ group[i] });
      }
    }
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/RefusedCells.h"

#include "Acceptance/Acceptance.h"
#include "Cells/FlatBorders.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

namespace cartesian
{

namespace
{

// Parts of the area of a box's side: the wall of further boundaries that may be removed with a cell, and the change
// of its total wall area.
constexpr double LargestOfOthers = 0.02;
constexpr double LargestChange = 0.2;

// ... both where two boundaries meet in a plane.
constexpr double LargestAtBorder = 0.0005;

struct Candidate
{
  double volume; // as a part of its box
  CellKey key;

  bool operator<(const Candidate& other) const
  {
    const auto a = static_cast<float>(volume); // equal up to rounding counts as equal
    const auto b = static_cast<float>(other.volume);
    return a != b ? a < b : key < other.key;
  }
};

class Search
{
public:
  Search(const CellComplex& cells, const SmallCellSpec& small, double largest)
    : cells_(cells)
    , small_(small)
    , largest_(largest)
  {
  }

  // For each failing face of a cell, finds the smaller of its two cells that may be removed.
  void lookAt(CellKey key)
  {
    cells_.lookAround(key, cell_);
    const Candidate own{ cells_.share(key), key };
    if (cell_.across.size() < LeastFaces && mayGo(own))
    {
      candidates_.insert(own);
      return;
    }
    Refusal refusal{ cell_.shape, cell_.measures, cell_.beyond };
    for (std::size_t f = 0; f < cell_.across.size(); ++f)
    {
      if (!refusal.isRefused(f))
      {
        continue;
      }
      if (isTurnedOver(cell_.measures, f, cell_.beyond[f]))
      {
        lookAtTurnedOver(own, f);
        continue;
      }
      const CellKey other = cell_.across[f];
      Candidate smaller = own;
      Candidate larger = other == None ? own : Candidate{ cells_.share(other), other };
      if (larger < smaller)
      {
        std::swap(smaller, larger);
      }
      if (mayGoThoughValid(smaller))
      {
        candidates_.insert(smaller);
      }
      else if (mayGoThoughValid(larger))
      {
        candidates_.insert(larger);
      }
    }
  }

  const std::set<Candidate>& candidates() const { return candidates_; }

private:
  // The cell on whose side the face's pyramid is inverted: without the other it would be as bad.
  void lookAtTurnedOver(const Candidate& own, std::size_t f)
  {
    const bool ofOwn = isTurnedOver(cell_.measures, f, {});
    const CellKey other = cell_.across[f];
    const Candidate invalid =
      ofOwn || other == None ? own : Candidate{ cells_.share(other), other };
    if (mayGo(invalid))
    {
      candidates_.insert(invalid);
    }
  }

  bool mayGo(const Candidate& candidate) { return candidate.volume < limitOf(candidate.key); }

  bool mayGoThoughValid(const Candidate& candidate)
  {
    return candidate.volume < LargestRefused && mayGo(candidate) &&
      keepsWall(cells_, candidate.key);
  }

  // Needed for each face of a cell, and takes all of its faces: computed only once.
  double limitOf(CellKey key)
  {
    const auto [known, isNew] = limitOf_.try_emplace(key, 0);
    if (isNew && cells_.hasFaces(key) && cells_.isFree(key) && cells_.isAtBoundary(key))
    {
      known->second = ratioOf(small_, cells_.mainBoundary(key), largest_);
    }
    return known->second;
  }

  const CellComplex& cells_;
  const SmallCellSpec& small_;
  double largest_;
  MeasuredCell cell_;
  std::set<Candidate> candidates_;
  std::unordered_map<CellKey, double> limitOf_; // 0: it stays
};

bool hasBorderInPlane(const CellComplex& cells, CellKey key)
{
  CellView view;
  CellShape shape;
  cells.view({ key }, view);
  measure(view.shape, shape);
  std::vector<BoundaryAndNormal> patches;
  for (std::size_t f = 0; f < view.across.size(); ++f)
  {
    if (view.across[f] == None)
    {
      patches.push_back({ view.boundary[f], unit(shape.faces[f].area) });
    }
  }
  return haveBorderInPlane(patches);
}

bool isAcceptedWithout(const CellComplex& cells, CellKey other, CellKey gone)
{
  MeasuredCell cell;
  cells.lookAround(other, cell);
  std::vector<std::uint8_t> exposed;
  for (std::size_t f = 0; f < cell.across.size(); ++f)
  {
    exposed.push_back(cell.across[f] == gone ? 1 : 0);
    if (exposed.back())
    {
      cell.shape.isBoundary[f] = 1;
      cell.beyond[f] = {};
    }
  }
  return accepts(Accepted::Removal, {}, evaluate(cell.shape, cell.measures, cell.beyond, exposed));
}

}

bool sparesOthers(const CellComplex& cells, CellKey key)
{
  const auto neighbours = cells.neighbours(key);
  return std::all_of(neighbours.begin(), neighbours.end(), [&](const auto& neighbour) {
    const CellKey other = neighbour.first;
    return cells.isFree(other) || !cells.hasFaces(other) || isAcceptedWithout(cells, other, key);
  });
}

bool keepsWall(const CellComplex& cells, CellKey key)
{
  double gone = 0;
  double ofMain = 0;
  const std::map<std::int32_t, double> areas = cells.wallAreas(key);
  for (const auto& [boundary, area] : areas)
  {
    gone += area;
    ofMain = std::max(ofMain, area);
  }
  double exposed = 0;
  for (const auto& [other, area] : cells.neighbours(key))
  {
    exposed += area;
  }
  const double side = std::pow(cells.volumeOfBox(key), 2.0 / 3);
  const bool isAtBorder = areas.size() > 1 && hasBorderInPlane(cells, key);
  return gone - ofMain < (isAtBorder ? LargestAtBorder : LargestOfOthers) * side &&
    std::abs(exposed - gone) < (isAtBorder ? LargestAtBorder : LargestChange) * side;
}

std::vector<std::vector<CellKey>> sideBySide(
  const CellComplex& cells, std::map<CellKey, std::int32_t> kindOf)
{
  std::vector<std::vector<CellKey>> groups;
  while (!kindOf.empty())
  {
    const auto [first, kind] = *kindOf.begin();
    std::vector<CellKey> group{ first };
    kindOf.erase(first);
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      for (const auto& [other, area] : cells.neighbours(group[i]))
      {
        const auto at = kindOf.find(other);
        if (at != kindOf.end() && at->second == kind)
        {
          group.push_back(other);
          kindOf.erase(at);
        }
      }
    }
    std::sort(group.begin(), group.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

void remove(CellComplex& cells, CellKey key, std::vector<RemovedCell>& removed)
{
  if (cells.counts(key) > 0)
  {
    removed.push_back({ cells.boxOf(key), cells.volume(key) });
  }
  cells.remove(key);
}

void removeRefused(CellComplex& cells, const std::vector<CellKey>& keys, const SmallCellSpec& small,
  double largest, Execution& execution, std::vector<RemovedCell>& removed)
{
  Search search(cells, small, largest);
  for (const CellKey key : keys)
  {
    execution.poll();
    search.lookAt(key);
  }
  std::set<CellKey> beside;
  for (const Candidate& candidate : search.candidates())
  {
    if (beside.count(candidate.key) == 0 && sparesOthers(cells, candidate.key))
    {
      for (const auto& [other, area] : cells.neighbours(candidate.key))
      {
        beside.insert(other);
      }
      remove(cells, candidate.key, removed);
    }
  }
}

}

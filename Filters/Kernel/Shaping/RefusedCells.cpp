// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/RefusedCells.h"

#include <algorithm>
#include <iterator>

namespace cartesian
{

namespace
{

// Each round exposes faces of the cells next to those removed, which are seldom at fault.
constexpr int MostRounds = 10;

}

bool RefusedCells::Candidate::operator<(const Candidate& other) const
{
  const auto a = static_cast<float>(volume); // equal but for rounding is equal
  const auto b = static_cast<float>(other.volume);
  return a != b ? a < b : key < other.key;
}

std::size_t RefusedCells::remove(const std::vector<CellKey>& keys, double largest)
{
  largest_ = largest;
  removed_ = 0;
  std::vector<CellKey> left;
  std::set_union(keys.begin(), keys.end(), stay_.begin(), stay_.end(), std::back_inserter(left));
  stay_.clear();
  for (int round = 0; !left.empty() && round < MostRounds; ++round)
  {
    left = removeSome(left);
  }
  return removed_;
}

RefusedCells::Candidate RefusedCells::candidate(CellKey key) const
{
  return { cells_.share(key), key };
}

bool RefusedCells::mayGo(const Candidate& candidate) const
{
  return cells_.hasFaces(candidate.key) && cells_.isFree(candidate.key) &&
    cells_.isAtBoundary(candidate.key) &&
    candidate.volume < ratioOf(small_, cells_.mainBoundary(candidate.key), largest_);
}

// For each refused face of a cell, finds the smaller of its two cells that may go.
void RefusedCells::lookAt(CellKey key, MeasuredCell& cell, std::set<Candidate>& candidates)
{
  if (!cells_.isAlive(key) || cells_.isSurelyAccepted(key))
  {
    return;
  }
  cells_.lookAround(key, cell);
  if (cell.across.size() < LeastFaces && mayGo(candidate(key)))
  {
    candidates.insert(candidate(key));
    return;
  }
  for (std::size_t f = 0; f < cell.across.size(); ++f)
  {
    if (!isRefused(cell.shape, cell.measures, f, cell.beyond[f]) &&
      !isDoubtful(cell.shape, cell.measures, f))
    {
      continue;
    }
    const CellKey other = cell.across[f];
    Candidate smaller = candidate(key);
    Candidate larger = other == None ? smaller : candidate(other);
    if (larger < smaller)
    {
      std::swap(smaller, larger);
    }
    if (mayGo(smaller))
    {
      candidates.insert(smaller);
    }
    else if (mayGo(larger))
    {
      candidates.insert(larger);
    }
    else
    {
      stay_.insert(key);
    }
  }
}

// Returns the cells to look at again.
std::vector<CellKey> RefusedCells::removeSome(const std::vector<CellKey>& keys)
{
  std::set<Candidate> candidates;
  MeasuredCell cell;
  for (const CellKey key : keys)
  {
    execution_.poll();
    lookAt(key, cell, candidates);
  }
  std::set<CellKey> again;
  for (const Candidate& candidate : candidates)
  {
    // The removal of a neighbour may be enough.
    if (again.count(candidate.key) == 0)
    {
      for (const auto& [other, area] : cells_.neighbours(candidate.key))
      {
        if (cells_.hasFaces(other) && cells_.isFree(other))
        {
          again.insert(other);
        }
      }
      cells_.remove(candidate.key);
      removed_ += cells_.counts(candidate.key);
    }
  }
  return { again.begin(), again.end() };
}

}

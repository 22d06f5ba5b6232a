// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/SmallCells.h"

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// No faces are joined: no cosine is as large.
constexpr double NoAngle = 2;

// As many neighbours are tried, those that share most area.
constexpr std::size_t MostNeighbours = 6;

// Cells at fault do not grow beyond this part of their box.
constexpr double MostVolume = 2.5;

// Chains of small cells end sooner.
constexpr int MostRounds = 50;

// A cell that should become a part of another.
struct Candidate
{
  CellKey key;
  double volume;                   // as a part of its box
  bool small;                      // else it is at fault
  std::vector<CellKey> around;     // its neighbours, those that it shares most area with first
  std::vector<CellKey> neighbours; // of those, with which it may become one

  bool operator<(const Candidate& other) const
  {
    const auto a = static_cast<float>(volume); // equal but for rounding is equal
    const auto b = static_cast<float>(other.volume);
    return a != b ? a < b : key < other.key;
  }
};

// Cells that become one.
struct Merging
{
  std::vector<CellKey> keys; // the first takes the others in; none: nothing does
  CellView view;
  JoinedFaces joined;
};

// Whether two faces have the same nodes, and a cell is beyond one of them: nothing would be between.
// (Between two boundary faces CellComplex::merge leaves nothing.)
bool isFolded(const CellView& view)
{
  std::vector<std::uint32_t> nodes(view.shape.corners.begin(), view.shape.corners.end());
  const auto begin = [&](std::size_t f) { return nodes.begin() + view.shape.start[f]; };
  std::vector<std::size_t> faces(view.faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    faces[f] = f;
    std::sort(begin(f), begin(f + 1));
  }
  std::sort(faces.begin(), faces.end(), [&](std::size_t f, std::size_t g) {
    return std::lexicographical_compare(begin(f), begin(f + 1), begin(g), begin(g + 1));
  });
  return std::adjacent_find(faces.begin(), faces.end(), [&](std::size_t f, std::size_t g) {
    return std::equal(begin(f), begin(f + 1), begin(g), begin(g + 1)) &&
      (view.across[f] != None || view.across[g] != None);
  }) != faces.end();
}

class Merger
{
public:
  Merger(CellComplex& cells, double ratio, bool mend, double leastCosine, MergesTried& tried,
    Execution& execution)
    : cells_(cells)
    , ratio_(ratio)
    , mend_(mend)
    , leastCosine_(leastCosine)
    , tried_(tried)
    , execution_(execution)
  {
  }

  std::size_t run()
  {
    std::vector<CellKey> keys = cells_.polyhedra();
    for (int round = 0; !keys.empty() && round < MostRounds; ++round)
    {
      taken_.clear();
      again_.clear();
      findCandidates(keys);
      mergeGroups();
      mergeOneByOne();
      keys.assign(again_.begin(), again_.end());
      keys.erase(
        std::remove_if(keys.begin(), keys.end(), [&](CellKey key) { return !cells_.isAlive(key); }),
        keys.end());
    }
    return merged_;
  }

private:
  // Unless it may not merge with any neighbour.
  void addCandidate(CellKey key, double volume)
  {
    Candidate candidate{ key, volume, volume < ratio_, {}, {} };
    for (const auto& [other, area] : cells_.neighbours(key))
    {
      candidate.around.push_back(other);
      if (cells_.mayMerge({ key, other }))
      {
        candidate.neighbours.push_back(other);
      }
    }
    if (!candidate.neighbours.empty())
    {
      candidates_.push_back(std::move(candidate));
    }
  }

  void findCandidates(const std::vector<CellKey>& keys)
  {
    candidates_.clear();
    for (const CellKey key : keys)
    {
      execution_.poll();
      const double volume = cells_.share(key);
      if (volume < ratio_ || (mend_ && volume < MostVolume && cells_.isAtFault(key)))
      {
        addCandidate(key, volume);
      }
    }
    std::sort(candidates_.begin(), candidates_.end());
    small_.clear();
    for (const Candidate& candidate : candidates_)
    {
      execution_.poll();
      if (candidate.small)
      {
        small_.insert(candidate.key);
      }
      for (const CellKey other : candidate.around)
      {
        cells_.open(other);
      }
    }
  }

  // But for its faces towards the cells from `begin` to `end`.
  template <class Iterator>
  CellFaults alone(CellKey key, Iterator begin, Iterator end)
  {
    cells_.lookAround(key, cell_);
    counts_.clear();
    for (const CellKey other : cell_.across)
    {
      counts_.push_back(std::find(begin, end, other) == end ? 1 : 0);
    }
    return faultsOf(cell_.shape, cell_.measures, cell_.beyond, counts_);
  }

  CellFaults apart(const std::vector<CellKey>& keys)
  {
    CellFaults sum;
    for (auto key = keys.begin(); key != keys.end(); ++key)
    {
      sum += alone(*key, keys.begin(), key);
    }
    return sum;
  }

  CellFaults together(Merging& merging)
  {
    cells_.view(merging.keys, merging.view);
    cells_.lookBeyond(merging.keys.front(), merging.view);
    measure(merging.view.shape, shape_);
    merging.joined = joinFaces(merging.view, shape_, isThin(shape_) ? NoAngle : leastCosine_);
    if (merging.joined.groups.empty())
    {
      return faultsOf(merging.view.shape, shape_, merging.view.beyond);
    }
    std::vector<NeighbourCell> beyond;
    const Polyhedron joined = shapeOf(merging.view, merging.joined, beyond);
    measure(joined, shape_);
    return faultsOf(joined, shape_, beyond);
  }

  // Carries it out unless another has changed one of the cells or what is beyond: then later.
  void merge(const Merging& merging)
  {
    const auto taken = [&](CellKey key) { return taken_.count(key) > 0; };
    const std::vector<CellKey>& keys = merging.keys;
    if (std::any_of(keys.begin(), keys.end(), taken) ||
      std::any_of(merging.view.across.begin(), merging.view.across.end(), taken))
    {
      again_.insert(keys.begin() + 1, keys.end());
      return;
    }
    if (isFolded(merging.view) || cells_.hasFacesNear(keys.front(), merging.view, merging.joined))
    {
      return;
    }
    taken_.insert(keys.begin(), keys.end());
    for (const CellKey other : merging.view.across)
    {
      if (other != None)
      {
        taken_.insert(other);
      }
    }
    for (std::size_t i = 1; i < keys.size(); ++i)
    {
      merged_ += cells_.counts(keys[i]);
      cells_.merge(keys[i], keys.front());
    }
    cells_.join(keys.front(), merging.view, merging.joined);
    again_.insert(keys.front());
  }

  // Small cells side by side on one neighbour: each alone would leave a step there, all together
  // none.
  void mergeGroups()
  {
    std::map<CellKey, std::vector<CellKey>> byFirst;
    for (const Candidate& candidate : candidates_)
    {
      if (candidate.small)
      {
        byFirst[candidate.neighbours.front()].push_back(candidate.key);
      }
    }
    std::vector<Merging> groups;
    for (const auto& [into, group] : byFirst)
    {
      if (group.size() > 1 && small_.count(into) == 0)
      {
        groups.emplace_back();
        groups.back().keys.push_back(into);
        groups.back().keys.insert(groups.back().keys.end(), group.begin(), group.end());
      }
    }
    for (Merging& group : groups)
    {
      execution_.poll();
      if (!cells_.mayMerge(group.keys))
      {
        group.keys.clear();
        continue;
      }
      const CellFaults after = together(group);
      const CellFaults before = apart(group.keys);
      if (after.weight() > before.weight() || !after.isNoLessValidThan(before))
      {
        group.keys.clear();
      }
    }
    for (const Merging& group : groups)
    {
      execution_.poll();
      if (!group.keys.empty())
      {
        merge(group);
      }
    }
    candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(),
                        [&](const Candidate& candidate) { return !cells_.isAlive(candidate.key); }),
      candidates_.end());
  }

  // The neighbour with which least is at fault.
  void choose(const Candidate& candidate, Merging& merging)
  {
    const CellKey* const none = nullptr;
    const CellFaults own = alone(candidate.key, none, none);
    int best = 0; // change of weight
    Merging& trial = trial_;
    const auto most = std::min(candidate.neighbours.size(), MostNeighbours);
    for (std::size_t i = 0; i < most; ++i)
    {
      const CellKey other = candidate.neighbours[i];
      const bool first = candidate.small && merging.keys.empty();
      trial.keys = { other, candidate.key };
      CellFaults before = alone(other, trial.keys.begin() + 1, trial.keys.end());
      before += own;
      if (before.weight() < (first ? 0 : 1) - best) // at best nothing is left of it
      {
        continue;
      }
      const CellFaults after = together(trial);
      const int change = after.weight() - before.weight();
      if (after.isNoLessValidThan(before) && (change < best || (first && change == 0)))
      {
        best = change;
        std::swap(merging, trial);
      }
    }
  }

  bool wasInVain(CellKey key) const
  {
    const auto found = tried_.inVain.find(key);
    return found != tried_.inVain.end() && !cells_.hasChangedNear(key, found->second);
  }

  void mergeOneByOne()
  {
    std::vector<Merging> mergings(candidates_.size());
    const std::uint32_t now = cells_.mark();
    for (std::size_t i = 0; i < candidates_.size(); ++i)
    {
      execution_.poll();
      // What a group has changed comes later.
      if (taken_.count(candidates_[i].key) == 0 && !wasInVain(candidates_[i].key))
      {
        choose(candidates_[i], mergings[i]);
        if (mergings[i].keys.empty())
        {
          tried_.inVain[candidates_[i].key] = now;
        }
      }
    }
    for (std::size_t i = 0; i < mergings.size(); ++i)
    {
      execution_.poll();
      if (taken_.count(candidates_[i].key) > 0)
      {
        again_.insert(candidates_[i].key);
      }
      else if (!mergings[i].keys.empty())
      {
        merge(mergings[i]);
      }
    }
  }

  CellComplex& cells_;
  double ratio_;
  bool mend_;
  double leastCosine_;
  MergesTried& tried_;
  Execution& execution_;
  std::vector<Candidate> candidates_; // the smallest first
  std::set<CellKey> small_;           // of the candidates
  std::set<CellKey> taken_;           // in this round: changed, or next to it
  std::set<CellKey> again_;           // to be looked at in the next round
  std::size_t merged_ = 0;

  // Of the trial at hand, kept for their memory:
  Merging trial_;
  MeasuredCell cell_;
  CellShape shape_;
  std::vector<std::uint8_t> counts_;
};

}

std::size_t mergeSmallCells(CellComplex& cells, double ratio, bool mend, double leastCosine,
  MergesTried& tried, Execution& execution)
{
  return Merger(cells, ratio, mend, leastCosine, tried, execution).run();
}

}

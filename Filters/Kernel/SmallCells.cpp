#include "SmallCells.h"

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 64;

// Chains of small cells end sooner.
constexpr int MostRounds = 50;

// A cell that should become a part of another.
struct Candidate
{
  CellKey key = None;
  double volume = 0;    // as a part of its box
  bool small = false;   // else it fails an angle condition
  CellKey first = None; // the neighbour that it shares most area with
  CellKey into = None;  // the best that it fits, or None

  bool operator<(const Candidate& other) const
  {
    const auto a = static_cast<float>(volume); // equal but for rounding is equal
    const auto b = static_cast<float>(other.volume);
    return a != b ? a < b : key < other.key;
  }
};

class Merger
{
public:
  Merger(CellComplex& cells, double ratio, double leastCosine, Demand demand, Execution& execution)
    : cells_(cells)
    , ratio_(ratio)
    , leastCosine_(leastCosine)
    , demand_(demand)
    , execution_(execution)
  {
  }

  std::size_t run()
  {
    std::vector<CellKey> keys = cells_.polyhedra();
    for (int round = 0; !keys.empty() && round < MostRounds; ++round)
    {
      findCandidates(keys);
      touched_.clear();
      mergeGroups();
      mergeOneByOne();
      keys.assign(touched_.begin(), touched_.end());
      keys.erase(
        std::remove_if(keys.begin(), keys.end(), [&](CellKey key) { return !cells_.isAlive(key); }),
        keys.end());
    }
    for (const CellKey key : grown_)
    {
      if (cells_.isAlive(key))
      {
        cells_.joinFaces(key, leastCosine_);
      }
    }
    return merged_;
  }

private:
  double failing(const std::vector<CellKey>& together) const
  {
    Polyhedron polyhedron;
    CellShape shape;
    cells_.shapeTogether(together, polyhedron);
    measure(polyhedron, shape);
    return unfitArea(polyhedron, shape, demand_);
  }

  void findCandidates(const std::vector<CellKey>& keys)
  {
    std::vector<Candidate> all(keys.size());
    execution_.forEach(keys.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      Polyhedron polyhedron;
      CellShape shape;
      for (std::size_t i = begin; i < end; ++i)
      {
        cells_.shape(keys[i], polyhedron);
        measure(polyhedron, shape);
        const double volume = shape.volume / cells_.volumeOfBox(keys[i]);
        const bool small = volume < ratio_;
        if (small || unfitArea(polyhedron, shape, demand_) > 0)
        {
          all[i].key = keys[i];
          all[i].volume = volume;
          all[i].small = small;
          const auto neighbours = cells_.neighbours(keys[i]);
          all[i].first = neighbours.empty() ? None : neighbours.front().first;
        }
      }
    });
    all.erase(std::remove_if(all.begin(), all.end(),
                [](const Candidate& candidate) { return candidate.first == None; }),
      all.end());
    std::sort(all.begin(), all.end());
    candidates_ = std::move(all);
    for (const Candidate& candidate : candidates_)
    {
      for (const auto& [other, area] : cells_.neighbours(candidate.key))
      {
        cells_.open(other);
      }
    }
  }

  void merge(CellKey small, CellKey into)
  {
    cells_.merge(small, into);
    touched_.insert(into);
    grown_.insert(into);
    ++merged_;
  }

  // Small cells side by side on one neighbour: each alone would leave a step there, all together
  // none.
  void mergeGroups()
  {
    std::map<CellKey, std::vector<CellKey>> groups;
    std::set<CellKey> small;
    for (const Candidate& candidate : candidates_)
    {
      if (candidate.small)
      {
        groups[candidate.first].push_back(candidate.key);
        small.insert(candidate.key);
      }
    }
    for (const auto& [into, group] : groups)
    {
      if (group.size() < 2 || small.count(into))
      {
        continue;
      }
      double apart = failing({ into });
      for (const CellKey key : group)
      {
        apart += failing({ key });
      }
      std::vector<CellKey> together{ into };
      together.insert(together.end(), group.begin(), group.end());
      if (failing(together) > apart)
      {
        continue;
      }
      for (const CellKey key : group)
      {
        merge(key, into);
      }
    }
    candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(),
                        [&](const Candidate& candidate) { return !cells_.isAlive(candidate.key); }),
      candidates_.end());
  }

  // The neighbour that it shares most area with of those that it fits, or None.
  CellKey choose(const Candidate& candidate) const
  {
    const double alone = failing({ candidate.key });
    for (const auto& [other, area] : cells_.neighbours(candidate.key))
    {
      const double together = failing({ other, candidate.key });
      const double apart = alone + failing({ other });
      if (together == 0 || (candidate.small ? together <= apart : together < apart))
      {
        return other;
      }
    }
    return None;
  }

  void mergeOneByOne()
  {
    execution_.forEach(candidates_.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        candidates_[i].into = choose(candidates_[i]);
      }
    });
    std::set<CellKey> taken;
    for (const Candidate& candidate : candidates_)
    {
      if (candidate.into == None)
      {
        continue;
      }
      if (taken.count(candidate.key) || taken.count(candidate.into))
      {
        touched_.insert(candidate.key);
        continue;
      }
      taken.insert({ candidate.key, candidate.into });
      merge(candidate.key, candidate.into);
    }
  }

  CellComplex& cells_;
  double ratio_;
  double leastCosine_;
  Demand demand_;
  Execution& execution_;
  std::vector<Candidate> candidates_; // the smallest first
  std::set<CellKey> touched_;         // to be looked at again
  std::set<CellKey> grown_;
  std::size_t merged_ = 0;
};

}

std::size_t mergeSmallCells(
  CellComplex& cells, double ratio, double leastCosine, Demand demand, Execution& execution)
{
  return Merger(cells, ratio, leastCosine, demand, execution).run();
}

}

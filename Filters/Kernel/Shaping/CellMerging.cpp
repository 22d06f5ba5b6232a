// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellMerging.h"

#include "Polyhedra/CellCost.h"

#include <algorithm>
#include <map>

namespace cartesian
{

namespace
{

// One merge may make another possible next to it: looked at again as often.
constexpr int MostRounds = 4;

// As many neighbours are tried, those that share most area.
constexpr std::size_t MostNeighbours = 8;
constexpr std::size_t MostNeighboursOfSmall = 3;

// The sum of costs has to fall by more than rounding.
constexpr double LeastGain = 1e-6;

// ... of a merge that nothing but costs asks for.
constexpr double LeastGainOfPoor = 0.3;

// No face gets a larger cost than this by a merge, unless it had one: an angle of section 3 failed.
constexpr double MostCost = 1e3;

// Where no face of the result costs more, no other neighbour is tried.
constexpr double FairCost = 1;

// Cells of a fine box that are smaller than this part of a neighbour join it in groups, up to this share of
// their box.
constexpr double LeastVolumeRatio = 0.06;
constexpr double LargestOfGroup = 0.6;

// No cell grows beyond this part of its box.
constexpr double MostShare = 2.5;

struct Candidate
{
  CellKey key;
  float rank; // the lowest first; equal but for rounding is equal

  bool operator<(const Candidate& other) const
  {
    return rank != other.rank ? rank < other.rank : key < other.key;
  }
};

// Cells as one: the first takes the others in.
struct Union
{
  std::vector<CellKey> keys;
  CellView view;
  JoinedFaces joined;
  double gain = 0;  // by how much the sum of costs falls
  double worst = 0; // cost of a face
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
  Merger(CellComplex& cells, const MergeSpec& spec, Execution& execution)
    : cells_(cells)
    , spec_(spec)
    , execution_(execution)
  {
  }

  std::size_t mergeSmall()
  {
    return run(cells_.polyhedra(), MostNeighboursOfSmall, [&](CellKey key) {
      const double share = cells_.share(key);
      return std::make_pair(share < spec_.ratio, share);
    });
  }

  // Small cells side by side on one neighbour, or cells of a fine box each on one of a coarse box: each alone
  // would leave a step there, all together none.
  std::size_t mergeGroups()
  {
    std::map<CellKey, std::vector<CellKey>> byLargest;
    for (const CellKey key : cells_.polyhedra())
    {
      execution_.poll();
      if (cells_.share(key) < LargestOfGroup && (isSmall(key) || mayBeOfFineBox(key)))
      {
        const auto neighbours = cells_.neighbours(key);
        const CellKey into = neighbours.empty() ? None : neighbours.front().first;
        if (into != None && !isSmall(into) && (isSmall(key) || isFineNextTo(key, into)))
        {
          byLargest[into].push_back(key);
        }
      }
    }
    for (const auto& [into, group] : byLargest)
    {
      execution_.poll();
      trial_.keys.assign(1, into);
      trial_.keys.insert(trial_.keys.end(), group.begin(), group.end());
      if (group.size() > 1 && cells_.mayMerge(trial_.keys))
      {
        mergeGroup();
      }
    }
    return merged_;
  }

  std::size_t mergeFailing()
  {
    return run(cells_.polyhedraAtFault(), MostNeighbours, [&](CellKey key) {
      const double share = cells_.share(key);
      return std::make_pair(share < MostShare && cells_.isAtFault(key), share);
    });
  }

  std::size_t mergePoor()
  {
    leastGain_ = LeastGainOfPoor;
    return run(cells_.polyhedra(), MostNeighbours, [&](CellKey key) {
      const double worst = cells_.isSurelyGood(key) ? 0 : worstCost(key);
      return std::make_pair(worst > PoorCost, -worst);
    });
  }

private:
  // look(key): whether it is a candidate, and its rank.
  template <class Look>
  std::size_t run(std::vector<CellKey> keys, std::size_t mostNeighbours, Look&& look)
  {
    for (int round = 0; round < MostRounds && !keys.empty(); ++round)
    {
      const std::uint32_t mark = cells_.mark();
      const std::vector<Candidate> candidates = list(keys, look);
      for (const Candidate& candidate : candidates)
      {
        execution_.poll();
        if (cells_.isAlive(candidate.key) && look(candidate.key).first)
        {
          mergeBest(candidate.key, mostNeighbours);
        }
      }
      keys = cells_.polyhedraChangedSince(mark);
    }
    return merged_;
  }

  template <class Look>
  std::vector<Candidate> list(const std::vector<CellKey>& keys, Look&& look)
  {
    std::vector<Candidate> candidates;
    for (const CellKey key : keys)
    {
      execution_.poll();
      if (const auto [is, rank] = look(key); is)
      {
        candidates.push_back({ key, static_cast<float>(rank) });
      }
    }
    std::sort(candidates.begin(), candidates.end());
    return candidates;
  }

  double worstCost(CellKey key)
  {
    cells_.lookAround(key, cell_);
    double worst = 0;
    costOfFaces(cell_.shape, cell_.measures, cell_.beyond, {}, worst);
    return worst;
  }

  // But for its faces towards the cells from `begin` to `end`.
  template <class Iterator>
  double costOf(CellKey key, Iterator begin, Iterator end, double& worst)
  {
    cells_.lookAround(key, cell_);
    counts_.clear();
    for (const CellKey other : cell_.across)
    {
      counts_.push_back(std::find(begin, end, other) == end ? 1 : 0);
    }
    double worstOfAll = 0;
    const double faces =
      costOfFaces(cell_.shape, cell_.measures, cell_.beyond, counts_, worstOfAll);
    worst = std::max(worst, worstOfAll);
    return faces + costOfShare(cells_.share(key));
  }

  double costTogether(Union& both)
  {
    const CellKey into = both.keys[0];
    cells_.view(both.keys, both.view);
    cells_.lookBeyond(into, both.view);
    measure(both.view.shape, shape_);
    both.joined = joinFaces(both.view, shape_, spec_.joins);
    std::vector<NeighbourCell> beyond;
    const Polyhedron joined = shapeOf(both.view, both.joined, beyond);
    if (joined.faces() < LeastFaces)
    {
      return Never;
    }
    measure(joined, shape_);
    const double faces = costOfFaces(joined, shape_, beyond, {}, both.worst);
    return faces + costOfShare(shape_.volume / cells_.volumeOfBox(into));
  }

  bool isFineNextTo(CellKey key, CellKey other) const
  {
    return cells_.volume(key) < LeastVolumeRatio * cells_.volume(other);
  }

  // Before its neighbours are measured.
  bool mayBeOfFineBox(CellKey key) const
  {
    return cells_.anyBeyond(key, [&](CellKey other) { return isFineNextTo(key, other); });
  }

  bool isSmall(CellKey key) const { return cells_.share(key) < spec_.ratio; }

  // The cells of the trial at hand, if that is better than each alone.
  void mergeGroup()
  {
    cells_.open(trial_.keys.front());
    double worst = 0;
    double before = 0;
    for (auto key = trial_.keys.begin(); key != trial_.keys.end(); ++key)
    {
      before += costOf(*key, trial_.keys.begin(), key, worst);
    }
    if (before - costTogether(trial_) > LeastGain && isAllowed(trial_, worst))
    {
      merge(trial_);
    }
  }

  void mergeBest(CellKey key, std::size_t mostNeighbours)
  {
    double ownWorst = 0;
    const CellKey* const none = nullptr;
    const double own = costOf(key, none, none, ownWorst);
    const double share = cells_.share(key);
    Union best;
    std::size_t tried = 0;
    for (const auto& [other, area] : cells_.neighbours(key))
    {
      if (tried == mostNeighbours)
      {
        break;
      }
      if (!cells_.mayMerge({ key, other }) || share + cells_.share(other) > MostShare)
      {
        continue;
      }
      ++tried;
      cells_.open(other); // a hexahedron has no faces of its own
      const bool grows = cells_.volume(key) > cells_.volume(other);
      trial_.keys = { grows ? key : other, grows ? other : key };
      double worst = ownWorst;
      const double before = own + costOf(other, &key, &key + 1, worst);
      trial_.gain = before - costTogether(trial_);
      if (trial_.gain > leastGain_ && isBetter(trial_, best) && isAllowed(trial_, worst))
      {
        std::swap(best, trial_);
        if (best.worst < FairCost)
        {
          break;
        }
      }
    }
    if (!best.keys.empty())
    {
      merge(best);
    }
  }

  // One in which no angle fails is better than one that gains more.
  static bool isBetter(const Union& a, const Union& b)
  {
    const bool fails = a.worst >= MostCost;
    const bool otherFails = b.worst >= MostCost;
    // Equal but for rounding is equal: sums depend on the order of the surface's triangles.
    const bool gainsMore = static_cast<float>(a.gain) > static_cast<float>(b.gain);
    return b.keys.empty() || (fails != otherFails ? otherFails : gainsMore);
  }

  // `worst`: the largest cost of a face before.
  bool isAllowed(const Union& merged, double worst) const
  {
    return merged.worst < std::max(worst, MostCost) && !isFolded(merged.view) &&
      !cells_.hasFacesNear(merged.keys[0], merged.view, merged.joined);
  }

  void merge(const Union& merged)
  {
    for (const CellKey other : merged.view.across)
    {
      if (other != None)
      {
        cells_.open(other);
      }
    }
    for (std::size_t i = 1; i < merged.keys.size(); ++i)
    {
      merged_ += cells_.counts(merged.keys[i]);
      cells_.merge(merged.keys[i], merged.keys.front());
    }
    cells_.join(merged.keys.front(), merged.view, merged.joined);
  }

  static constexpr double Never = 1e30;

  CellComplex& cells_;
  const MergeSpec& spec_;
  Execution& execution_;
  std::size_t merged_ = 0;
  double leastGain_ = LeastGain;

  // Of the trial at hand, kept for their memory:
  Union trial_;
  MeasuredCell cell_;
  CellShape shape_;
  std::vector<std::uint8_t> counts_;
};

}

std::size_t mergeSmallCells(CellComplex& cells, const MergeSpec& spec, Execution& execution)
{
  const std::size_t inGroups = Merger(cells, spec, execution).mergeGroups();
  return inGroups + Merger(cells, spec, execution).mergeSmall();
}

std::size_t mergeFailingCells(CellComplex& cells, const MergeSpec& spec, Execution& execution)
{
  return Merger(cells, spec, execution).mergeFailing();
}

std::size_t mergePoorCells(CellComplex& cells, const MergeSpec& spec, Execution& execution)
{
  return Merger(cells, spec, execution).mergePoor();
}

}

#include "CellSplitting.h"

#include "CutSearch.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 16;

// A part smaller than this part of the cell is no use.
constexpr double LeastPart = 1e-3;

// Ends a search that never came to rest; a cell is cut some ten times at most.
constexpr int MostRounds = 100;

struct Proposal
{
  CellKey key;
  double area = 0; // of the faces at fault
  CellView view;
  std::vector<CellCut> cuts; // the fittest last
};

// The parts' fitness, or nothing where one is smaller than `least`.
std::optional<Fitness> fitnessAfter(const CellView& view, const CellCut& cut, double least)
{
  std::vector<Polyhedron> parts;
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
  Fitness sum;
  std::vector<Beyond> beyond;
  std::vector<std::uint8_t> counts;
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
        beyond.push_back(inner ? Beyond{ other.centre, other.volume } : view.beyond[face.source]);
        counts.push_back(face.below == p ? 1 : 0);
      }
    }
    sum += fitnessOf(parts[p], shapes[p], beyond, counts);
  }
  return sum;
}

void propose(const CellComplex& cells, double leastFraction, Proposal& proposal)
{
  cells.view({ proposal.key }, proposal.view);
  cells.lookBeyond(proposal.key, proposal.view);
  CellShape shape;
  measure(proposal.view.shape, shape);
  const Fitness before = fitnessOf(proposal.view.shape, shape, proposal.view.beyond);
  const double least =
    std::max(LeastPart * shape.volume, leastFraction * cells.volumeOfBox(proposal.key));
  FoundCuts found = searchCuts(proposal.view, shape, before,
    [&](const CellCut& cut) { return fitnessAfter(proposal.view, cut, least); });
  proposal.area = before.area;
  proposal.cuts = std::move(found.helpful);
  // Without concave edges nothing of the boundary fails.
  if (proposal.cuts.empty() && found.harmless && before.faults[Fitness::BoundaryAngle] > 0)
  {
    proposal.cuts.push_back(std::move(*found.harmless));
  }
}

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
      std::vector<Proposal> proposals = propose(failing);
      taken_.clear();
      next_.clear();
      for (const Proposal& proposal : proposals)
      {
        execution_.poll();
        carryOut(proposal);
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
  // Those with most at fault first.
  std::vector<Proposal> propose(const std::vector<CellKey>& failing) const
  {
    std::vector<Proposal> proposals(failing.size());
    execution_.forEach(failing.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        proposals[i].key = failing[i];
        cartesian::propose(cells_, leastFraction_, proposals[i]);
      }
    });
    std::sort(proposals.begin(), proposals.end(), [](const Proposal& x, const Proposal& y) {
      const auto a = static_cast<float>(x.area);
      const auto b = static_cast<float>(y.area);
      return a != b ? a > b : x.key < y.key;
    });
    return proposals;
  }

  bool isTaken(CellKey key) const { return taken_.count(key) > 0; }

  // The fittest cut that spoils no cell beyond; in the next round, if another cut has changed one.
  void carryOut(const Proposal& proposal)
  {
    cells_.open(proposal.key);
    for (auto cut = proposal.cuts.rbegin(); cut != proposal.cuts.rend(); ++cut)
    {
      const std::vector<CellKey> touched = cells_.touchedBy(proposal.key, proposal.view, *cut);
      if (std::any_of(touched.begin(), touched.end(), [&](CellKey k) { return isTaken(k); }))
      {
        next_.insert(proposal.key);
        return;
      }
      if (cells_.allows(touched, proposal.view, *cut))
      {
        taken_.insert(touched.begin(), touched.end());
        next_.insert(touched.begin(), touched.end());
        result_.cellsSplit += cells_.counts(proposal.key);
        std::vector<CellKey> parts;
        cells_.cut(proposal.key, proposal.view, *cut, parts);
        next_.insert(parts.begin(), parts.end());
        return;
      }
    }
    failed_.insert(proposal.key);
  }

  CellComplex& cells_;
  double leastFraction_;
  Execution& execution_;
  Splitting result_;
  std::set<CellKey> failed_;
  std::set<CellKey> taken_; // changed in this round
  std::set<CellKey> next_;  // to be looked at in the next
};

}

Splitting splitCells(
  CellComplex& cells, std::vector<CellKey> failing, double leastFraction, Execution& execution)
{
  return Splitter(cells, leastFraction, execution).run(std::move(failing));
}

}

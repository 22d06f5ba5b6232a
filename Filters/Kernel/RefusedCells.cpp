#include "RefusedCells.h"

#include <algorithm>
#include <set>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 256;

// Each round exposes faces of the cells next to those removed, which are seldom at fault.
constexpr int MostRounds = 10;

class Remover
{
public:
  Remover(CellComplex& cells, const CellSpec& spec, double largest, Execution& execution)
    : cells_(cells)
    , spec_(spec)
    , largest_(largest)
    , execution_(execution)
  {
  }

  std::size_t run()
  {
    std::vector<CellKey> keys = cells_.polyhedra();
    for (int round = 0; !keys.empty() && round < MostRounds; ++round)
    {
      keys = removeSome(keys);
    }
    return removed_;
  }

private:
  struct Candidate
  {
    double volume; // as a part of its box
    CellKey key;

    bool operator<(const Candidate& other) const
    {
      const auto a = static_cast<float>(volume); // equal but for rounding is equal
      const auto b = static_cast<float>(other.volume);
      return a != b ? a < b : key < other.key;
    }
  };

  Candidate candidate(CellKey key) const
  {
    return { cells_.volume(key) / cells_.volumeOfBox(key), key };
  }

  // Those to blame for the faces of a cell.
  void findCandidates(CellKey key, MeasuredCell& cell, std::vector<Candidate>& found) const
  {
    cells_.lookAround(key, cell);
    for (std::size_t f = 0; f < cell.across.size(); ++f)
    {
      if (isRefused(cell.shape, cell.measures, f, cell.beyond[f]))
      {
        const CellKey other = cell.across[f];
        const Candidate own = candidate(key);
        found.push_back(other == None ? own : std::min(own, candidate(other)));
      }
    }
  }

  bool mayGo(const Candidate& candidate) const
  {
    const std::int32_t boundary = cells_.mainBoundary(candidate.key);
    return boundary != NoBoundary && candidate.volume < ratioOf(spec_, boundary, largest_);
  }

  // Returns the cells to look at again.
  std::vector<CellKey> removeSome(const std::vector<CellKey>& keys)
  {
    std::vector<std::vector<Candidate>> parts(chunks(keys.size(), CellsAChunk));
    execution_.forEach(keys.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      MeasuredCell cell;
      for (std::size_t i = begin; i < end; ++i)
      {
        findCandidates(keys[i], cell, parts[begin / CellsAChunk]);
      }
    });
    std::set<Candidate> candidates;
    for (const std::vector<Candidate>& part : parts)
    {
      candidates.insert(part.begin(), part.end());
    }
    std::set<CellKey> again;
    for (const Candidate& candidate : candidates)
    {
      // The removal of a neighbour may be enough.
      if (again.count(candidate.key) == 0 && mayGo(candidate))
      {
        for (const auto& [other, area] : cells_.neighbours(candidate.key))
        {
          if (cells_.hasFaces(other))
          {
            again.insert(other);
          }
        }
        cells_.remove(candidate.key);
        ++removed_;
      }
    }
    return { again.begin(), again.end() };
  }

  CellComplex& cells_;
  const CellSpec& spec_;
  double largest_;
  Execution& execution_;
  std::size_t removed_ = 0;
};

}

std::size_t removeRefusedCells(
  CellComplex& cells, const CellSpec& spec, double largest, Execution& execution)
{
  return Remover(cells, spec, largest, execution).run();
}

}

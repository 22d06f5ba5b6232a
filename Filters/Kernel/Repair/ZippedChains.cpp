// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/ZippedChains.h"

#include "Surface/Places.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// The part of the area of a square over an edge across that counts as area: below what matters, above the rounding of sums.
constexpr double AcrossCounts = 1e-9;

class Zipper
{
public:
  Zipper(const Surface& surface, const ChainPair& chains)
    : surface_(surface)
    , first_(chains.first)
    , second_(chains.second)
    , rows_(first_.size())
  {
    findBand(chains.steps);
    for (std::size_t p = 0; p < rows_.size(); ++p)
    {
      fillRow(p);
    }
  }

  std::vector<std::array<std::uint32_t, 3>> triangles() const
  {
    std::vector<std::array<std::uint32_t, 3>> result;
    std::size_t p = first_.size() - 1;
    std::size_t q = second_.size() - 1;
    if (costAt(p, q) == HUGE_VAL)
    {
      return {};
    }
    while (p + q > 0)
    {
      const bool isAlongFirst = rows_[p].isAlongFirst[q - rows_[p].low];
      result.push_back(isAlongFirst ? alongFirst(p, q) : alongSecond(p, q));
      (isAlongFirst ? p : q) -= 1;
    }
    std::reverse(result.begin(), result.end());
    return result;
  }

private:
  // The vertices of the second chain that one of the first may be joined with.
  struct Row
  {
    std::size_t low = 0;
    std::size_t high = 0;
    std::vector<double> cost; // least, of all triangles before, levels squared
    std::vector<bool> isAlongFirst;
  };

  // Those next to what the way passes at the vertex itself or its neighbours.
  void findBand(const std::vector<bool>& steps)
  {
    std::vector<std::array<std::size_t, 2>> passed{ { 0, 0 } };
    for (const bool isFirst : steps)
    {
      const std::size_t at = passed.back()[1];
      if (isFirst)
      {
        passed.push_back({ at, at });
      }
      else
      {
        passed.back()[1] = at + 1;
      }
    }
    for (std::size_t p = 0; p < rows_.size(); ++p)
    {
      const auto [low, high] = passed[p];
      rows_[p].low = std::min(passed[p > 0 ? p - 1 : 0][0], low > 0 ? low - 1 : 0);
      rows_[p].high = std::max(
        passed[std::min(p + 1, passed.size() - 1)][1], std::min(high + 1, second_.size() - 1));
    }
  }

  void fillRow(std::size_t p)
  {
    Row& row = rows_[p];
    for (std::size_t q = row.low; q <= row.high; ++q)
    {
      const double before =
        p > 0 ? costAt(p - 1, q) + areaOf(surface_, alongFirst(p, q)) : HUGE_VAL;
      const double below =
        q > row.low ? row.cost.back() + areaOf(surface_, alongSecond(p, q)) : HUGE_VAL;
      const Vector across = minus(surface_.vertices[second_[q]], surface_.vertices[first_[p]]);
      const double least = p + q > 0 ? std::min(before, below) : 0;
      row.isAlongFirst.push_back(before <= below);
      row.cost.push_back(
        first_[p] != second_[q] ? least + AcrossCounts * dot(across, across) : HUGE_VAL);
    }
  }

  double costAt(std::size_t p, std::size_t q) const
  {
    const Row& row = rows_[p];
    return q >= row.low && q <= row.high ? row.cost[q - row.low] : HUGE_VAL;
  }

  std::array<std::uint32_t, 3> alongFirst(std::size_t p, std::size_t q) const
  {
    return { first_[p - 1], first_[p], second_[q] };
  }
  std::array<std::uint32_t, 3> alongSecond(std::size_t p, std::size_t q) const
  {
    return { first_[p], second_[q], second_[q - 1] };
  }

  const Surface& surface_;
  const std::vector<std::uint32_t>& first_;
  const std::vector<std::uint32_t>& second_;
  std::vector<Row> rows_; // of each vertex of the first chain
};

}

std::vector<std::array<std::uint32_t, 3>> zipped(const Surface& surface, const ChainPair& chains)
{
  return Zipper(surface, chains).triangles();
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/GlobalBoxSet.h"

#include <algorithm>

namespace cartesian
{

GlobalBoxSet::GlobalBoxSet(
  std::int64_t boxesAlongX, std::int64_t rowsAlongY, std::int64_t rowsAlongZ)
  : boxesAlongX_(boxesAlongX)
  , rowsAlongY_(rowsAlongY)
  , rowsAlongZ_(rowsAlongZ)
  , rows_(static_cast<std::size_t>(rowsAlongY * rowsAlongZ))
{
}

void GlobalBoxSet::insert(std::int64_t i, std::int64_t j, std::int64_t k)
{
  Row& row = rows_[static_cast<std::size_t>(j + k * rowsAlongY_)];
  if (!row.empty() && row.back().end == i)
  {
    ++row.back().end;
  }
  else
  {
    row.push_back({ i, i + 1 });
  }
}

bool GlobalBoxSet::contains(std::int64_t i, std::int64_t j, std::int64_t k) const
{
  const Row& row = rows_[static_cast<std::size_t>(j + k * rowsAlongY_)];
  const auto after = std::upper_bound(
    row.begin(), row.end(), i, [](std::int64_t x, const Run& run) { return x < run.begin; });
  return after != row.begin() && i < (after - 1)->end;
}

GlobalBoxSet GlobalBoxSet::grown(std::int64_t layers) const
{
  return grownAlongX(layers).grownAcross(layers, false).grownAcross(layers, true);
}

void GlobalBoxSet::unite(std::vector<Run>& runs)
{
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.begin < b.begin; });
  std::size_t size = 0;
  for (const Run& run : runs)
  {
    if (size > 0 && run.begin <= runs[size - 1].end)
    {
      runs[size - 1].end = std::max(runs[size - 1].end, run.end);
    }
    else
    {
      runs[size++] = run;
    }
  }
  runs.resize(size);
}

GlobalBoxSet GlobalBoxSet::grownAlongX(std::int64_t layers) const
{
  GlobalBoxSet result = *this;
  for (Row& row : result.rows_)
  {
    for (Run& run : row)
    {
      run.begin = std::max<std::int64_t>(0, run.begin - layers);
      run.end = std::min(boxesAlongX_, run.end + layers);
    }
    unite(row);
  }
  return result;
}

GlobalBoxSet GlobalBoxSet::grownAcross(std::int64_t layers, bool alongZ) const
{
  GlobalBoxSet result(boxesAlongX_, rowsAlongY_, rowsAlongZ_);
  for (std::int64_t k = 0; k < rowsAlongZ_; ++k)
  {
    for (std::int64_t j = 0; j < rowsAlongY_; ++j)
    {
      Row& row = result.rows_[static_cast<std::size_t>(j + k * rowsAlongY_)];
      const std::int64_t at = alongZ ? k : j;
      const std::int64_t last = (alongZ ? rowsAlongZ_ : rowsAlongY_) - 1;
      for (std::int64_t n = std::max<std::int64_t>(0, at - layers);
           n <= std::min(last, at + layers); ++n)
      {
        const Row& other =
          rows_[static_cast<std::size_t>(alongZ ? j + n * rowsAlongY_ : n + k * rowsAlongY_)];
        row.insert(row.end(), other.begin(), other.end());
      }
      unite(row);
    }
  }
  return result;
}

}

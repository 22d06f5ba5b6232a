// SPDX-License-Identifier: BSD-3-Clause
// A set of global boxes, run-length encoded along x: small if they are contiguous.
#pragma once

#include <cstdint>
#include <vector>

namespace cartesian
{

class GlobalBoxSet
{
public:
  // Empty, in a grid of `rowsAlongY` times `rowsAlongZ` rows of `boxesAlongX` boxes.
  GlobalBoxSet(std::int64_t boxesAlongX, std::int64_t rowsAlongY, std::int64_t rowsAlongZ);

  // The boxes of a row must be inserted in order of i.
  void insert(std::int64_t i, std::int64_t j, std::int64_t k);

  bool contains(std::int64_t i, std::int64_t j, std::int64_t k) const;

  // All boxes at most `layers` boxes away from one of the set along x, y and z.
  GlobalBoxSet grown(std::int64_t layers) const;

private:
  struct Run
  {
    std::int64_t begin;
    std::int64_t end;
  };
  using Row = std::vector<Run>;

  static void unite(std::vector<Run>& runs);
  GlobalBoxSet grownAlongX(std::int64_t layers) const;
  GlobalBoxSet grownAcross(std::int64_t layers, bool alongZ) const;

  std::int64_t boxesAlongX_;
  std::int64_t rowsAlongY_;
  std::int64_t rowsAlongZ_;
  std::vector<Row> rows_;
};

}

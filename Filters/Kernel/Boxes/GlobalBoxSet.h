// SPDX-License-Identifier: BSD-3-Clause
// A set of global boxes as runs along x: small where boxes lie together.
#pragma once

#include <cstdint>
#include <vector>

namespace cartesian
{

class GlobalBoxSet
{
public:
  // For `rowsAlongY` times `rowsAlongZ` rows of `boxesAlongX` boxes.
  GlobalBoxSet(std::int64_t boxesAlongX, std::int64_t rowsAlongY, std::int64_t rowsAlongZ);

  // Boxes of a row are inserted in order of i.
  void insert(std::int64_t i, std::int64_t j, std::int64_t k);

  bool contains(std::int64_t i, std::int64_t j, std::int64_t k) const;

  // All boxes at most `layers` boxes away along x, y and z.
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

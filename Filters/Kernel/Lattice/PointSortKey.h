// SPDX-License-Identifier: BSD-3-Clause
// A point and its number packed into two words: sorts by position, then by number, several times as
// fast as a pair.
#pragma once

#include "Lattice/Lattice.h"

namespace cartesian
{

class PointSortKey
{
public:
  PointSortKey() = default;
  PointSortKey(const Point& p, std::uint32_t number)
    : xy_(std::uint64_t(p[0]) << 32 | p[1])
    , zAndNumber_(std::uint64_t(p[2]) << 32 | number)
  {
  }

  Point point() const
  {
    return { static_cast<Level>(xy_ >> 32), static_cast<Level>(xy_),
      static_cast<Level>(zAndNumber_ >> 32) };
  }
  std::uint32_t number() const { return static_cast<std::uint32_t>(zAndNumber_); }

  bool operator<(const PointSortKey& other) const
  {
    return xy_ != other.xy_ ? xy_ < other.xy_ : zAndNumber_ < other.zAndNumber_;
  }
  bool isAt(const PointSortKey& other) const
  {
    return xy_ == other.xy_ && zAndNumber_ >> 32 == other.zAndNumber_ >> 32;
  }

private:
  std::uint64_t xy_;
  std::uint64_t zAndNumber_;
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Zones that end at planes across the axes, as EditZones turns them.
#pragma once

#include "Lattice/Vector.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

// Divides cells by planes, again and again, so that all zones have about as many of a sample.
class ZoneDivision
{
public:
  ZoneDivision(std::vector<Vector> sample, std::size_t zones);

  std::uint32_t zoneOf(const Vector& place) const
  {
    std::size_t i = 0;
    while (planes_[i].zones > 1)
    {
      i = place[planes_[i].axis] < planes_[i].at ? i + 1 : planes_[i].above;
    }
    return static_cast<std::uint32_t>(planes_[i].first);
  }

private:
  struct Plane
  {
    std::size_t first; // zone
    std::size_t zones;
    std::size_t axis;
    double at;
    std::size_t above; // what follows on this side; on the other, the next
  };

  void divide(std::size_t begin, std::size_t end, std::size_t first, std::size_t zones);
  std::size_t longestAxis(std::size_t begin, std::size_t end) const;

  std::vector<Vector> sample_;
  std::vector<Plane> planes_;
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Which triangles are near a place, by a grid of cells.
#pragma once

#include "Lattice/NearestPlace.h"
#include "Surface/Surface.h"

#include <unordered_map>

namespace cartesian
{

class NearbyTriangles
{
public:
  // Of these triangles of the surface, which is borrowed, for places at most `reach` levels away.
  NearbyTriangles(
    const Surface& surface, const std::vector<std::uint32_t>& triangles, double reach);

  struct Nearest
  {
    std::uint32_t triangle = None;
    double distance = 0;
  };
  static constexpr std::uint32_t None = ~0u;

  // The nearest of those triangles that accept(triangle) accepts; of equally near ones the first. None: it is
  // further away than the reach.
  template <class Accept>
  Nearest find(const Vector& place, Accept&& accept) const
  {
    Nearest best{ None, reach_ };
    const auto cell = cells_.find(keyOf(cellOf(place)));
    for (std::size_t i = 0; cell != cells_.end() && i < cell->second.size(); ++i)
    {
      const std::uint32_t t = cell->second[i];
      const double distance = norm(minus(nearestPlace(surface_.corners(t), place), place));
      if ((distance < best.distance || (distance == best.distance && best.triangle == None)) &&
        accept(t))
      {
        best = { t, distance };
      }
    }
    return best;
  }

private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cellOf(const Vector& place) const;
  static std::int64_t keyOf(const Cell& cell);

  const Surface& surface_;
  double reach_;
  double size_; // of a cell
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells_;
};

}

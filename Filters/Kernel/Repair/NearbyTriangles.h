// SPDX-License-Identifier: BSD-3-Clause
// Which triangle is the nearest to a place.
#pragma once

#include "Lattice/NearestPlace.h"
#include "Repair/TriangleTree.h"

namespace cartesian
{

class NearbyTriangles
{
public:
  static constexpr std::uint32_t None = ~0u;

  struct Nearest
  {
    std::uint32_t triangle = None;
    double distance = 0;
  };

  // Of all triangles of the surface that have an area; it is borrowed.
  NearbyTriangles(const Surface& surface, Execution& execution)
    : surface_(surface)
    , tree_(surface, execution)
  {
  }

  // Of these triangles, for places at most `reach` levels away; on one thread.
  NearbyTriangles(const Surface& surface, const std::vector<std::uint32_t>& triangles, double reach)
    : surface_(surface)
    , tree_(treeOf(surface, triangles))
    , reach_(reach)
  {
  }

  // The nearest of those triangles that accept(triangle) accepts; of equally near ones the first. None: it is
  // further away than the reach.
  template <class Accept>
  Nearest find(const Vector& place, double reach, Accept&& accept) const
  {
    Nearest best{ None, reach };
    const Vector aside{ reach, reach, reach };
    tree_.forEachWithin(minus(place, aside), plus(place, aside), [&](std::uint32_t t) {
      const double distance = norm(minus(nearestPlace(surface_.corners(t), place), place));
      const bool isNearer =
        distance != best.distance ? distance < best.distance : t < best.triangle;
      best = isNearer && accept(t) ? Nearest{ t, distance } : best;
    });
    return best;
  }

  template <class Accept>
  Nearest find(const Vector& place, Accept&& accept) const
  {
    return find(place, reach_, accept);
  }

  // Whether one that accept(triangle) accepts is within the reach.
  template <class Accept>
  bool isAnyNear(const Vector& place, double reach, Accept&& accept) const
  {
    return find(place, reach, accept).triangle != None;
  }

private:
  static TriangleTree treeOf(const Surface& surface, const std::vector<std::uint32_t>& triangles)
  {
    Execution alone;
    return { surface, triangles, alone };
  }

  const Surface& surface_;
  TriangleTree tree_;
  double reach_ = 0;
};

}

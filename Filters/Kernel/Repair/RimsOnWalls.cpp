// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/RimsOnWalls.h"

#include "Repair/BaffleRims.h"
#include "Repair/ManifoldComponents.h"
#include "Repair/NearbyTriangles.h"
#include "Repair/OpenRims.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cartesian
{

namespace
{

// Walls may bend away from an edge of a rim by this part of its length.
constexpr double LargestSagitta = 0.25;

struct Extent
{
  Vector low{ HUGE_VAL, HUGE_VAL, HUGE_VAL };
  Vector high{ -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };

  void include(const Vector& place, double aside)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], place[axis] - aside);
      high[axis] = std::max(high[axis], place[axis] + aside);
    }
  }

  bool meets(const Corners& c) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto [least, most] = std::minmax({ c[0][axis], c[1][axis], c[2][axis] });
      if (double(most) < low[axis] || double(least) > high[axis])
      {
        return false;
      }
    }
    return true;
  }
};

class RimsOnWalls
{
public:
  RimsOnWalls(Surface& surface, double tolerance, Execution& execution)
    : surface_(surface)
    , tolerance_(tolerance)
    , execution_(execution)
  {
    const SurfaceEdges edges(surface, execution);
    const ManifoldComponents parts(surface, edges, execution);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    {
      partOf_[surface.given[t]] = parts.of(t);
    }
    for (const OpenEdge& edge : openEdgesOf(surface, execution))
    {
      rims_[parts.of(edge.triangle)].push_back({ edge.lower, edge.upper });
    }
  }

  void run()
  {
    surface_.region.assign(surface_.triangles.size(), FirstRegion);
    for (const std::uint32_t part : partsOnWalls())
    {
      join(part);
    }
    surface_.region.clear();
  }

private:
  // With a corner of a rim near another part.
  std::vector<std::uint32_t> partsOnWalls() const
  {
    const NearbyTriangles nearby(surface_, execution_);
    std::vector<std::uint32_t> found;
    for (const auto& [part, rim] : rims_)
    {
      const bool is = std::any_of(rim.begin(), rim.end(), [&, own = part](const auto& edge) {
        return nearby.isAnyNear(toVector(surface_.vertices[edge[0]]), tolerance_,
          [&](std::uint32_t t) { return partOf_.at(surface_.given[t]) != own; });
      });
      if (is)
      {
        found.push_back(part);
      }
    }
    return found;
  }

  // Divides the walls near the rims of a part, and the part.
  void join(std::uint32_t part)
  {
    Extent extent;
    for (const auto& [from, to] : rims_.at(part))
    {
      const Vector start = toVector(surface_.vertices[from]);
      const Vector end = toVector(surface_.vertices[to]);
      const double aside = tolerance_ + LargestSagitta * norm(minus(end, start));
      extent.include(start, aside);
      extent.include(end, aside);
    }
    Surface walls = like(surface_);
    Surface own = like(surface_);
    Surface rest = like(surface_);
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    {
      const bool isOwn = partOf_.at(surface_.given[t]) == part;
      const bool isNear = !isOwn && extent.meets(surface_.corners(t));
      (isOwn ? own : (isNear ? walls : rest)).append(surface_, t);
    }
    if (walls.triangles.empty())
    {
      return;
    }
    joinRims(walls, own, { tolerance_, LargestSagitta }, execution_);
    rest.vertices = walls.vertices;
    for (const Surface* from : { &walls, &own })
    {
      for (std::size_t t = 0; t < from->triangles.size(); ++t)
      {
        rest.append(*from, t);
      }
    }
    surface_.vertices.swap(rest.vertices);
    surface_.triangles.swap(rest.triangles);
    surface_.boundary.swap(rest.boundary);
    surface_.given.swap(rest.given);
    surface_.region.swap(rest.region);
  }

  static Surface like(const Surface& surface)
  {
    Surface empty;
    empty.lattice = surface.lattice;
    empty.vertices = surface.vertices;
    return empty;
  }

  Surface& surface_;
  double tolerance_;
  Execution& execution_;
  std::map<std::uint32_t, std::uint32_t> partOf_; // by the triangle's number in the view
  std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 2>>> rims_; // of open parts
};

}

void joinRimsToWalls(Surface& surface, double tolerance, Execution& execution)
{
  RimsOnWalls(surface, tolerance, execution).run();
}

}

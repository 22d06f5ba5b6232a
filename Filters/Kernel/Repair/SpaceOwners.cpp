// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/SpaceOwners.h"

#include "Repair/TriangleTree.h"
#include "Surface/LineCrossings.h"
#include "Surface/Places.h"

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// As a part of the area of all.
constexpr double MostContradicting = 1e-5;

// Which spaces are whose.
class SpaceOwners
{
public:
  SpaceOwners(const Surface& surface, const std::vector<Piece>& pieces, std::int32_t regions,
    Execution& execution)
    : surface_(surface)
    , pieces_(pieces)
    , regions_(regions)
    , flat_(flatOf(surface, pieces))
    , sides_(joinedSides(flat_, execution))
  {
    outside_ = static_cast<std::uint32_t>(2 * pieces.size());
    sides_.add();
    joinIslands(execution);
    owner_.resize(outside_ + 1);
  }

  Spaces find()
  {
    for (std::int32_t region = FirstRegion; region <= regions_; ++region)
    {
      findSpacesOf(region);
    }
    return spaces();
  }

private:
  // Where nothing joins parts of the surface, the side of one and the next along a line are of the same space.
  void joinIslands(Execution& execution)
  {
    std::vector<std::uint32_t> order(pieces_.size());
    std::vector<double> area(pieces_.size());
    DisjointSets parts(pieces_.size());
    std::map<std::uint32_t, std::uint32_t> first;
    for (std::uint32_t p = 0; p < order.size(); ++p)
    {
      order[p] = p;
      area[p] = twiceAreaOf(p);
      for (const bool front : { false, true })
      {
        parts.unite(p, first.emplace(sides_.find(sideOf(p, front)), p).first->second);
      }
    }
    std::stable_sort(order.begin(), order.end(),
      [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
    const TriangleTree tree(flat_, execution);
    std::set<std::uint32_t> joined;
    for (const std::uint32_t p : order)
    {
      if (joined.count(parts.find(p)) == 0 && joinAlongLine(p, tree))
      {
        joined.insert(parts.find(p));
      }
    }
  }

  bool joinAlongLine(std::uint32_t piece, const TriangleTree& tree)
  {
    const std::array<Wide, 3> normal = exactNormal(flat_.corners(piece));
    std::size_t along = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
    {
      const auto size = [&](std::size_t a) { return normal[a] < 0 ? -normal[a] : normal[a]; };
      along = size(axis) > size(along) ? axis : along;
    }
    const RowAxes& axes = RowsAlong[along];
    Vector low = middleOf(flat_, piece);
    const auto even = [&](int axis) {
      return static_cast<Level>(low[static_cast<std::size_t>(axis)] / 2) * 2;
    };
    const std::vector<Level> middles{ even(axes.middle) };
    const std::vector<Level> outers{ even(axes.outer) };
    low[static_cast<std::size_t>(axes.middle)] = middles[0];
    low[static_cast<std::size_t>(axes.outer)] = outers[0];
    Vector high = low;
    low[along] = 0;
    high[along] = 4294967295.;
    std::map<Level, std::vector<std::array<std::uint32_t, 2>>> hits; // sides: below and above
    bool isHit = false;
    tree.forEachWithin(low, high, [&](std::uint32_t p) {
      forEachLineCrossing(flat_.corners(p), axes, middles, outers,
        [&](std::size_t, std::size_t, const Point& at, bool up) {
          hits[at[along]].push_back({ sideOf(p, !up), sideOf(p, up) });
          isHit = isHit || p == piece;
        });
    });
    std::uint32_t below = outside_;
    bool isKnown = true;
    for (const auto& [level, at] : hits)
    {
      if (at.size() == 1 && isKnown)
      {
        sides_.unite(below, at[0][0]);
      }
      isKnown = at.size() == 1;
      below = at[0][1];
    }
    if (isKnown)
    {
      sides_.unite(below, outside_);
    }
    return isHit;
  }

  double twiceAreaOf(std::uint32_t piece) const
  {
    const Corners c = flat_.corners(piece);
    return norm(cross(minus(c[1], c[0]), minus(c[2], c[0])));
  }

  std::int32_t netOf(std::uint32_t piece, std::int32_t region) const
  {
    std::int32_t net = 0;
    for (const std::uint32_t t : pieces_[piece].triangles)
    {
      if (surface_.region[t] == region || surface_.region[t] == regionOfCurtains(region, regions_))
      {
        net += faceAlike(surface_.triangles[t], pieces_[piece].vertices) ? 1 : -1;
      }
    }
    return net;
  }

  // Spaces that no earlier region has are joined across the walls of others; the area of a region's own walls, those
  // that point out of a space less those that point into it, tells.
  void findSpacesOf(std::int32_t region)
  {
    DisjointSets spaces(outside_ + 1);
    std::vector<std::int32_t> net(pieces_.size());
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      const auto [behind, front] = beside(p);
      net[p] = netOf(p, region);
      if (net[p] == 0 && owner_[behind] == OutsideRegion && owner_[front] == OutsideRegion)
      {
        spaces.unite(behind, front);
      }
    }
    std::vector<double> inside(outside_ + 1);
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      const auto [behind, front] = beside(p);
      const double area = net[p] * twiceAreaOf(p);
      inside[spaces.find(behind)] += area;
      inside[spaces.find(front)] -= area;
    }
    const std::uint32_t around = spaces.find(sides_.find(outside_));
    for (std::uint32_t s = 0; s <= outside_; ++s)
    {
      const std::uint32_t space = spaces.find(s);
      if (owner_[s] == OutsideRegion && space != around && inside[space] > 0)
      {
        owner_[s] = region;
      }
    }
  }

  std::array<std::uint32_t, 2> beside(std::uint32_t piece)
  {
    return { sides_.find(sideOf(piece, false)), sides_.find(sideOf(piece, true)) };
  }

  // The pieces of regions that have no space of their own behind them, or one in front: unless these are slivers.
  std::vector<std::uint32_t> contradictions()
  {
    std::vector<std::uint32_t> all;
    double whole = 0;
    double part = 0;
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      const double area = twiceAreaOf(p);
      whole += area;
      if (contradicts(p))
      {
        all.push_back(p);
        part += area;
      }
    }
    return part > MostContradicting * whole ? all : std::vector<std::uint32_t>();
  }

  bool contradicts(std::uint32_t piece)
  {
    const auto [behind, front] = beside(piece);
    return std::any_of(
      pieces_[piece].triangles.begin(), pieces_[piece].triangles.end(), [&](std::uint32_t t) {
        const std::int32_t region = surface_.region[t];
        const bool isForward = faceAlike(surface_.triangles[t], pieces_[piece].vertices);
        const std::int32_t own = owner_[isForward ? behind : front];
        const std::int32_t other = owner_[isForward ? front : behind];
        return region <= regions_ && netOf(piece, region) != 0 &&
          (own == OutsideRegion || own > region || other == region);
      });
  }

  Spaces spaces()
  {
    Spaces result;
    std::map<std::uint32_t, std::uint32_t> number;
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      result.beside.push_back({});
      for (std::size_t i = 0; i < 2; ++i)
      {
        const std::uint32_t space = beside(p)[i];
        const auto [at, isNew] = number.emplace(space, static_cast<std::uint32_t>(number.size()));
        if (isNew)
        {
          result.turns.emplace_back(static_cast<std::size_t>(regions_) + 1);
          result.turns.back()[static_cast<std::size_t>(owner_[space])] = 1;
        }
        result.beside.back()[i] = at->second;
      }
    }
    result.contradictions = contradictions();
    return result;
  }

  const Surface& surface_;
  const std::vector<Piece>& pieces_;
  std::int32_t regions_;
  Surface flat_;
  DisjointSets sides_;
  std::uint32_t outside_ = 0;
  std::vector<std::int32_t> owner_; // of sets of sides
};

}

Spaces findOwners(const Surface& arranged, const std::vector<Piece>& pieces, std::int32_t regions,
  Execution& execution)
{
  return SpaceOwners(arranged, pieces, regions, execution).find();
}

}

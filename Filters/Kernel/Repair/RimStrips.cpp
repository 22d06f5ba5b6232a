// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/RimStrips.h"

#include "Repair/FacingRims.h"
#include "Repair/ZippedChains.h"
#include "Surface/Places.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace cartesian
{

namespace
{

// The cosine of the largest angle between two edges that tell whether their rims run the same way: 60 degrees.
constexpr double LeastAlong = 0.5;

// A strip is at least that long, in its widths, the mean of both sides: nearer by, rims may look at each other by chance.
constexpr double LeastLength = 4;

// A place on a rim, the start of an edge, and the way to go from there.
struct Walker
{
  std::size_t at;
  bool isForward;
};

class StripFinder
{
public:
  StripFinder(const Surface& surface, double widest, Execution& execution)
    : surface_(surface)
    , rims_(surface, widest, execution)
    , used_(rims_.edges())
  {
  }

  std::vector<RimStrip> find()
  {
    std::vector<RimStrip> strips;
    for (const Seed& seed : seeds())
    {
      const Walk walk = walkFrom(seed);
      if (walk.steps.empty())
      {
        continue;
      }
      RimStrip strip = stripAlong(walk);
      if (!strip.triangles.empty())
      {
        strips.push_back(std::move(strip));
      }
    }
    return strips;
  }

private:
  // Two vertices that face each other.
  struct Seed
  {
    double distance;
    std::array<std::uint32_t, 2> vertices;
    std::size_t first; // place
    std::size_t second;
    bool isSameWay; // both loops run the same way there

    bool operator<(const Seed& other) const
    {
      return std::tie(distance, vertices, first, second) <
        std::tie(other.distance, other.vertices, other.first, other.second);
    }
  };

  struct Step
  {
    bool isFirst; // of the two rims
    std::size_t edge;
  };

  struct Walk
  {
    Walker first; // where it starts
    Walker second;
    std::vector<Step> steps;
  };

  std::uint32_t vertexAt(std::size_t place) const { return rims_.edge(place).from; }

  std::vector<Seed> seeds() const
  {
    std::vector<Seed> all;
    for (std::size_t e = 0; e < rims_.edges(); ++e)
    {
      for (const std::size_t end : { 0U, 1U })
      {
        if (const std::optional<RimFoot>& foot = rims_.foot(e, end))
        {
          addSeeds(e, end, *foot, all);
        }
      }
    }
    std::sort(all.begin(), all.end());
    return all;
  }

  void addSeeds(std::size_t e, std::size_t end, const RimFoot& foot, std::vector<Seed>& all) const
  {
    const std::size_t first = end == 0 ? e : rims_.next(e);
    const double cosine = cosineAlong(e, foot);
    if (std::abs(cosine) < LeastAlong)
    {
      return;
    }
    for (const std::size_t second : { foot.edge, rims_.next(foot.edge) })
    {
      const bool isOther =
        (foot.along == 0 && second != foot.edge) || (foot.along == 1 && second == foot.edge);
      const std::size_t loop = rims_.loopOf(first);
      const bool facesBack =
        rims_.faces(second, 0, loop) || rims_.faces(rims_.before(second), 1, loop);
      const Vector across = minus(rims_.from(second), rims_.from(first));
      if (!isOther && facesBack && vertexAt(first) != vertexAt(second))
      {
        all.push_back({ norm(across), std::array{ vertexAt(first), vertexAt(second) }, first,
          second, cosine > 0 });
      }
    }
  }

  // The cosine between an edge and the one it faces; at a vertex, of its edges that which is more nearly parallel.
  double cosineAlong(std::size_t e, const RimFoot& foot) const
  {
    const Vector way = unit(rims_.way(e));
    const auto along = [&](std::size_t other) { return dot(way, unit(rims_.way(other))); };
    const double cosine = along(foot.edge);
    if (foot.along > 0 && foot.along < 1)
    {
      return cosine;
    }
    const double other = along(foot.along == 0 ? rims_.before(foot.edge) : rims_.next(foot.edge));
    return std::abs(other) > std::abs(cosine) ? other : cosine;
  }

  Walk walkFrom(const Seed& seed)
  {
    Walker first{ seed.first, true };
    Walker second{ seed.second, seed.isSameWay };
    const std::vector<Step> forward = follow(first, second);
    Walk walk{ { seed.first, false }, { seed.second, !seed.isSameWay }, {} };
    walk.steps = follow(walk.first, walk.second);
    std::reverse(walk.steps.begin(), walk.steps.end());
    walk.steps.insert(walk.steps.end(), forward.begin(), forward.end());
    walk.first.isForward = true;
    walk.second.isForward = seed.isSameWay;
    return walk;
  }

  // Moves both as far as their rims face each other.
  std::vector<Step> follow(Walker& first, Walker& second)
  {
    std::vector<Step> steps;
    for (;;)
    {
      const bool mayFirst = mayStep(first, second);
      const bool maySecond = mayStep(second, first);
      const bool isFirstBeyond = mayFirst && reachesBeyond(first, second);
      const bool isSecondBeyond = maySecond && reachesBeyond(second, first);
      if (mayFirst && (!isFirstBeyond || isSecondBeyond))
      {
        steps.push_back({ true, take(first) });
      }
      else if (maySecond && !isSecondBeyond)
      {
        steps.push_back({ false, take(second) });
      }
      else
      {
        return steps;
      }
    }
  }

  std::size_t edgeAhead(const Walker& walker) const
  {
    return walker.isForward ? walker.at : rims_.before(walker.at);
  }
  std::size_t placeAhead(const Walker& walker) const
  {
    return walker.isForward ? rims_.next(walker.at) : rims_.before(walker.at);
  }

  std::size_t take(Walker& walker)
  {
    const std::size_t edge = edgeAhead(walker);
    used_[edge] = true;
    walker.at = placeAhead(walker);
    return edge;
  }

  bool mayStep(const Walker& walker, const Walker& other) const
  {
    const std::size_t edge = edgeAhead(walker);
    return !used_[edge] && rims_.faces(edge, rims_.loopOf(other.at)) &&
      vertexAt(placeAhead(walker)) != vertexAt(other.at);
  }

  // Whether what the next vertex faces comes after the next vertex of the other rim: the shorter way from there is onward.
  bool reachesBeyond(const Walker& walker, const Walker& other) const
  {
    const RimFoot& foot = *rims_.foot(edgeAhead(walker), walker.isForward ? 1 : 0);
    const std::size_t next = placeAhead(other);
    if (foot.edge == edgeAhead(other) || (foot.edge == next && foot.along == 0) ||
      (foot.edge == rims_.before(next) && foot.along == 1))
    {
      return false;
    }
    const double whole = rims_.lengthOf(rims_.loopOf(next));
    const double onward = rims_.lengthTo(next, foot);
    return (other.isForward ? onward : whole - onward) < whole / 2;
  }

  RimStrip stripAlong(Walk walk) const
  {
    ChainPair chains{ { vertexAt(walk.first.at) }, { vertexAt(walk.second.at) }, {} };
    RimStrip strip{ {}, {}, 0 };
    double length = 0;
    int along = 0; // edges of triangles that run the first rim's way
    for (const Step& step : walk.steps)
    {
      Walker& walker = step.isFirst ? walk.first : walk.second;
      walker.at = placeAhead(walker);
      (step.isFirst ? chains.first : chains.second).push_back(vertexAt(walker.at));
      chains.steps.push_back(step.isFirst);
      strip.width = std::max(
        { strip.width, rims_.foot(step.edge, 0)->across, rims_.foot(step.edge, 1)->across });
      length += norm(rims_.way(step.edge));
      along += (walker.isForward == step.isFirst ? 1 : -1) * rims_.edge(step.edge).along;
    }
    strip.triangles = zipped(surface_, chains);
    if (length < 2 * LeastLength * strip.width || areaOf(strip) > strip.width * length)
    {
      return {}; // a place where two rims come near each other, or run along each other only here and there
    }
    for (auto& triangle : strip.triangles)
    {
      if (along > 0)
      {
        std::swap(triangle[1], triangle[2]);
      }
    }
    strip.rim = chains.first;
    strip.rim.insert(strip.rim.end(), chains.second.rbegin(), chains.second.rend());
    return strip;
  }

  double areaOf(const RimStrip& strip) const
  {
    return std::accumulate(
      strip.triangles.begin(), strip.triangles.end(), 0., [&](double area, const auto& triangle) {
        return area + cartesian::areaOf(surface_, triangle);
      });
  }

  const Surface& surface_;
  const FacingRims rims_;
  std::vector<bool> used_; // edges
};

}

std::vector<RimStrip> findRimStrips(const Surface& surface, double widest, Execution& execution)
{
  return StripFinder(surface, widest, execution).find();
}

}

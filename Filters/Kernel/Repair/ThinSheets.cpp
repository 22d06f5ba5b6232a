// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/ThinSheets.h"

#include "Base/DisjointSets.h"
#include "Lattice/Vector.h"
#include "Repair/Duplicates.h"

#include <algorithm>
#include <map>

namespace cartesian
{

namespace
{

// Of each side from the sheet, in levels: enough that rounding does not turn triangles over.
constexpr double HalfThickness = 64;

using Triple = std::array<std::uint32_t, 3>;
using Ends = std::array<std::uint32_t, 2>; // of an edge, the lower first

constexpr std::uint32_t None = ~0u;

Ends endsOf(std::uint32_t p, std::uint32_t q)
{
  return { std::min(p, q), std::max(p, q) };
}

// Whether the corners ascend, up to rotation.
bool ascends(const Triple& v)
{
  return (v[0] < v[1]) + (v[1] < v[2]) + (v[2] < v[0]) == 2;
}

class SheetDivider
{
public:
  SheetDivider(Surface& surface, Execution& execution)
    : surface_(surface)
  {
    const SurfaceEdges edges(surface, execution);
    listPairs(findDuplicates(surface, edges));
    if (!pairs_.empty())
    {
      connect(edges);
      orientPairs();
    }
  }

  std::size_t run()
  {
    findNormals();
    std::size_t count = 0;
    const std::size_t pairs = pairs_.size();
    for (std::uint32_t p = 0; p < pairs; ++p)
    {
      if (isSheet(p))
      {
        ++count;
        divide(p);
      }
    }
    return count;
  }

private:
  struct Pair
  {
    std::array<std::uint32_t, 2> triangles;
    Triple front; // as its sheet faces
  };

  struct Neighbour
  {
    std::uint32_t pair;
    bool turned; // as it is given, it faces the other way
  };

  // The vertices that take the place of one on the sheet, on either side.
  using Sides = std::array<std::uint32_t, 2>;

  void listPairs(const Duplicates& duplicates)
  {
    pairOf_.assign(surface_.triangles.size(), None);
    for (std::size_t g = 0; g < duplicates.groups(); ++g)
    {
      const std::size_t begin = duplicates.start[g];
      if (duplicates.start[g + 1] - begin == 2)
      {
        const std::uint32_t a = duplicates.triangles[begin];
        const std::uint32_t b = duplicates.triangles[begin + 1];
        pairOf_[a] = pairOf_[b] = static_cast<std::uint32_t>(pairs_.size());
        pairs_.push_back({ { std::min(a, b), std::max(a, b) }, surface_.triangles[std::min(a, b)] });
      }
    }
  }

  // Across edges of two pairs and nothing else. All others are rims.
  void connect(const SurfaceEdges& edges)
  {
    sets_.reset(pairs_.size());
    isFree_.assign(pairs_.size(), 0);
    neighbours_.resize(pairs_.size());
    std::vector<std::uint8_t> isOnRim(surface_.vertices.size());
    std::vector<std::uint32_t> here;
    edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      here.clear();
      std::size_t others = 0;
      for (const EdgeUse* use = begin; use != end; ++use)
      {
        const std::uint32_t pair = pairOf_[use->triangle()];
        others += pair == None ? 1 : 0;
        if (pair != None && std::find(here.begin(), here.end(), pair) == here.end())
        {
          here.push_back(pair);
        }
      }
      if (here.size() == 2 && others == 0)
      {
        const bool turned = runsUp(here[0], lower, begin->upper) == runsUp(here[1], lower, begin->upper);
        neighbours_[here[0]].push_back({ here[1], turned });
        neighbours_[here[1]].push_back({ here[0], turned });
        sets_.unite(here[0], here[1]);
        inner_.insert({ { lower, begin->upper }, {} });
        return;
      }
      isOnRim[lower] = isOnRim[begin->upper] = 1;
      if (here.size() == 1 && others == 0)
      {
        isFree_[here[0]] = 1;
      }
    });
    isOnRim_.swap(isOnRim);
    for (std::uint32_t p = 0; p < pairs_.size(); ++p)
    {
      isFree_[sets_.find(p)] |= isFree_[p];
    }
  }

  bool isSheet(std::uint32_t pair) { return isFree_[sets_.find(pair)] != 0; }

  bool runsUp(std::uint32_t pair, std::uint32_t lower, std::uint32_t upper) const
  {
    const Triple& v = pairs_[pair].front;
    const auto at = static_cast<std::size_t>(std::find(v.begin(), v.end(), lower) - v.begin());
    return v[(at + 1) % 3] == upper;
  }

  void orientPairs()
  {
    std::vector<std::uint8_t> isKnown(pairs_.size());
    std::vector<std::uint32_t> next;
    for (std::uint32_t first = 0; first < pairs_.size(); ++first)
    {
      if (isKnown[first] != 0)
      {
        continue;
      }
      isKnown[first] = 1;
      next.assign(1, first);
      while (!next.empty())
      {
        const std::uint32_t p = next.back();
        next.pop_back();
        for (const Neighbour& n : neighbours_[p])
        {
          if (isKnown[n.pair] == 0)
          {
            isKnown[n.pair] = 1;
            const bool isTurned = pairs_[p].front != surface_.triangles[pairs_[p].triangles[0]];
            if (isTurned != n.turned)
            {
              std::swap(pairs_[n.pair].front[1], pairs_[n.pair].front[2]);
            }
            next.push_back(n.pair);
          }
        }
      }
    }
  }

  void findNormals()
  {
    normal_.assign(surface_.vertices.size(), Vector{});
    for (std::uint32_t p = 0; p < pairs_.size(); ++p)
    {
      const Vector normal = normalOf(pairs_[p].front);
      const Triple& v = pairs_[p].front;
      for (std::size_t i = 0; i < 3; ++i)
      {
        normal_[v[i]] = plus(normal_[v[i]], normal);
        if (const auto edge = inner_.find(endsOf(v[i], v[(i + 1) % 3])); edge != inner_.end())
        {
          edge->second = plus(edge->second, unit(normal));
        }
      }
    }
  }

  Vector normalOf(const Triple& v) const
  {
    const auto at = [&](std::uint32_t n) { return surface_.vertices[n]; };
    return cross(minus(at(v[1]), at(v[0])), minus(at(v[2]), at(v[0])));
  }

  Sides sidesAt(const Vector& place, const Vector& normal)
  {
    Sides sides{};
    for (const std::size_t side : { 0, 1 })
    {
      const Vector p = plus(place, scaled(unit(normal), side == 0 ? HalfThickness : -HalfThickness));
      sides[side] = static_cast<std::uint32_t>(surface_.vertices.size());
      surface_.vertices.push_back({ oddLevel(p[0]), oddLevel(p[1]), oddLevel(p[2]) });
    }
    return sides;
  }

  Sides ofVertex(std::uint32_t v)
  {
    if (isOnRim_[v] != 0)
    {
      return { v, v };
    }
    const auto [known, isNew] = ofVertex_.emplace(v, Sides{});
    if (isNew)
    {
      known->second = sidesAt(toVector(surface_.vertices[v]), normal_[v]);
    }
    return known->second;
  }

  // Of the middle of an edge that runs from rim to rim.
  Sides ofEdge(const Ends& edge, const Vector& normal)
  {
    const auto [known, isNew] = ofEdge_.emplace(edge, Sides{});
    if (isNew)
    {
      known->second = sidesAt(scaled(plus(toVector(surface_.vertices[edge[0]]),
                                       toVector(surface_.vertices[edge[1]])),
                                0.5),
        normal);
    }
    return known->second;
  }

  void divide(std::uint32_t p)
  {
    const Triple front = pairs_[p].front;
    std::vector<Sides> corners;
    bool isOnRims = true;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t from = front[i];
      const std::uint32_t to = front[(i + 1) % 3];
      corners.push_back(ofVertex(from));
      isOnRims = isOnRims && isOnRim_[from] != 0;
      const auto inner = inner_.find(endsOf(from, to));
      if (isOnRim_[from] != 0 && isOnRim_[to] != 0 && inner != inner_.end())
      {
        corners.push_back(ofEdge(inner->first, inner->second));
      }
    }
    std::vector<std::array<Sides, 3>> parts;
    if (corners.size() == 3 && !isOnRims)
    {
      parts.push_back({ corners[0], corners[1], corners[2] });
    }
    else
    {
      Vector middle{};
      for (const std::uint32_t v : front)
      {
        middle = plus(middle, scaled(toVector(surface_.vertices[v]), 1. / 3));
      }
      const Sides apex = sidesAt(middle, normalOf(front));
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        parts.push_back({ corners[i], corners[(i + 1) % corners.size()], apex });
      }
    }
    write(p, parts);
  }

  void write(std::uint32_t p, const std::vector<std::array<Sides, 3>>& parts)
  {
    // The one that faces as the front does, if just one of both does, keeps its boundary there.
    std::array<std::uint32_t, 2> source = pairs_[p].triangles;
    if (ascends(surface_.triangles[source[0]]) != ascends(pairs_[p].front) &&
      ascends(surface_.triangles[source[1]]) == ascends(pairs_[p].front))
    {
      std::swap(source[0], source[1]);
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      for (const std::size_t side : { 0, 1 })
      {
        Triple t{ parts[i][0][side], parts[i][1][side], parts[i][2][side] };
        if (side == 1)
        {
          std::swap(t[1], t[2]);
        }
        if (i == 0)
        {
          surface_.triangles[source[side]] = t;
          continue;
        }
        surface_.triangles.push_back(t);
        surface_.boundary.push_back(surface_.boundary[source[side]]);
        surface_.given.push_back(surface_.given[source[side]]);
        if (!surface_.region.empty())
        {
          surface_.region.push_back(surface_.region[source[side]]);
        }
      }
    }
  }

  Surface& surface_;
  std::vector<Pair> pairs_;
  std::vector<std::uint32_t> pairOf_; // of triangles
  std::vector<std::vector<Neighbour>> neighbours_;
  DisjointSets sets_;                 // of pairs: sheets
  std::vector<std::uint8_t> isFree_;  // of pairs, and of sheets: has an edge that nothing else uses
  std::vector<std::uint8_t> isOnRim_; // of vertices
  std::map<Ends, Vector> inner_;      // edges within sheets, with their normals
  std::vector<Vector> normal_;        // of vertices
  std::map<std::uint32_t, Sides> ofVertex_;
  std::map<Ends, Sides> ofEdge_;
};

}

std::size_t giveSidesToSheets(Surface& surface, Execution& execution)
{
  return SheetDivider(surface, execution).run();
}

}

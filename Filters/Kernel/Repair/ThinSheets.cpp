// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/ThinSheets.h"

#include "Base/DisjointSets.h"
#include "Lattice/Vector.h"
#include "Repair/Arrangement.h"
#include "Repair/Snapping.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace cartesian
{

namespace
{

using Triple = std::array<std::uint32_t, 3>;

constexpr std::uint32_t None = ~0u;

// At the lattice's ends a sheet stands on one side only.
Level levelAt(double place)
{
  return oddLevel(std::clamp(place, 1., static_cast<double>(std::numeric_limits<Level>::max())));
}

std::uint64_t keyOf(std::uint32_t p, std::uint32_t q)
{
  return std::uint64_t(std::min(p, q)) << 32 | std::max(p, q);
}

// Whether the corners ascend, up to rotation.
bool ascends(const Triple& v)
{
  return (v[0] < v[1]) + (v[1] < v[2]) + (v[2] < v[0]) == 2;
}

std::vector<std::uint32_t> pairsOfTriangles(
  const Surface& surface, const std::vector<SheetPair>& pairs)
{
  std::vector<std::uint32_t> result(surface.triangles.size(), None);
  for (std::uint32_t p = 0; p < pairs.size(); ++p)
  {
    result[pairs[p][0]] = result[pairs[p][1]] = p;
  }
  return result;
}

// What uses an edge: pairs, in order of their triangles, and other triangles.
struct Uses
{
  std::vector<std::uint32_t> pairs;
  std::size_t others = 0;

  bool areInside() const { return pairs.size() == 2 && others == 0; }
};

// Calls visit(lower, upper, uses) for each edge of a pair.
template <class Visitor>
void forEachEdge(
  const SurfaceEdges& edges, const std::vector<std::uint32_t>& pairOf, Visitor&& visit)
{
  Uses uses;
  edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
    uses.pairs.clear();
    uses.others = 0;
    for (const EdgeUse* use = begin; use != end; ++use)
    {
      const std::uint32_t pair = pairOf[use->triangle()];
      uses.others += pair == None ? 1 : 0;
      if (pair != None && std::find(uses.pairs.begin(), uses.pairs.end(), pair) == uses.pairs.end())
      {
        uses.pairs.push_back(pair);
      }
    }
    if (!uses.pairs.empty())
    {
      visit(lower, begin->upper, uses);
    }
  });
}

class SheetDivider
{
public:
  SheetDivider(Surface& surface, const SurfaceEdges& edges, const std::vector<SheetPair>& sheets)
    : surface_(surface)
    , sheets_(sheets)
    , halfThickness_(placingOf(surface).snap)
    , neighbours_(sheets.size())
    , isOnRim_(surface.vertices.size())
    , normal_(surface.vertices.size())
    , sides_(surface.vertices.size(), { None, None })
  {
    std::transform(sheets.begin(), sheets.end(), std::back_inserter(fronts_),
      [&](const SheetPair& pair) { return surface.triangles[pair[0]]; });
    forEachEdge(edges, pairsOfTriangles(surface, sheets),
      [&](std::uint32_t lower, std::uint32_t upper, const Uses& uses) {
        connect(lower, upper, uses);
      });
    orient();
    findNormals();
  }

  void run()
  {
    surface_.ofSheet.assign(surface_.triangles.size(), 0);
    for (std::uint32_t p = 0; p < sheets_.size(); ++p)
    {
      divide(p);
    }
  }

private:
  struct Neighbour
  {
    std::uint32_t pair;
    bool isTurned; // as it is given, it faces the other way
  };

  // The vertices in front of a place of the sheet, and behind it.
  using Sides = std::array<std::uint32_t, 2>;

  // An edge within a sheet, that may need a vertex in its middle.
  struct Edge
  {
    Vector normal{};
    Sides middle{ None, None };
  };

  void connect(std::uint32_t lower, std::uint32_t upper, const Uses& uses)
  {
    if (!uses.areInside())
    {
      isOnRim_[lower] = isOnRim_[upper] = 1;
      return;
    }
    const std::uint32_t one = uses.pairs[0];
    const std::uint32_t other = uses.pairs[1];
    const bool isTurned = runsUp(one, lower, upper) == runsUp(other, lower, upper);
    neighbours_[one].push_back({ other, isTurned });
    neighbours_[other].push_back({ one, isTurned });
    inner_[keyOf(lower, upper)] = {};
  }

  bool runsUp(std::uint32_t pair, std::uint32_t lower, std::uint32_t upper) const
  {
    const Triple& v = fronts_[pair];
    const auto at = static_cast<std::size_t>(std::find(v.begin(), v.end(), lower) - v.begin());
    return v[(at + 1) % 3] == upper;
  }

  // From the first pair of each sheet on. One with a single side, such as a Moebius strip, gets a fold somewhere.
  void orient()
  {
    std::vector<std::uint8_t> isKnown(sheets_.size());
    std::vector<std::uint8_t> isTurned(sheets_.size());
    std::vector<std::uint32_t> next;
    for (std::uint32_t first = 0; first < sheets_.size(); ++first)
    {
      next.assign(isKnown[first] ? 0 : 1, first);
      isKnown[first] = 1;
      while (!next.empty())
      {
        const std::uint32_t p = next.back();
        next.pop_back();
        for (const Neighbour& n : neighbours_[p])
        {
          if (!isKnown[n.pair])
          {
            isKnown[n.pair] = 1;
            isTurned[n.pair] = isTurned[p] != (n.isTurned ? 1 : 0);
            next.push_back(n.pair);
          }
        }
      }
    }
    for (std::uint32_t p = 0; p < sheets_.size(); ++p)
    {
      if (isTurned[p])
      {
        std::swap(fronts_[p][1], fronts_[p][2]);
      }
    }
  }

  void findNormals()
  {
    for (const Triple& v : fronts_)
    {
      const Vector normal = normalOf(v);
      for (std::size_t i = 0; i < 3; ++i)
      {
        normal_[v[i]] = plus(normal_[v[i]], normal);
        if (const auto edge = inner_.find(keyOf(v[i], v[(i + 1) % 3])); edge != inner_.end())
        {
          edge->second.normal = plus(edge->second.normal, unit(normal));
        }
      }
    }
  }

  Vector placeOf(std::uint32_t v) const { return toVector(surface_.vertices[v]); }

  Vector normalOf(const Triple& v) const
  {
    return cross(minus(placeOf(v[1]), placeOf(v[0])), minus(placeOf(v[2]), placeOf(v[0])));
  }

  Sides sidesAt(const Vector& place, const Vector& normal)
  {
    Sides sides{};
    for (const std::size_t side : { 0, 1 })
    {
      const Vector p =
        plus(place, scaled(unit(normal), side == 0 ? halfThickness_ : -halfThickness_));
      sides[side] = static_cast<std::uint32_t>(surface_.vertices.size());
      surface_.vertices.push_back({ levelAt(p[0]), levelAt(p[1]), levelAt(p[2]) });
    }
    return sides;
  }

  Sides ofVertex(std::uint32_t v)
  {
    if (isOnRim_[v])
    {
      return { v, v };
    }
    if (sides_[v][0] == None)
    {
      sides_[v] = sidesAt(placeOf(v), normal_[v]);
    }
    return sides_[v];
  }

  // An edge that runs from rim to rim would be one of both sides.
  void addMiddle(std::uint32_t from, std::uint32_t to, std::vector<Sides>& corners)
  {
    const auto edge = inner_.find(keyOf(from, to));
    if (!isOnRim_[from] || !isOnRim_[to] || edge == inner_.end())
    {
      return;
    }
    if (edge->second.middle[0] == None)
    {
      edge->second.middle =
        sidesAt(scaled(plus(placeOf(from), placeOf(to)), 0.5), edge->second.normal);
    }
    corners.push_back(edge->second.middle);
  }

  void divide(std::uint32_t p)
  {
    const Triple& front = fronts_[p];
    std::vector<Sides> corners;
    for (std::size_t i = 0; i < 3; ++i)
    {
      corners.push_back(ofVertex(front[i]));
      addMiddle(front[i], front[(i + 1) % 3], corners);
    }
    const bool isOnRims =
      std::all_of(front.begin(), front.end(), [&](std::uint32_t v) { return isOnRim_[v] != 0; });
    if (!isOnRims && corners.size() == 3)
    {
      write(p, { { corners[0], corners[1], corners[2] } });
      return;
    }
    const Vector middle =
      scaled(plus(plus(placeOf(front[0]), placeOf(front[1])), placeOf(front[2])), 1. / 3);
    const Sides apex = sidesAt(middle, normalOf(front));
    std::vector<std::array<Sides, 3>> parts;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      parts.push_back({ corners[i], corners[(i + 1) % corners.size()], apex });
    }
    write(p, parts);
  }

  void write(std::uint32_t p, const std::vector<std::array<Sides, 3>>& parts)
  {
    SheetPair source = sheets_[p];
    const bool faces = ascends(fronts_[p]);
    if (ascends(surface_.triangles[source[0]]) != faces &&
      ascends(surface_.triangles[source[1]]) == faces)
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
          surface_.ofSheet[source[side]] = 1;
        }
        else
        {
          append(t, source[side]);
        }
      }
    }
  }

  void append(const Triple& t, std::uint32_t like)
  {
    surface_.triangles.push_back(t);
    surface_.ofSheet.push_back(1);
    surface_.boundary.push_back(surface_.boundary[like]);
    surface_.given.push_back(surface_.given[like]);
    if (!surface_.region.empty())
    {
      surface_.region.push_back(surface_.region[like]);
    }
  }

  Surface& surface_;
  const std::vector<SheetPair>& sheets_;
  double halfThickness_;       // levels: what is thinner may be taken for one
  std::vector<Triple> fronts_; // of the pairs, as their sheets face
  std::vector<std::vector<Neighbour>> neighbours_;
  std::vector<std::uint8_t> isOnRim_; // of vertices
  std::vector<Vector> normal_;        // likewise
  std::vector<Sides> sides_;          // likewise, where they are known
  std::unordered_map<std::uint64_t, Edge> inner_;
};

}

std::vector<SheetPair> findSheets(const Surface& surface, SheetHandling sheets,
  const SurfaceEdges& edges, const Duplicates& duplicates)
{
  // Triangles in which the thickness would show are left out.
  const bool keeps = sheets == SheetHandling::Keep && isFinelyPlaced(surface);
  const auto isKnown = [&](const SheetPair& pair) {
    return surface.isOfSheet(pair[0]) && surface.isOfSheet(pair[1]);
  };
  std::vector<SheetPair> pairs;
  for (std::size_t g = 0; g < duplicates.groups(); ++g)
  {
    const std::size_t begin = duplicates.start[g];
    if (duplicates.start[g + 1] - begin == 2)
    {
      pairs.push_back({ duplicates.triangles[begin], duplicates.triangles[begin + 1] });
    }
  }
  DisjointSets connected(pairs.size());
  std::vector<std::uint8_t> isFree(pairs.size());
  forEachEdge(
    edges, pairsOfTriangles(surface, pairs), [&](std::uint32_t, std::uint32_t, const Uses& uses) {
      if (uses.areInside())
      {
        connected.unite(uses.pairs[0], uses.pairs[1]);
      }
      if (uses.pairs.size() == 1 && uses.others == 0)
      {
        isFree[uses.pairs[0]] = 1;
      }
    });
  std::vector<std::uint8_t> ends(pairs.size());
  for (std::uint32_t p = 0; p < pairs.size(); ++p)
  {
    ends[connected.find(p)] |= isFree[p];
  }
  std::vector<SheetPair> found;
  for (std::uint32_t p = 0; p < pairs.size(); ++p)
  {
    if (isKnown(pairs[p]) || (keeps && ends[connected.find(p)]))
    {
      found.push_back(pairs[p]);
    }
  }
  return found;
}

void giveSides(Surface& surface, const SurfaceEdges& edges, const std::vector<SheetPair>& sheets)
{
  SheetDivider(surface, edges, sheets).run();
}

}

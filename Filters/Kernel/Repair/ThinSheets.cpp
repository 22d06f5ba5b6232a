// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/ThinSheets.h"

#include "Base/DisjointSets.h"
#include "Base/Rings.h"
#include "Lattice/Vector.h"
#include "Repair/Arrangement.h"
#include "Repair/RadialEdgeSort.h"
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

// Sines: of the angle between walls that are not one bent wall, and between the normal of a sheet and that of a wall along
// which its sides still move apart.
constexpr double LeastTurn = 0.5;
constexpr double LeastWay = 0.1;

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
  SheetDivider(Surface& surface, const SurfaceEdges& edges, const std::vector<SheetPair>& sheets,
    const MeshedSides& meshed)
    : surface_(surface)
    , sheets_(sheets)
    , meshed_(meshed)
    , pairOf_(pairsOfTriangles(surface, sheets))
    , halfThickness_(placingOf(surface).snap)
    , neighbours_(sheets.size())
    , corners_(3 * (2 * sheets.size() + surface.triangles.size()))
  {
    std::transform(sheets.begin(), sheets.end(), std::back_inserter(fronts_),
      [&](const SheetPair& pair) { return surface.triangles[pair[0]]; });
    forEachEdge(edges, pairOf_, [&](std::uint32_t lower, std::uint32_t upper, const Uses& uses) {
      connect(lower, upper, uses);
    });
    orient();
    joinCorners(edges);
    findNormals();
    keepInWalls();
  }

  void run()
  {
    surface_.ofSheet.assign(surface_.triangles.size(), 0);
    for (std::uint32_t p = 0; p < sheets_.size(); ++p)
    {
      divide(p);
    }
    for (std::uint32_t t = 0; t < pairOf_.size() && !meshed_.empty(); ++t)
    {
      for (std::uint32_t i = 0; i < 3 && pairOf_[t] == None; ++i)
      {
        std::uint32_t& v = surface_.triangles[t][i];
        v = vertexOf(ofWall(t) + i, v);
      }
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

  // Where corners of sheets move to, as far as known.
  struct Place
  {
    Vector normal{};
    std::uint32_t vertex = None;
  };

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
    return following(v, at) == upper;
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

  // Numbers of the first corners of sides. Walls have one, which all around them share.
  static std::uint32_t ofSide(std::uint32_t pair, std::size_t side)
  {
    return 3 * (2 * pair + static_cast<std::uint32_t>(side));
  }
  std::uint32_t ofWall(std::uint32_t t) const
  {
    return 3 * (2 * static_cast<std::uint32_t>(sheets_.size()) + t);
  }

  static std::uint32_t at(const Triple& triangle, std::uint32_t v)
  {
    return static_cast<std::uint32_t>(
      std::find(triangle.begin(), triangle.end(), v) - triangle.begin());
  }

  // A triangle's corner that bounds a space around an edge, in front of it or behind it.
  std::uint32_t cornerOf(std::uint32_t t, bool front, std::uint32_t v) const
  {
    const std::uint32_t pair = pairOf_[t];
    return pair == None ? ofWall(t) + at(surface_.triangles[t], v)
                        : ofSide(pair, front ? 0 : 1) + at(fronts_[pair], v);
  }

  // What stands around an edge: the numbers of pairs and of walls.
  std::array<std::size_t, 2> collect(
    std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end, RadialEdgeSort& fan) const
  {
    std::array<std::size_t, 2> counts{ 0, 0 };
    fan.start(lower, begin->upper);
    for (const EdgeUse* use = begin; use != end; ++use)
    {
      const std::uint32_t t = use->triangle();
      const std::uint32_t pair = pairOf_[t];
      if (pair == None)
      {
        fan.add(t, surface_.triangles[t], use->down());
        ++counts[1];
      }
      else if (sheets_[pair][0] == t)
      {
        fan.add(t, fronts_[pair], !runsUp(pair, lower, begin->upper));
        ++counts[0];
      }
    }
    return counts;
  }

  // Corners at one place are the same where they bound one space: going around each edge, what lies between two
  // neighbours is one. At rims that are not open both sides of a sheet are the same, too.
  void joinCorners(const SurfaceEdges& edges)
  {
    std::vector<std::uint8_t> isOfSheets(surface_.vertices.size());
    for (const Triple& front : fronts_)
    {
      isOfSheets[front[0]] = isOfSheets[front[1]] = isOfSheets[front[2]] = 1;
    }
    RadialEdgeSort fan(surface_.vertices);
    edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      if (isOfSheets[lower] == 0 && isOfSheets[begin->upper] == 0)
      {
        return;
      }
      const auto [pairs, walls] = collect(lower, begin, end, fan);
      const bool isRim = pairs > 0 && (pairs != 2 || walls > 0);
      const bool isOpen = isRim && !meshed_.empty() && (walls > 0 || pairs % 2 == 1);
      fan.forEachSpace([&, joinsSides = isRim && !isOpen, opens = isOpen](
                         const RadialEdgeSort::IncidentTriangle& one,
                         const RadialEdgeSort::IncidentTriangle& next) {
        for (const std::uint32_t v : { lower, begin->upper })
        {
          if (!opens || isMeshed(one.triangle, !one.down) || isMeshed(next.triangle, next.down))
          {
            corners_.unite(
              cornerOf(one.triangle, !one.down, v), cornerOf(next.triangle, next.down, v));
          }
          if (joinsSides)
          {
            corners_.unite(cornerOf(one.triangle, true, v), cornerOf(one.triangle, false, v));
          }
        }
      });
    });
  }

  bool isMeshed(std::uint32_t t, bool front) const
  {
    return pairOf_[t] != None || meshed_[t][front ? 1 : 0] != 0;
  }

  void findNormals()
  {
    for (std::uint32_t p = 0; p < fronts_.size(); ++p)
    {
      const Triple& v = fronts_[p];
      const Vector normal = normalOf(v);
      for (std::uint32_t i = 0; i < 3; ++i)
      {
        const std::uint32_t front = corners_.find(ofSide(p, 0) + i);
        const std::uint32_t back = corners_.find(ofSide(p, 1) + i);
        places_[front].normal = plus(places_[front].normal, normal);
        places_[back].normal = plus(places_[back].normal, scaled(normal, -1));
        if (front == back)
        {
          places_[front].vertex = v[i];
        }
        if (const auto edge = inner_.find(keyOf(v[i], following(v, i))); edge != inner_.end())
        {
          edge->second.normal = plus(edge->second.normal, unit(normal));
        }
      }
    }
  }

  // Corners that walls bound too stay in these, all but those that differ by less than a feature does from the first
  // ones; where there is no way to go, corners stay.
  void keepInWalls()
  {
    std::unordered_map<std::uint32_t, std::vector<Vector>> across; // of walls, by their corners
    for (std::uint32_t t = 0; t < pairOf_.size() && !meshed_.empty(); ++t)
    {
      for (std::uint32_t i = 0; i < 3 && pairOf_[t] == None; ++i)
      {
        const std::uint32_t corner = corners_.find(ofWall(t) + i);
        const auto place = places_.find(corner);
        if (place == places_.end() || place->second.vertex != None)
        {
          continue;
        }
        std::vector<Vector>& taken = across[corner];
        const Vector normal = without(unit(normalOf(surface_.triangles[t])), taken);
        if (norm(normal) > LeastTurn)
        {
          taken.push_back(unit(normal));
          const Vector left = without(unit(place->second.normal), { unit(normal) });
          const bool isLeft = norm(left) > LeastWay && taken.size() < 3;
          place->second.normal = left;
          place->second.vertex = isLeft ? None : surface_.triangles[t][i];
        }
      }
    }
  }

  static Vector without(Vector vector, const std::vector<Vector>& directions)
  {
    for (const Vector& direction : directions)
    {
      vector = minus(vector, scaled(direction, dot(vector, direction)));
    }
    return vector;
  }

  Vector placeOf(std::uint32_t v) const { return toVector(surface_.vertices[v]); }

  Vector normalOf(const Triple& v) const
  {
    return cross(minus(placeOf(v[1]), placeOf(v[0])), minus(placeOf(v[2]), placeOf(v[0])));
  }

  std::uint32_t vertexAt(const Vector& place, const Vector& normal)
  {
    const Vector p = plus(place, scaled(unit(normal), halfThickness_));
    surface_.vertices.push_back({ levelAt(p[0]), levelAt(p[1]), levelAt(p[2]) });
    return static_cast<std::uint32_t>(surface_.vertices.size() - 1);
  }

  Sides sidesAt(const Vector& place, const Vector& normal)
  {
    const std::uint32_t front = vertexAt(place, normal);
    return { front, vertexAt(place, scaled(normal, -1)) };
  }

  // At a corner that was given at a vertex.
  std::uint32_t vertexOf(std::uint32_t corner, std::uint32_t given)
  {
    const auto found = places_.find(corners_.find(corner));
    if (found == places_.end())
    {
      return given;
    }
    std::uint32_t& vertex = found->second.vertex;
    vertex = vertex == None ? vertexAt(placeOf(given), found->second.normal) : vertex;
    return vertex;
  }

  Sides ofCorner(std::uint32_t p, std::uint32_t i)
  {
    const std::uint32_t front = vertexOf(ofSide(p, 0) + i, fronts_[p][i]);
    return { front, vertexOf(ofSide(p, 1) + i, fronts_[p][i]) };
  }

  // An edge whose ends are those of both sides would be one of both too.
  void addMiddle(std::uint32_t p, std::uint32_t i, std::vector<Sides>& corners)
  {
    const std::uint32_t from = fronts_[p][i];
    const std::uint32_t to = following(fronts_[p], i);
    const auto edge = inner_.find(keyOf(from, to));
    if (!isJoined(p, i) || !isJoined(p, (i + 1) % 3) || edge == inner_.end())
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

  // Whether both sides meet at a corner.
  bool isJoined(std::uint32_t p, std::uint32_t i)
  {
    const std::uint32_t v = fronts_[p][i];
    return places_.at(corners_.find(ofSide(p, 0) + i)).vertex == v &&
      places_.at(corners_.find(ofSide(p, 1) + i)).vertex == v;
  }

  void divide(std::uint32_t p)
  {
    const Triple& front = fronts_[p];
    std::vector<Sides> corners;
    for (std::uint32_t i = 0; i < 3; ++i)
    {
      corners.push_back(ofCorner(p, i));
      addMiddle(p, i, corners);
    }
    const bool isFlat = isJoined(p, 0) && isJoined(p, 1) && isJoined(p, 2);
    if (!isFlat && corners.size() == 3)
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
      parts.push_back({ corners[i], following(corners, i), apex });
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
  const MeshedSides& meshed_;
  std::vector<std::uint32_t> pairOf_; // of triangles
  double halfThickness_;              // levels: what is thinner may be taken for one
  std::vector<Triple> fronts_;        // of the pairs, as their sheets face
  std::vector<std::vector<Neighbour>> neighbours_;
  DisjointSets corners_;
  std::unordered_map<std::uint32_t, Place> places_; // of corners of sheets
  std::unordered_map<std::uint64_t, Edge> inner_;
};

}

std::vector<SheetPair> findSheets(const Surface& surface, SheetHandling sheets,
  const SurfaceEdges& edges, const Duplicates& duplicates)
{
  // Triangles in which the thickness would show are left out.
  const bool keeps = sheets != SheetHandling::LeaveOut && isFinelyPlaced(surface);
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

void giveSides(Surface& surface, const SurfaceEdges& edges, const std::vector<SheetPair>& sheets,
  const MeshedSides& meshed)
{
  SheetDivider(surface, edges, sheets, meshed).run();
}

}

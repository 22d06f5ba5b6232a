// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/Features.h"

#include "Base/Rings.h"
#include "Surface/SurfaceEdges.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 1 << 11;

// A folded triangle is at most as thick as this part of its longest edge. If both of its long edges are sharp, they are one
// line nevertheless.
constexpr double ThickestFold = 0.02;

// ... and lies back to back with what it is folded onto, across a long edge: the walls of a tube, thin as they may be, have
// right angles with its ends, across short ones.
constexpr double MostCosineBackToBack = -0.5;
constexpr double ShortestLongEdge = 0.5; // of the longest

constexpr std::uint32_t None = ~std::uint32_t(0);

using Neighbours = std::array<std::uint32_t, 3>; // across each edge, or None

class FeatureFinder
{
public:
  FeatureFinder(const Surface& surface, double featureAngle, Features& result)
    : surface_(surface)
    , result_(result)
    , leastCosine_(std::cos(radians(featureAngle)))
    , neighbours_(surface.triangles.size(), Neighbours{ None, None, None })
  {
  }

  void findNormals(std::size_t begin, std::size_t end)
  {
    for (std::size_t t = begin; t < end; ++t)
    {
      const Corners c = surface_.corners(t);
      result_.normal[t] = unit(cross(minus(c[1], c[0]), minus(c[2], c[0])));
    }
  }

  void addEdge(std::uint32_t lower, const EdgeUse* first, const EdgeUse* last)
  {
    if (last - first != 2 || first->down() == first[1].down())
    {
      return;
    }
    neighbours_[first->triangle()][edgeOf(surface_, *first, lower)] = first[1].triangle();
    neighbours_[first[1].triangle()][edgeOf(surface_, first[1], lower)] = first->triangle();
  }

  void markEdges(std::size_t begin, std::size_t end)
  {
    for (std::size_t t = begin; t < end; ++t)
    {
      result_.edges[t] = isFold(t) ? 64 : 0;
      for (unsigned i = 0; i < 3; ++i)
      {
        const std::uint32_t other = neighbours_[t][i];
        if (other == None || (isSharp(t, other) && !isFold(t) && !isFold(other)))
        {
          result_.edges[t] = static_cast<std::uint8_t>(result_.edges[t] | 1u << i);
        }
        if (other != None && surface_.boundary[t] != surface_.boundary[other])
        {
          result_.edges[t] = static_cast<std::uint8_t>(result_.edges[t] | 8u << i);
        }
      }
    }
  }

private:
  bool isSharp(std::size_t t, std::size_t other) const
  {
    const Known known = surface_.knownBetween(t, other);
    return known == Known::Nothing ? turns(t, other) : known == Known::Sharp;
  }

  // A triangle without area has no normal: the neighbours behind it are compared instead.
  bool turns(std::size_t t, std::size_t other) const
  {
    if (hasArea(t) && hasArea(other))
    {
      return dot(result_.normal[t], result_.normal[other]) < leastCosine_;
    }
    const std::size_t whole = hasArea(t) ? t : other;
    const Neighbours& behind = neighbours_[hasArea(t) ? other : t];
    return std::any_of(behind.begin(), behind.end(), [&](std::uint32_t n) {
      return n == None || dot(result_.normal[whole], result_.normal[n]) < leastCosine_;
    });
  }

  bool hasArea(std::size_t t) const { return dot(result_.normal[t], result_.normal[t]) > 0; }

  // Whether a triangle is thin and flipped between two neighbours that agree with each other.
  // Between it and one of these there may be a second thin triangle.
  bool isFold(std::size_t t) const
  {
    if (!isThin(t))
    {
      return false;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t a = neighbours_[t][i];
      if (a == None || !isLong(t, i) || !isBackToBack(t, a))
      {
        continue;
      }
      for (const std::size_t j : { (i + 1) % 3, (i + 2) % 3 })
      {
        const std::uint32_t b = neighbours_[t][j];
        if (b != None && (isBackToBack(t, b) ? !turns(a, b) : isThin(b) && agreesBehind(t, b, a)))
        {
          return true;
        }
      }
    }
    return false;
  }

  // Whether a neighbour of `twin` other than t lies back to back with t and agrees with a.
  bool agreesBehind(std::size_t t, std::size_t twin, std::size_t a) const
  {
    const Neighbours& behind = neighbours_[twin];
    return std::any_of(behind.begin(), behind.end(),
      [&](std::uint32_t n) { return n != None && n != t && isBackToBack(t, n) && !turns(a, n); });
  }

  bool isThin(std::size_t t) const
  {
    const Corners c = surface_.corners(t);
    const Vector twiceArea = cross(minus(c[1], c[0]), minus(c[2], c[0]));
    const double longest = longestSquared(c);
    return dot(twiceArea, twiceArea) <= ThickestFold * ThickestFold * longest * longest;
  }

  bool isLong(std::size_t t, std::size_t edge) const
  {
    const Corners c = surface_.corners(t);
    return lengthSquared(c, edge) >= ShortestLongEdge * ShortestLongEdge * longestSquared(c);
  }

  static double lengthSquared(const Corners& c, std::size_t edge)
  {
    const Vector way = minus(following(c, edge), c[edge]);
    return dot(way, way);
  }

  static double longestSquared(const Corners& c)
  {
    return std::max({ lengthSquared(c, 0), lengthSquared(c, 1), lengthSquared(c, 2) });
  }

  bool isBackToBack(std::size_t t, std::size_t other) const
  {
    return dot(result_.normal[t], result_.normal[other]) < MostCosineBackToBack;
  }

  const Surface& surface_;
  Features& result_;
  double leastCosine_;
  std::vector<Neighbours> neighbours_;
};

// A sharp edge or border, listed at both of its ends; from each of its triangles.
struct EdgeEnd
{
  std::uint32_t vertex;
  std::uint32_t other;

  bool operator<(const EdgeEnd& end) const { return other < end.other; }
};

// Finds where sharp edges and borders end and meet. Triangles that name a vertex twice have none.
class VertexKinds
{
public:
  VertexKinds(const Surface& surface, double featureAngle, Features& result, Execution& execution)
    : surface_(surface)
    , result_(result)
    , leastCosine_(std::cos(radians(featureAngle)))
    , execution_(execution)
  {
  }

  void find()
  {
    const std::size_t count = surface_.triangles.size();
    std::vector<std::vector<EdgeEnd>> ends(chunks(count, TrianglesAChunk));
    execution_.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
      listEnds(begin, end, ends[begin / TrianglesAChunk]);
    });
    result_.ofVertex.assign(surface_.vertices.size(), PointKind::OnSurface);
    if (std::all_of(ends.begin(), ends.end(), [](const auto& ofChunk) { return ofChunk.empty(); }))
    {
      return;
    }
    const Buckets<EdgeEnd> at = sortIntoBuckets(
      ends, surface_.vertices.size(), [](const EdgeEnd& end) { return end.vertex; }, execution_);
    execution_.forEach(
      surface_.vertices.size(), TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
        {
          result_.ofVertex[v] = kindOf(at.begin(v), at.end(v));
        }
      });
    execution_.forEach(count, TrianglesAChunk,
      [&](std::size_t begin, std::size_t end) { markTriangles(begin, end); });
  }

private:
  void listEnds(std::size_t begin, std::size_t end, std::vector<EdgeEnd>& ends) const
  {
    for (std::size_t t = begin; t < end; ++t)
    {
      const unsigned lines = result_.lines(t);
      const auto& v = surface_.triangles[t];
      for (unsigned i = 0; lines >> i != 0; ++i)
      {
        if ((lines >> i & 1) != 0 && !namesAVertexTwice(v))
        {
          ends.push_back({ v[i], following(v, i) });
          ends.push_back({ following(v, i), v[i] });
        }
      }
    }
  }

  PointKind kindOf(const EdgeEnd* begin, const EdgeEnd* end) const
  {
    std::array<Vector, 2> ways{};
    std::size_t count = 0;
    for (const EdgeEnd* edge = begin; edge != end; ++edge)
    {
      if (edge != begin && edge->other == edge[-1].other)
      {
        continue;
      }
      const Vector way =
        unit(minus(surface_.vertices[edge->other], surface_.vertices[edge->vertex]));
      if (std::any_of(ways.begin(), ways.begin() + std::ptrdiff_t(count),
            [&](const Vector& known) { return isSameWay(way, known); }))
      {
        continue;
      }
      if (count == 2)
      {
        return PointKind::Corner;
      }
      ways[count++] = way;
    }
    if (count == 0)
    {
      return PointKind::OnSurface;
    }
    return count == 1 || -dot(ways[0], ways[1]) < leastCosine_ ? PointKind::Corner
                                                               : PointKind::OnEdge;
  }

  static bool isSameWay(const Vector& a, const Vector& b)
  {
    const Vector sine = cross(a, b);
    return dot(a, b) > 0 && dot(sine, sine) <= ThickestFold * ThickestFold;
  }

  void markTriangles(std::size_t begin, std::size_t end)
  {
    for (std::size_t t = begin; t < end; ++t)
    {
      const auto& v = surface_.triangles[t];
      const PointKind most =
        std::max({ result_.ofVertex[v[0]], result_.ofVertex[v[1]], result_.ofVertex[v[2]] });
      if (most != PointKind::OnSurface && !namesAVertexTwice(v))
      {
        result_.edges[t] = static_cast<std::uint8_t>(result_.edges[t] | 128u);
      }
    }
  }

  const Surface& surface_;
  Features& result_;
  double leastCosine_;
  Execution& execution_;
};

}

Features findFeatures(const Surface& surface, double featureAngle, Execution& execution)
{
  const std::size_t count = surface.triangles.size();
  Features result;
  result.edges.resize(count);
  result.normal.resize(count);
  FeatureFinder finder(surface, featureAngle, result);
  execution.forEach(count, TrianglesAChunk,
    [&](std::size_t begin, std::size_t end) { finder.findNormals(begin, end); });
  const SurfaceEdges edges(surface, execution);
  edges.forEach(
    execution, [&](std::size_t, std::uint32_t lower, const EdgeUse* first, const EdgeUse* last) {
      finder.addEdge(lower, first, last);
    });
  execution.forEach(count, TrianglesAChunk,
    [&](std::size_t begin, std::size_t end) { finder.markEdges(begin, end); });
  VertexKinds(surface, featureAngle, result, execution).find();
  return result;
}

}

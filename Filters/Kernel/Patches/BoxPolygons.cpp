// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/BoxPolygons.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Cosine of half a degree: polygons that turn by less are of one plane, and rounded.
constexpr double OfOnePlane = 0.99996;

}

double angleBetween(const Vector& a, const Vector& b)
{
  return std::acos(std::max(-1.0, std::min(1.0, dot(a, b))));
}

NormalCone around(const NormalCone& a, const NormalCone& b)
{
  if (dot(a.axis, a.axis) == 0)
  {
    return b;
  }
  if (dot(b.axis, b.axis) == 0)
  {
    return a;
  }
  const double between = angleBetween(a.axis, b.axis);
  if (between + b.spread <= a.spread)
  {
    return a;
  }
  if (between + a.spread <= b.spread)
  {
    return b;
  }
  const double spread = (between + a.spread + b.spread) / 2;
  const double turn = between > 0 ? (spread - a.spread) / between : 0; // from a towards b
  const double sine = std::sin(between);
  if (!(sine > 1e-6))
  {
    return { unit(plus(a.axis, b.axis)), spread };
  }
  const double wa = std::sin((1 - turn) * between) / sine;
  const double wb = std::sin(turn * between) / sine;
  return { unit({ wa * a.axis[0] + wb * b.axis[0], wa * a.axis[1] + wb * b.axis[1],
             wa * a.axis[2] + wb * b.axis[2] }),
    spread };
}

void BoxPolygons::begin(const Box& box, const BoxSurface& piece, double shortestEdge)
{
  const std::vector<Point>& points = piece.points;
  shortest = shortestEdge;
  const Vector size = minus(box.high, box.low);
  shortestSide = std::min({ size[0], size[1], size[2] });
  at.clear();
  kinds = piece.kinds;
  planes.clear();
  for (const Point& p : points)
  {
    at.push_back(minus(p, box.low));
    planes.push_back(planesOf(box, p));
  }
  polygons.clear();
  corners.clear();
  if (of.size() < points.size())
  {
    of.resize(points.size());
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    of[i].clear();
  }
}

void BoxPolygons::append(
  const std::uint32_t* begin, const std::uint32_t* end, const Polygon& like, const NormalCone& cone)
{
  const auto index = static_cast<std::uint32_t>(polygons.size());
  Polygon p = like;
  p.first = corners.size();
  p.size = static_cast<std::uint32_t>(end - begin);
  p.cone = cone;
  p.alive = true;
  for (const std::uint32_t* c = begin; c != end; ++c)
  {
    corners.push_back(*c);
    of[*c].push_back(index);
  }
  polygons.push_back(p);
}

void BoxPolygons::listEdges(std::vector<PolygonEdge>& edges) const
{
  edges.clear();
  for (std::uint32_t p = 0; p < polygons.size(); ++p)
  {
    if (!polygons[p].alive)
    {
      continue;
    }
    const std::uint32_t* const c = corners.data() + polygons[p].first;
    for (std::uint32_t i = 0; i < polygons[p].size; ++i)
    {
      const std::uint32_t a = c[i];
      const std::uint32_t b = c[i + 1 < polygons[p].size ? i + 1 : 0];
      edges.push_back({ std::min(a, b), std::max(a, b), p, a > b });
    }
  }
  std::sort(edges.begin(), edges.end(), [](const PolygonEdge& a, const PolygonEdge& b) {
    return a.lower != b.lower ? a.lower < b.lower
                              : (a.upper != b.upper ? a.upper < b.upper : a.polygon < b.polygon);
  });
}

bool BoxPolygons::isSliver(const Polygon& p) const
{
  const std::uint32_t* const c = cornersOf(p);
  double longest = 0;
  for (std::uint32_t i = 0; i < p.size; ++i)
  {
    longest = std::max(longest, edgeLength(c[i], c[i + 1 < p.size ? i + 1 : 0]));
  }
  return 2 * norm(areaVector(c, c + p.size)) < shortest * longest;
}

bool BoxPolygons::isSharp(const Surface& surface, const Polygon& p, const Polygon& q,
  std::uint32_t from, std::uint32_t to, double featureCosine) const
{
  const double cosine = dot(p.cone.axis, q.cone.axis);
  if (!surface.knownEdges)
  {
    return cosine < featureCosine;
  }
  return cosine < OfOnePlane && !kinds.empty() &&
    std::min(kinds[from], kinds[to]) >= PointKind::OnEdge;
}

Vector BoxPolygons::areaVector(const std::uint32_t* begin, const std::uint32_t* end) const
{
  Vector sum{ 0, 0, 0 };
  for (const std::uint32_t* c = begin + 1; c + 1 < end; ++c)
  {
    sum = plus(sum, cross(minus(at[*c], at[*begin]), minus(at[c[1]], at[*begin])));
  }
  return { sum[0] / 2, sum[1] / 2, sum[2] / 2 };
}

std::size_t endOfEqual(const std::vector<PolygonEdge>& edges, std::size_t i)
{
  std::size_t end = i + 1;
  while (end < edges.size() && edges[i].sameEdge(edges[end]))
  {
    ++end;
  }
  return end;
}

}

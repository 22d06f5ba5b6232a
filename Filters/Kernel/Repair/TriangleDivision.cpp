// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/TriangleDivision.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Tries for each edge that lies across a new one: a bound that is not met where rounding has turned a
// triangle over.
constexpr std::size_t MostFlips = 64;

}

TriangleDivision::TriangleDivision(
  const std::vector<Point>& vertices, const Triple& triangle, int axis)
  : vertices_(vertices)
  , axis_(axis)
  , triangles_(1, triangle)
  , points_(triangle.begin(), triangle.end())
{
  way_ = turnOf(triangle[0], triangle[1], triangle[2]);
  for (std::size_t i = 0; i < 3; ++i)
  {
    onEdge_[i] = { triangle[i], triangle[(i + 1) % 3] };
  }
}

PlanePoint TriangleDivision::at(std::uint32_t point) const
{
  return flatten(vertices_[point], axis_);
}

// 1 if the points turn as the triangle's corners do.
int TriangleDivision::turnOf(std::uint32_t p, std::uint32_t q, std::uint32_t r) const
{
  return way_ * sign(turn(at(p), at(q), at(r)));
}

bool TriangleDivision::find(std::uint32_t from, std::uint32_t to, EdgeAt& at) const
{
  for (std::size_t t = 0; t < triangles_.size(); ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (triangles_[t][i] == from && triangles_[t][(i + 1) % 3] == to)
      {
        at = { t, i };
        return true;
      }
    }
  }
  return false;
}

bool TriangleDivision::hasEdge(std::uint32_t from, std::uint32_t to) const
{
  EdgeAt at{};
  return find(from, to, at) || find(to, from, at);
}

void TriangleDivision::divideEdge(std::size_t i, const std::vector<std::uint32_t>& points)
{
  std::uint32_t from = onEdge_[i].front();
  const std::uint32_t to = onEdge_[i].back();
  for (const std::uint32_t point : points)
  {
    EdgeAt edge{};
    if (!find(from, to, edge))
    {
      return;
    }
    Triple& first = triangles_[edge.triangle];
    Triple second = first;
    first[(edge.corner + 1) % 3] = point;
    second[edge.corner] = point;
    triangles_.push_back(second);
    onEdge_[i].insert(onEdge_[i].end() - 1, point);
    points_.push_back(point);
    from = point;
  }
}

void TriangleDivision::addPoint(std::uint32_t point)
{
  if (std::find(points_.begin(), points_.end(), point) != points_.end())
  {
    return;
  }
  for (std::size_t t = 0; t < triangles_.size(); ++t)
  {
    const Triple whole = triangles_[t];
    std::array<int, 3> side;
    for (std::size_t i = 0; i < 3; ++i)
    {
      side[i] = turnOf(whole[i], whole[(i + 1) % 3], point);
    }
    if (*std::min_element(side.begin(), side.end()) < 0)
    {
      continue;
    }
    // On an edge, the triangle beyond it is divided too.
    triangles_.erase(triangles_.begin() + static_cast<std::ptrdiff_t>(t));
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t from = whole[i];
      const std::uint32_t to = whole[(i + 1) % 3];
      EdgeAt beyond{};
      if (side[i] > 0)
      {
        triangles_.push_back({ from, to, point });
      }
      else if (find(to, from, beyond))
      {
        Triple& first = triangles_[beyond.triangle];
        Triple second = first;
        first[(beyond.corner + 1) % 3] = point;
        second[beyond.corner] = point;
        triangles_.push_back(second);
      }
    }
    points_.push_back(point);
    return;
  }
}

bool TriangleDivision::areOnOneEdge(std::uint32_t p, std::uint32_t q) const
{
  return std::any_of(onEdge_.begin(), onEdge_.end(), [&](const std::vector<std::uint32_t>& edge) {
    return std::find(edge.begin(), edge.end(), p) != edge.end() &&
      std::find(edge.begin(), edge.end(), q) != edge.end();
  });
}

// A point on the line between two others, or None.
std::uint32_t TriangleDivision::pointBetween(std::uint32_t from, std::uint32_t to) const
{
  const PlanePoint p = at(from);
  const PlanePoint q = at(to);
  for (const std::uint32_t point : points_)
  {
    const PlanePoint x = at(point);
    const auto along =
      static_cast<Wide>(x.a - p.a) * (q.a - p.a) + static_cast<Wide>(x.b - p.b) * (q.b - p.b);
    const auto back =
      static_cast<Wide>(x.a - q.a) * (p.a - q.a) + static_cast<Wide>(x.b - q.b) * (p.b - q.b);
    if (point != from && point != to && along > 0 && back > 0 && turn(p, q, x) == 0)
    {
      return point;
    }
  }
  return None;
}

void TriangleDivision::addEdge(std::uint32_t from, std::uint32_t to)
{
  if (from == to || areOnOneEdge(from, to) || hasEdge(from, to))
  {
    return;
  }
  if (const std::uint32_t between = pointBetween(from, to); between != None)
  {
    addEdge(from, between);
    addEdge(between, to);
    return;
  }
  // Those that cannot be flipped yet wait for others (Sloan 1993).
  std::deque<std::array<std::uint32_t, 2>> crossing = edgesAcross(from, to);
  for (std::size_t left = MostFlips * crossing.size(); !crossing.empty() && left > 0; --left)
  {
    const auto [p, q] = crossing.front();
    crossing.pop_front();
    std::array<std::uint32_t, 2> now{ p, q };
    if (!flip(now) || crosses(now[0], now[1], from, to))
    {
      crossing.push_back(now);
    }
  }
}

bool TriangleDivision::crosses(
  std::uint32_t p, std::uint32_t q, std::uint32_t from, std::uint32_t to) const
{
  return p != from && p != to && q != from && q != to &&
    turnOf(from, to, p) * turnOf(from, to, q) < 0 && turnOf(p, q, from) * turnOf(p, q, to) < 0;
}

std::deque<std::array<std::uint32_t, 2>> TriangleDivision::edgesAcross(
  std::uint32_t from, std::uint32_t to) const
{
  std::deque<std::array<std::uint32_t, 2>> edges;
  for (const Triple& t : triangles_)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t p = t[i];
      const std::uint32_t q = t[(i + 1) % 3];
      if (p < q && crosses(p, q, from, to))
      {
        edges.push_back({ p, q });
      }
    }
  }
  return edges;
}

// Replaces an edge by the other diagonal of the two triangles beside it, if these form a convex quadrangle.
bool TriangleDivision::flip(std::array<std::uint32_t, 2>& edge)
{
  EdgeAt here{};
  EdgeAt beyond{};
  if (!find(edge[0], edge[1], here) || !find(edge[1], edge[0], beyond))
  {
    return false;
  }
  const auto [p, q] = edge;
  const std::uint32_t r = triangles_[here.triangle][(here.corner + 2) % 3];
  const std::uint32_t s = triangles_[beyond.triangle][(beyond.corner + 2) % 3];
  if (turnOf(r, p, s) <= 0 || turnOf(s, q, r) <= 0)
  {
    return false;
  }
  triangles_[here.triangle] = { r, p, s };
  triangles_[beyond.triangle] = { s, q, r };
  edge = { r, s };
  return true;
}

}

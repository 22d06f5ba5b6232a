// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/TriangleDivision.h"

#include "Lattice/Vector.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Tries for each edge that lies across a new one: a bound that is not met where rounding has turned a
// triangle over.
constexpr std::size_t MostFlips = 64;

// The sign of the sum of products of numbers below 2^70 each.
class ProductSum
{
public:
  void add(Wide a, Wide b)
  {
    constexpr Wide low = 0xffffffff;
    high_ += a * (b >> 32);
    low_ += a * (b & low);
  }

  int signOfSum() const
  {
    const Wide high = high_ + (low_ >> 32);
    return high != 0 ? sign(high) : sign(low_ & 0xffffffff);
  }

private:
  Wide high_ = 0; // of 2^32
  Wide low_ = 0;
};

// 1 if d lies within the circle through a, b and c, which are counter-clockwise; 0 on it; exact.
int inCircle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  const std::array<PlanePoint, 3> from = { PlanePoint{ a.a - d.a, a.b - d.b },
    PlanePoint{ b.a - d.a, b.b - d.b }, PlanePoint{ c.a - d.a, c.b - d.b } };
  ProductSum sum;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const PlanePoint& p = from[i];
    const PlanePoint& q = from[(i + 1) % 3];
    const PlanePoint& r = from[(i + 2) % 3];
    sum.add(static_cast<Wide>(p.a) * p.a + static_cast<Wide>(p.b) * p.b,
      static_cast<Wide>(q.a) * r.b - static_cast<Wide>(q.b) * r.a);
  }
  return sum.signOfSum();
}

}

TriangleDivision::TriangleDivision(
  const std::vector<Point>& vertices, const Triple& triangle, int axis, double reach)
  : vertices_(vertices)
  , axis_(axis)
  , reach_(reach)
  , triangles_(1)
  , points_(triangle.begin(), triangle.end())
  , isPoint_(triangle.begin(), triangle.end())
{
  set(0, triangle);
  way_ = turnOf(triangle[0], triangle[1], triangle[2]);
  for (std::size_t i = 0; i < 3; ++i)
  {
    onEdge_[i] = { triangle[i], triangle[(i + 1) % 3] };
  }
}

// 1 if the points turn as the triangle's corners do.
int TriangleDivision::turnOf(std::uint32_t p, std::uint32_t q, std::uint32_t r) const
{
  return way_ * sign(turn(at(p), at(q), at(r)));
}

bool TriangleDivision::hasPoint(std::uint32_t point) const
{
  return isPoint_.count(point) != 0;
}

bool TriangleDivision::hasEdge(std::uint32_t from, std::uint32_t to) const
{
  return triangleAt_.count(keyOf(from, to)) != 0 || triangleAt_.count(keyOf(to, from)) != 0;
}

// The corner that faces an edge in the triangle around which it runs, or None.
std::uint32_t TriangleDivision::across(std::uint32_t from, std::uint32_t to) const
{
  const auto found = triangleAt_.find(keyOf(from, to));
  if (found == triangleAt_.end())
  {
    return None;
  }
  const Triple& t = triangles_[found->second];
  return t[0] ^ t[1] ^ t[2] ^ from ^ to;
}

void TriangleDivision::set(std::size_t triangle, const Triple& corners)
{
  triangles_[triangle] = corners;
  for (std::size_t i = 0; i < 3; ++i)
  {
    triangleAt_[keyOf(corners[i], corners[(i + 1) % 3])] = static_cast<std::uint32_t>(triangle);
  }
}

// Puts a point on an edge of one triangle.
void TriangleDivision::divideAt(std::uint32_t from, std::uint32_t to, std::uint32_t point)
{
  const auto found = triangleAt_.find(keyOf(from, to));
  if (found == triangleAt_.end())
  {
    return;
  }
  const std::size_t triangle = found->second;
  const std::uint32_t apex = across(from, to);
  triangleAt_.erase(found);
  triangles_.emplace_back();
  set(triangle, { from, point, apex });
  set(triangles_.size() - 1, { point, to, apex });
}

void TriangleDivision::divideEdge(std::size_t i, const std::vector<std::uint32_t>& points)
{
  std::uint32_t from = onEdge_[i].front();
  const std::uint32_t to = onEdge_[i].back();
  for (const std::uint32_t point : points)
  {
    divideAt(from, to, point);
    onEdge_[i].insert(onEdge_[i].end() - 1, point);
    points_.push_back(point);
    isPoint_.insert(point);
    from = point;
  }
}

void TriangleDivision::addPoint(std::uint32_t point)
{
  if (hasPoint(point))
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
    bool isFirst = true;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t from = whole[i];
      const std::uint32_t to = whole[(i + 1) % 3];
      if (side[i] > 0)
      {
        if (!isFirst)
        {
          triangles_.emplace_back();
        }
        set(isFirst ? t : triangles_.size() - 1, { from, to, point });
        isFirst = false;
      }
      else
      {
        triangleAt_.erase(keyOf(from, to));
        divideAt(to, from, point);
      }
    }
    points_.push_back(point);
    isPoint_.insert(point);
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

// The first point from there on the line between two others, within the reach; or None.
std::uint32_t TriangleDivision::pointBetween(std::uint32_t from, std::uint32_t to) const
{
  const PlanePoint p = at(from);
  const PlanePoint q = at(to);
  const auto x = static_cast<double>(q.a - p.a);
  const auto y = static_cast<double>(q.b - p.b);
  const double length = std::hypot(x, y);
  std::uint32_t first = None;
  double least = length - reach_;
  for (const std::uint32_t point : points_)
  {
    const PlanePoint r = at(point);
    const double along =
      (static_cast<double>(r.a - p.a) * x + static_cast<double>(r.b - p.b) * y) / length;
    if (point == from || point == to || along <= reach_ || along >= least)
    {
      continue;
    }
    const Wide area = turn(p, q, r);
    if (area == 0 || std::abs(static_cast<double>(area)) < reach_ * length)
    {
      first = point;
      least = along;
    }
  }
  return first;
}

void TriangleDivision::addEdge(std::uint32_t from, std::uint32_t to)
{
  if (from == to || !hasPoint(from) || !hasPoint(to) || areOnOneEdge(from, to))
  {
    return;
  }
  if (!hasEdge(from, to))
  {
    if (const std::uint32_t between = pointBetween(from, to); between != None)
    {
      addEdge(from, between);
      addEdge(between, to);
      return;
    }
    std::deque<Edge> crossing;
    if (!findAcross(from, to, crossing))
    {
      return;
    }
    // Those that cannot be flipped yet wait for others (Sloan 1993).
    for (std::size_t left = MostFlips * crossing.size(); !crossing.empty() && left > 0; --left)
    {
      Edge edge = crossing.front();
      crossing.pop_front();
      if (!flip(edge) || crosses(edge[0], edge[1], from, to))
      {
        crossing.push_back(edge);
      }
    }
  }
  fixed_.insert(keyOfEither(from, to));
}

// The edges that lie across a new one; false if one of them has to stay.
bool TriangleDivision::findAcross(
  std::uint32_t from, std::uint32_t to, std::deque<Edge>& crossing) const
{
  for (const Triple& t : triangles_)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t p = t[i];
      const std::uint32_t q = t[(i + 1) % 3];
      if (p < q && crosses(p, q, from, to))
      {
        if (isFixed(p, q))
        {
          return false;
        }
        crossing.push_back({ p, q });
      }
    }
  }
  return true;
}

bool TriangleDivision::crosses(
  std::uint32_t p, std::uint32_t q, std::uint32_t from, std::uint32_t to) const
{
  return p != from && p != to && q != from && q != to &&
    turnOf(from, to, p) * turnOf(from, to, q) < 0 && turnOf(p, q, from) * turnOf(p, q, to) < 0;
}

// Replaces an edge by the other diagonal of the two triangles beside it, if these form a convex quadrangle.
bool TriangleDivision::flip(Edge& edge)
{
  const auto [p, q] = edge;
  const std::uint32_t r = across(p, q);
  const std::uint32_t s = across(q, p);
  if (r == None || s == None || turnOf(r, p, s) <= 0 || turnOf(s, q, r) <= 0)
  {
    return false;
  }
  const std::uint32_t here = triangleAt_.at(keyOf(p, q));
  const std::uint32_t beyond = triangleAt_.at(keyOf(q, p));
  triangleAt_.erase(keyOf(p, q));
  triangleAt_.erase(keyOf(q, p));
  set(here, { r, p, s });
  set(beyond, { s, q, r });
  edge = { r, s };
  return true;
}

bool TriangleDivision::isBetterFlipped(std::uint32_t from, std::uint32_t to) const
{
  const std::uint32_t r = across(from, to);
  const std::uint32_t s = across(to, from);
  if (r == None || s == None || isFixed(from, to) || turnOf(r, from, s) <= 0 ||
    turnOf(s, to, r) <= 0)
  {
    return false;
  }
  const int in = way_ * inCircle(at(from), at(to), at(r), at(s));
  const auto lower = [&](std::uint32_t p, std::uint32_t q) {
    return std::min(vertices_[p], vertices_[q]);
  };
  return in > 0 || (in == 0 && lower(r, s) < lower(from, to));
}

const std::vector<TriangleDivision::Triple>& TriangleDivision::finish()
{
  std::deque<Edge> edges;
  for (const Triple& t : triangles_)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (t[i] < t[(i + 1) % 3])
      {
        edges.push_back({ t[i], t[(i + 1) % 3] });
      }
    }
  }
  for (std::size_t left = MostFlips * edges.size(); !edges.empty() && left > 0; --left)
  {
    Edge edge = edges.front();
    edges.pop_front();
    if (!isBetterFlipped(edge[0], edge[1]))
    {
      continue;
    }
    const Edge was = edge;
    flip(edge);
    for (const std::uint32_t p : was)
    {
      for (const std::uint32_t q : edge)
      {
        edges.push_back({ p, q });
      }
    }
  }
  return triangles_;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/TriangleDivision.h"

#include "Base/Rings.h"
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
    const PlanePoint& q = following(from, i);
    const PlanePoint& r = preceding(from, i);
    sum.add(static_cast<Wide>(p.a) * p.a + static_cast<Wide>(p.b) * p.b,
      static_cast<Wide>(q.a) * r.b - static_cast<Wide>(q.b) * r.a);
  }
  return sum.signOfSum();
}

Wide squaredDistance(const PlanePoint& p, const PlanePoint& q)
{
  return static_cast<Wide>(q.a - p.a) * (q.a - p.a) + static_cast<Wide>(q.b - p.b) * (q.b - p.b);
}

}

TriangleDivision::TriangleDivision(
  const std::vector<Point>& vertices, const Triple& triangle, int axis, const Spec& spec)
  : vertices_(vertices)
  , axis_(axis)
  , spec_(spec)
  , triangles_(1)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    edgesOf_[add(triangle[i])] = static_cast<std::uint8_t>((1U << i) | (1U << (i + 2) % 3));
  }
  set(0, { 0, 1, 2 });
  way_ = turnOf(0, 1, 2);
}

std::uint32_t TriangleDivision::add(std::uint32_t vertex)
{
  const auto point = static_cast<std::uint32_t>(points_.size());
  points_.push_back(vertex);
  at_.push_back(flatten(vertices_[vertex], axis_));
  edgesOf_.push_back(0);
  besides_.push_back(None);
  numberOf_.emplace(vertex, point);
  return point;
}

// 1 if the points turn as the triangle's corners do.
int TriangleDivision::turnOf(std::uint32_t p, std::uint32_t q, std::uint32_t r) const
{
  return way_ * sign(turn(at_[p], at_[q], at_[r]));
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
    const std::uint32_t next = following(corners, i);
    triangleAt_[keyOf(corners[i], next)] = static_cast<std::uint32_t>(triangle);
    besides_[corners[i]] = next;
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

void TriangleDivision::divideEdge(std::size_t i, const std::vector<std::uint32_t>& vertices)
{
  auto from = static_cast<std::uint32_t>(i);
  const auto to = static_cast<std::uint32_t>((i + 1) % 3);
  for (const std::uint32_t vertex : vertices)
  {
    // One that is a corner, or on another edge, gets another point: what is between them is left out in the end.
    const std::uint32_t point = add(vertex);
    divideAt(from, to, point);
    edgesOf_[numberOf_.at(vertex)] |= static_cast<std::uint8_t>(1U << i);
    from = point;
  }
}

// Whether a place is in a triangle with an area, and not on the border.
bool TriangleDivision::isIn(std::uint32_t triangle, const PlanePoint& place) const
{
  const Triple& t = triangles_[triangle];
  bool is = true;
  bool isAside = false;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::uint32_t p = t[i];
    const std::uint32_t q = following(t, i);
    const int side = way_ * sign(turn(at_[p], at_[q], place));
    is = is && (side > 0 || (side == 0 && triangleAt_.count(keyOf(q, p)) != 0));
    isAside = isAside || side > 0;
  }
  return is && isAside;
}

// The triangle in which a place is, or None: walks there from the last one. Where rounding has turned triangles over,
// that may lead nowhere: then looks at all.
std::uint32_t TriangleDivision::triangleAround(const PlanePoint& place) const
{
  auto t = static_cast<std::uint32_t>(triangles_.size() - 1);
  for (std::size_t left = triangles_.size(); left > 0; --left)
  {
    std::uint32_t next = t;
    for (std::size_t i = 0; i < 3 && next == t; ++i)
    {
      const std::uint32_t p = triangles_[t][i];
      const std::uint32_t q = following(triangles_[t], i);
      if (way_ * sign(turn(at_[p], at_[q], place)) < 0)
      {
        const auto beyond = triangleAt_.find(keyOf(q, p));
        next = beyond != triangleAt_.end() ? beyond->second : None;
      }
    }
    if (next == t && isIn(t, place))
    {
      return t;
    }
    if (next == t || next == None)
    {
      break;
    }
    t = next;
  }
  for (t = 0; t < triangles_.size(); ++t)
  {
    if (isIn(t, place))
    {
      return t;
    }
  }
  return None;
}

void TriangleDivision::addPoint(std::uint32_t vertex)
{
  if (numberOf_.count(vertex) != 0)
  {
    return;
  }
  const std::uint32_t triangle = triangleAround(flatten(vertices_[vertex], axis_));
  if (triangle != None)
  {
    addInside(triangle, add(vertex));
  }
}

void TriangleDivision::addInside(std::uint32_t triangle, std::uint32_t point)
{
  const Triple whole = triangles_[triangle];
  std::deque<Edge> around;
  bool isFirst = true;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::uint32_t from = whole[i];
    const std::uint32_t to = following(whole, i);
    if (turnOf(from, to, point) > 0)
    {
      if (!isFirst)
      {
        triangles_.emplace_back();
      }
      set(isFirst ? triangle : triangles_.size() - 1, { from, to, point });
      isFirst = false;
      around.push_back({ from, to });
      continue;
    }
    // On an edge, the triangle beyond it is divided too.
    triangleAt_.erase(keyOf(from, to));
    const std::uint32_t apex = across(to, from);
    around.push_back({ to, apex });
    around.push_back({ apex, from });
    divideAt(to, from, point);
  }
  improve(around, MostFlips * around.size());
}

// The first point from there on the line between two others, within the reach; or None. Both ends are nearer to it
// than to each other, by their exact places: so edges come to an end.
std::uint32_t TriangleDivision::pointBetween(std::uint32_t from, std::uint32_t to) const
{
  const PlanePoint p = at_[from];
  const PlanePoint q = at_[to];
  const auto x = static_cast<double>(q.a - p.a);
  const auto y = static_cast<double>(q.b - p.b);
  const double length = std::hypot(x, y);
  const Wide whole = squaredDistance(p, q);
  std::uint32_t first = None;
  double least = length - spec_.reach;
  tree_->forEachNear(p, q, spec_.reach, [&](std::uint32_t point) {
    const PlanePoint r = at_[point];
    if (squaredDistance(p, r) >= whole || squaredDistance(r, q) >= whole)
    {
      return;
    }
    const double along =
      (static_cast<double>(r.a - p.a) * x + static_cast<double>(r.b - p.b) * y) / length;
    const bool isSooner = along < least || (along == least && point < first && first != None);
    const Wide area = turn(p, q, r);
    if (along > spec_.reach && isSooner &&
      (area == 0 || std::abs(static_cast<double>(area)) < spec_.reach * length) &&
      numberOf_.at(points_[point]) == point)
    {
      first = point;
      least = along;
    }
  });
  return first;
}

void TriangleDivision::addEdge(std::uint32_t from, std::uint32_t to)
{
  const auto first = numberOf_.find(from);
  const auto last = numberOf_.find(to);
  if (first == numberOf_.end() || last == numberOf_.end())
  {
    return;
  }
  if (!tree_)
  {
    tree_ = std::make_unique<PointTree>(at_);
  }
  std::uint32_t here = first->second;
  std::vector<std::uint32_t> ahead{ last->second };
  while (!ahead.empty())
  {
    const std::uint32_t next = ahead.back();
    if (here != next && !areOnOneEdge(here, next))
    {
      const std::uint32_t between = hasEdge(here, next) ? None : pointBetween(here, next);
      if (between != None)
      {
        ahead.push_back(between);
        continue;
      }
      if (hasEdge(here, next) || addPiece(here, next))
      {
        fixed_.insert(keyOfEither(here, next));
      }
    }
    here = next;
    ahead.pop_back();
  }
}

// Lets an edge run between two points with none between them; false if it would cross one that has to stay.
bool TriangleDivision::addPiece(std::uint32_t from, std::uint32_t to)
{
  std::deque<Edge> crossing;
  if (!findAcross(from, to, crossing))
  {
    return false;
  }
  // Those that cannot be flipped yet wait for others (Sloan 1993).
  std::deque<Edge> flipped;
  for (std::size_t left = MostFlips * crossing.size(); !crossing.empty() && left > 0; --left)
  {
    Edge edge = crossing.front();
    crossing.pop_front();
    if (!flip(edge) || crosses(edge[0], edge[1], from, to))
    {
      crossing.push_back(edge);
    }
    else if (keyOfEither(edge[0], edge[1]) != keyOfEither(from, to))
    {
      flipped.push_back(edge);
    }
  }
  fixed_.insert(keyOfEither(from, to));
  improve(flipped, MostFlips * flipped.size());
  return true;
}

// The edge across which one leaves a point's triangles on the line between two others, to the right end first; or
// none.
TriangleDivision::Edge TriangleDivision::firstAcross(
  std::uint32_t at, std::uint32_t from, std::uint32_t to) const
{
  for (const bool isBack : { false, true })
  {
    std::uint32_t p = besides_[at];
    for (std::size_t left = triangles_.size(); left > 0 && p != None; --left)
    {
      const std::uint32_t q = isBack ? across(p, at) : across(at, p);
      const Edge edge = isBack ? Edge{ q, p } : Edge{ p, q };
      if (q != None && turnOf(from, to, edge[0]) < 0 && turnOf(from, to, edge[1]) > 0 &&
        turnOf(at, edge[0], edge[1]) > 0)
      {
        return edge;
      }
      p = q != besides_[at] ? q : None;
    }
  }
  return { None, None };
}

// The edges that lie across a new one; false if one of them has to stay, or rounding has turned triangles over.
bool TriangleDivision::findAcross(
  std::uint32_t from, std::uint32_t to, std::deque<Edge>& crossing) const
{
  std::uint32_t at = from;
  Edge edge = firstAcross(at, from, to);
  for (std::size_t left = triangles_.size(); left > 0 && edge[0] != None; --left)
  {
    if (isFixed(edge[0], edge[1]))
    {
      return false;
    }
    crossing.push_back(edge);
    at = across(edge[1], edge[0]);
    if (at == to)
    {
      return true;
    }
    if (at == None)
    {
      return false;
    }
    const int side = turnOf(from, to, at);
    if (side == 0)
    {
      edge = firstAcross(at, from, to);
    }
    else
    {
      edge[side > 0 ? 1 : 0] = at;
    }
  }
  return false;
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
  if (r == None || s == None || turnOf(r, p, s) <= 0 || turnOf(s, q, r) <= 0 || hasEdge(r, s))
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
  const bool isSliver = areOnOneEdge(from, to, r) || areOnOneEdge(from, to, s);
  const bool makesSliver = areOnOneEdge(r, s, from) || areOnOneEdge(r, s, to);
  if (spec_.keepsEdges && isSliver != makesSliver)
  {
    return isSliver;
  }
  const int in = way_ * inCircle(at_[from], at_[to], at_[r], at_[s]);
  const auto lower = [&](std::uint32_t p, std::uint32_t q) {
    return std::min(vertices_[points_[p]], vertices_[points_[q]]);
  };
  return in > 0 || (in == 0 && lower(r, s) < lower(from, to));
}

// Flips edges, and those around them in turn, as long as that makes the division better, but not more than so many.
void TriangleDivision::improve(std::deque<Edge>& edges, std::size_t most)
{
  for (; !edges.empty() && most > 0; --most)
  {
    Edge edge = edges.front();
    edges.pop_front();
    const Edge was = edge;
    if (!isBetterFlipped(edge[0], edge[1]) || !flip(edge))
    {
      continue;
    }
    for (const std::uint32_t p : was)
    {
      for (const std::uint32_t q : edge)
      {
        edges.push_back({ p, q });
      }
    }
  }
}

std::vector<TriangleDivision::Triple> TriangleDivision::finish()
{
  std::deque<Edge> edges;
  for (const Triple& t : triangles_)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (t[i] < following(t, i))
      {
        edges.push_back({ t[i], following(t, i) });
      }
    }
  }
  improve(edges, MostFlips * edges.size());
  std::vector<Triple> result;
  result.reserve(triangles_.size());
  for (const Triple& t : triangles_)
  {
    result.push_back({ points_[t[0]], points_[t[1]], points_[t[2]] });
  }
  return result;
}

}

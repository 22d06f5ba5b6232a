// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/StarPolygons.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cartesian
{

namespace
{

struct PlaneVector
{
  double a;
  double b;
};

PlaneVector minus(const PlanePoint& p, const PlanePoint& q)
{
  return { static_cast<double>(p.a - q.a), static_cast<double>(p.b - q.b) };
}

double cross(const PlaneVector& u, const PlaneVector& v)
{
  return u.a * v.b - u.b * v.a;
}

double distance2(const PlanePoint& p, const PlanePoint& q)
{
  const PlaneVector d = minus(p, q);
  return d.a * d.a + d.b * d.b;
}

bool same(const PlanePoint& p, const PlanePoint& q)
{
  return p.a == q.a && p.b == q.b;
}

bool between(const PlanePoint& p, const PlanePoint& q, const PlanePoint& x)
{
  return std::min(p.a, q.a) <= x.a && x.a <= std::max(p.a, q.a) && std::min(p.b, q.b) <= x.b &&
    x.b <= std::max(p.b, q.b);
}

// Whether segments pq and rs share a point other than one common end.
bool obstructs(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r, const PlanePoint& s)
{
  if ((same(p, r) && same(q, s)) || (same(p, s) && same(q, r)))
  {
    return true;
  }
  const int pqr = sign(turn(p, q, r));
  const int pqs = sign(turn(p, q, s));
  const int rsp = sign(turn(r, s, p));
  const int rsq = sign(turn(r, s, q));
  if (pqr * pqs < 0 && rsp * rsq < 0)
  {
    return true;
  }
  const auto touches = [](int t, const PlanePoint& u, const PlanePoint& v, const PlanePoint& x) {
    return t == 0 && between(u, v, x) && !same(u, x) && !same(v, x);
  };
  return touches(pqr, p, q, r) || touches(pqs, p, q, s) || touches(rsp, r, s, p) ||
    touches(rsq, r, s, q);
}

// Whether segments pq and rs lie apart along an axis: nearly all do, where there are many.
bool areApart(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r, const PlanePoint& s)
{
  return std::max(p.a, q.a) < std::min(r.a, s.a) || std::max(r.a, s.a) < std::min(p.a, q.a) ||
    std::max(p.b, q.b) < std::min(r.b, s.b) || std::max(r.b, s.b) < std::min(p.b, q.b);
}

bool obstructed(const std::vector<PlanePoint>& at, const PlanePoint& p, const PlanePoint& q)
{
  for (std::size_t i = 0; i < at.size(); ++i)
  {
    const PlanePoint& next = at[i + 1 < at.size() ? i + 1 : 0];
    if (!areApart(p, q, at[i], next) && obstructs(p, q, at[i], next))
    {
      return true;
    }
  }
  return false;
}

// Whether x lies in the interior angle at corner p, between the neighbours `before` and `after`.
bool inCone(
  const PlanePoint& before, const PlanePoint& p, const PlanePoint& after, const PlanePoint& x)
{
  const bool leftOfOut = turn(p, after, x) > 0;
  const bool leftOfIn = turn(before, p, x) > 0;
  return turn(before, p, after) > 0 ? leftOfOut && leftOfIn : leftOfOut || leftOfIn;
}

// By how much the interior angle at corner i exceeds 180 degrees, in radians; negative if it is
// convex.
double concavity(const std::vector<PlanePoint>& at, std::size_t i)
{
  const std::size_t n = at.size();
  const PlanePoint& p = at[i];
  const PlaneVector in = minus(p, at[(i + n - 1) % n]);
  const PlaneVector out = minus(at[(i + 1) % n], p);
  return -std::atan2(cross(in, out), in.a * out.a + in.b * out.b);
}

std::size_t mostConcave(const std::vector<PlanePoint>& at)
{
  std::size_t worst = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < at.size(); ++i)
  {
    const double c = concavity(at, i);
    if (c > most)
    {
      most = c;
      worst = i;
    }
  }
  return worst;
}

struct Diagonal
{
  std::size_t to = 0;
  bool heals = false; // leaves no concave angle where it starts
  double length2 = std::numeric_limits<double>::infinity();
  bool found = false;

  bool betterThan(const Diagonal& other) const
  {
    return heals != other.heals ? heals : length2 < other.length2;
  }
};

// The optimal diagonal from corner i, unless no diagonal is possible.
Diagonal optimalDiagonal(const std::vector<PlanePoint>& at, std::size_t i)
{
  const std::size_t n = at.size();
  const PlanePoint& p = at[i];
  const PlanePoint& before = at[(i + n - 1) % n];
  const PlanePoint& after = at[(i + 1) % n];
  Diagonal best;
  for (std::size_t step = 2; step + 1 < n; ++step)
  {
    Diagonal d;
    d.to = (i + step) % n;
    const PlanePoint& q = at[d.to];
    d.heals = turn(before, p, q) >= 0 && turn(q, p, after) >= 0;
    d.length2 = distance2(p, q);
    d.found = true;
    if (!same(p, q) && (!best.found || d.betterThan(best)) && inCone(before, p, after, q) &&
      inCone(at[(d.to + n - 1) % n], q, at[(d.to + 1) % n], p) && !obstructed(at, p, q))
    {
      best = d;
    }
  }
  return best;
}

// Reveals a bridge that isStar misses because of rounding: its nodes occur twice.
bool areDistinct(const std::vector<std::uint32_t>& nodes)
{
  constexpr std::size_t Many = 64; // so many take longer to compare in pairs than to sort
  if (nodes.size() > Many)
  {
    std::vector<std::uint32_t> sorted = nodes;
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  }
  for (auto node = nodes.begin(); node != nodes.end(); ++node)
  {
    if (std::find(nodes.begin(), node, *node) != node)
    {
      return false;
    }
  }
  return true;
}

// A polygon that intersects itself (by rounding) may have no diagonal: any choice will do.
std::size_t anyDiagonal(std::size_t i, std::size_t corners)
{
  return (i + corners / 2) % corners;
}

FlatPolygon part(const FlatPolygon& polygon, std::size_t from, std::size_t to)
{
  FlatPolygon result;
  const std::size_t n = polygon.nodes.size();
  for (std::size_t i = from;; i = (i + 1) % n)
  {
    result.nodes.push_back(polygon.nodes[i]);
    result.at.push_back(polygon.at[i]);
    if (i == to)
    {
      return result;
    }
  }
}

PlanePoint rightmost(const FlatPolygon& polygon)
{
  return *std::max_element(polygon.at.begin(), polygon.at.end(),
    [](const PlanePoint& p, const PlanePoint& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
}

// Whether x lies in the interior angle at corner i.
bool inCone(const std::vector<PlanePoint>& at, std::size_t i, const PlanePoint& x)
{
  const std::size_t n = at.size();
  return inCone(at[(i + n - 1) % n], at[i], at[(i + 1) % n], x);
}

// An edge from a corner of the polygon to a corner of the hole.
struct Bridge
{
  double length2;
  std::size_t outer;
  std::size_t inner;

  bool operator<(const Bridge& other) const
  {
    return length2 != other.length2
      ? length2 < other.length2
      : (outer != other.outer ? outer < other.outer : inner < other.inner);
  }
};

// Whether the bridge runs inside the polygon and outside of all holes. Where other holes were
// joined, a corner occurs several times, and only one of them is right.
bool runsInside(const Bridge& bridge, const FlatPolygon& polygon, const FlatPolygon& hole,
  const std::vector<FlatPolygon>& others)
{
  const PlanePoint& p = polygon.at[bridge.outer];
  const PlanePoint& q = hole.at[bridge.inner];
  const std::size_t n = hole.at.size();
  if (same(p, q))
  {
    return inCone(polygon.at, bridge.outer, hole.at[(bridge.inner + 1) % n]) &&
      inCone(polygon.at, bridge.outer, hole.at[(bridge.inner + n - 1) % n]);
  }
  return inCone(polygon.at, bridge.outer, q) && inCone(hole.at, bridge.inner, p) &&
    !obstructed(polygon.at, p, q) && !obstructed(hole.at, p, q) &&
    std::none_of(others.begin(), others.end(),
      [&](const FlatPolygon& other) { return obstructed(other.at, p, q); });
}

// A rectangle around a polygon.
struct Surroundings
{
  explicit Surroundings(const FlatPolygon& polygon)
    : low(polygon.at.front())
    , high(low)
  {
    for (const PlanePoint& p : polygon.at)
    {
      low = { std::min(low.a, p.a), std::min(low.b, p.b) };
      high = { std::max(high.a, p.a), std::max(high.b, p.b) };
    }
  }

  // Of a point; no larger than from any corner, rounding included.
  double distance2From(const PlanePoint& p) const
  {
    return distance2(p, { std::clamp(p.a, low.a, high.a), std::clamp(p.b, low.b, high.b) });
  }

  PlanePoint low;
  PlanePoint high;
};

// All bridges no longer than `most`, in order.
std::vector<Bridge> bridgesUpTo(
  double most, const FlatPolygon& polygon, const FlatPolygon& hole, const Surroundings& around)
{
  std::vector<Bridge> bridges;
  for (std::size_t o = 0; o < polygon.at.size(); ++o)
  {
    for (std::size_t h = 0; h < hole.at.size() && around.distance2From(polygon.at[o]) <= most; ++h)
    {
      const Bridge bridge{ distance2(polygon.at[o], hole.at[h]), o, h };
      if (bridge.length2 <= most)
      {
        bridges.push_back(bridge);
      }
    }
  }
  std::sort(bridges.begin(), bridges.end());
  return bridges;
}

double shortestLength2(
  const FlatPolygon& polygon, const FlatPolygon& hole, const Surroundings& around)
{
  double least = std::numeric_limits<double>::infinity();
  for (const PlanePoint& p : polygon.at)
  {
    for (std::size_t h = 0; h < hole.at.size() && around.distance2From(p) < least; ++h)
    {
      least = std::min(least, distance2(p, hole.at[h]));
    }
  }
  return least;
}

// The shortest bridge; where (by rounding) none runs inside, the shortest of all.
Bridge bestBridge(
  const FlatPolygon& polygon, const FlatPolygon& hole, const std::vector<FlatPolygon>& others)
{
  // Nearly always one of the first few will do: longer ones are not even listed until those have failed.
  constexpr double More = 16;
  const std::size_t all = polygon.at.size() * hole.at.size();
  const Surroundings around(hole);
  double most = shortestLength2(polygon, hole, around);
  std::vector<Bridge> bridges = bridgesUpTo(most, polygon, hole, around);
  const Bridge shortest = bridges.front();
  for (std::size_t tried = 0;;)
  {
    for (; tried < bridges.size(); ++tried)
    {
      if (runsInside(bridges[tried], polygon, hole, others))
      {
        return bridges[tried];
      }
    }
    if (bridges.size() == all)
    {
      return shortest;
    }
    most = std::max(More * most, 1.0);
    bridges = bridgesUpTo(most, polygon, hole, around);
  }
}

// The result is outer ... o, h ... h, o ...; a shared corner needs no edge.
void joinAlong(const Bridge& bridge, FlatPolygon& polygon, const FlatPolygon& hole)
{
  FlatPolygon joined = part(polygon, (bridge.outer + 1) % polygon.nodes.size(), bridge.outer);
  const bool shared = polygon.nodes[bridge.outer] == hole.nodes[bridge.inner];
  const std::size_t n = hole.nodes.size();
  for (std::size_t i = shared ? 1 : 0; i <= n; ++i)
  {
    joined.nodes.push_back(hole.nodes[(bridge.inner + i) % n]);
    joined.at.push_back(hole.at[(bridge.inner + i) % n]);
  }
  if (!shared)
  {
    joined.nodes.push_back(polygon.nodes[bridge.outer]);
    joined.at.push_back(polygon.at[bridge.outer]);
  }
  polygon = std::move(joined);
}

bool touch(const FlatPolygon& x, const FlatPolygon& y)
{
  return std::find_first_of(x.nodes.begin(), x.nodes.end(), y.nodes.begin(), y.nodes.end()) !=
    x.nodes.end();
}

// Joins the holes that share a corner with `loop`, a part of the polygon, then those that share one
// with these, and so on.
void joinTouching(FlatPolygon loop, FlatPolygon& polygon, std::vector<FlatPolygon>& holes)
{
  std::vector<FlatPolygon> todo{ std::move(loop) };
  while (!todo.empty())
  {
    const FlatPolygon from = std::move(todo.back());
    todo.pop_back();
    for (std::size_t i = holes.size(); i-- > 0;)
    {
      if (touch(from, holes[i]))
      {
        joinAlong(bestBridge(polygon, holes[i], {}), polygon, holes[i]);
        todo.push_back(std::move(holes[i]));
        holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }
}

}

bool isStar(const std::vector<PlanePoint>& at)
{
  const std::size_t n = at.size();
  const PlanePoint base = at[0];
  PlaneVector mean{ 0, 0 };
  for (const PlanePoint& p : at)
  {
    mean.a += static_cast<double>(p.a - base.a) / static_cast<double>(n);
    mean.b += static_cast<double>(p.b - base.b) / static_cast<double>(n);
  }
  double area = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i)
  {
    const PlaneVector p = minus(at[i], base);
    const PlaneVector q = minus(at[i + 1 < n ? i + 1 : 0], base);
    const double twice = cross({ p.a - mean.a, p.b - mean.b }, { q.a - mean.a, q.b - mean.b });
    area += twice;
    least = std::min(least, twice);
  }
  return least >= -StarRounding * std::abs(area);
}

void joinHoles(FlatPolygon& polygon, std::vector<FlatPolygon> holes)
{
  // Holes are joined from right to left, so that only the polygon itself can obstruct the view to
  // the right from a hole's rightmost corner: there is always an edge.
  std::sort(holes.begin(), holes.end(), [](const FlatPolygon& x, const FlatPolygon& y) {
    const PlanePoint p = rightmost(x);
    const PlanePoint q = rightmost(y);
    return p.a != q.a ? p.a < q.a : (p.b != q.b ? p.b < q.b : x.nodes < y.nodes);
  });
  joinTouching(polygon, polygon, holes);
  while (!holes.empty())
  {
    FlatPolygon hole = std::move(holes.back());
    holes.pop_back();
    joinAlong(bestBridge(polygon, hole, holes), polygon, hole);
    joinTouching(std::move(hole), polygon, holes);
  }
}

bool isWhole(const FlatPolygon& polygon)
{
  return polygon.nodes.size() <= 3 || (isStar(polygon.at) && areDistinct(polygon.nodes));
}

void splitIntoStars(FlatPolygon polygon, std::vector<FlatPolygon>& parts)
{
  if (isWhole(polygon))
  {
    parts.push_back(std::move(polygon));
    return;
  }
  std::vector<FlatPolygon> todo;
  todo.push_back(std::move(polygon));
  while (!todo.empty())
  {
    FlatPolygon next = std::move(todo.back());
    todo.pop_back();
    if (isWhole(next))
    {
      parts.push_back(std::move(next));
      continue;
    }
    const std::size_t n = next.nodes.size();
    const std::size_t i = mostConcave(next.at);
    const Diagonal diagonal = optimalDiagonal(next.at, i);
    const std::size_t to = diagonal.found ? diagonal.to : anyDiagonal(i, n);
    todo.push_back(part(next, i, to));
    todo.push_back(part(next, to, i));
  }
}

}

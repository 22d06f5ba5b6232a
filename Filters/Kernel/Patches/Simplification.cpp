// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/Simplification.h"

#include "Base/Loops.h"
#include "Lattice/Vector.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr double Degree = Pi / 180;

// A corner whose angle is this much (sine) over 180 degrees still counts as straight.
constexpr double MostConcave = 1e-3;

// Of a polygon that others are merged into: the time grows with the square of their number.
constexpr std::uint32_t MostCorners = 128;

// Around a node that is removed: likewise.
constexpr std::size_t LargestFan = 256;

double angleBetween(const Vector& a, const Vector& b)
{
  return std::acos(std::max(-1.0, std::min(1.0, dot(a, b))));
}

Vector areaVector(
  const std::vector<Vector>& at, const std::uint32_t* begin, const std::uint32_t* end)
{
  Vector sum{ 0, 0, 0 };
  for (const std::uint32_t* c = begin + 1; c + 1 < end; ++c)
  {
    sum = plus(sum, cross(minus(at[*c], at[*begin]), minus(at[c[1]], at[*begin])));
  }
  return { sum[0] / 2, sum[1] / 2, sum[2] / 2 };
}

double lengthOf(const Vector& v)
{
  return std::sqrt(dot(v, v));
}

}

Simplification::Simplification(
  const Surface& surface, const Boxes& boxes, const Clearance& clearance, const PatchSpec& spec)
  : surface_(surface)
  , boxes_(boxes)
  , clearance_(clearance)
  , mergeRadius_(spec.mergeAngle * Degree / 2)
  , featureAngle_(spec.featureAngle * Degree)
  , featureCosine_(std::cos(featureAngle_))
{
}

void Simplification::begin(const Box& box, const std::vector<Point>& points)
{
  at_.clear();
  planes_.clear();
  for (const Point& p : points)
  {
    at_.push_back(minus(p, box.low));
    planes_.push_back(planesOf(box, p));
  }
  shortest_ = -1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double clearance = clearance_.of(axis, boxes_.globalOf(box).index[axis]);
    shortest_ = shortest_ < 0 ? clearance : std::min(shortest_, clearance);
  }
  polygons_.clear();
  corners_.clear();
  if (of_.size() < points.size())
  {
    of_.resize(points.size());
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    of_[i].clear();
  }
}

void Simplification::add(const std::uint32_t* begin, const std::uint32_t* end,
  std::uint32_t triangle, const Vector& normal)
{
  Polygon like{};
  like.triangle = triangle;
  like.area = lengthOf(areaVector(at_, begin, end));
  append(begin, end, like, { normal, 0 });
}

void Simplification::append(
  const std::uint32_t* begin, const std::uint32_t* end, const Polygon& like, const Cone& cone)
{
  const auto index = static_cast<std::uint32_t>(polygons_.size());
  Polygon p = like;
  p.first = corners_.size();
  p.size = static_cast<std::uint32_t>(end - begin);
  p.axis = cone.axis;
  p.spread = cone.spread;
  p.alive = true;
  for (const std::uint32_t* c = begin; c != end; ++c)
  {
    corners_.push_back(*c);
    of_[*c].push_back(index);
  }
  polygons_.push_back(p);
}

// A cone that holds two.
Simplification::Cone Simplification::around(const Cone& a, const Cone& b)
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

void Simplification::listUses()
{
  uses_.clear();
  for (std::uint32_t p = 0; p < polygons_.size(); ++p)
  {
    if (!polygons_[p].alive)
    {
      continue;
    }
    const std::uint32_t* const c = corners_.data() + polygons_[p].first;
    for (std::uint32_t i = 0; i < polygons_[p].size; ++i)
    {
      const std::uint32_t a = c[i];
      const std::uint32_t b = c[i + 1 < polygons_[p].size ? i + 1 : 0];
      uses_.push_back({ std::min(a, b), std::max(a, b), p, a > b });
    }
  }
  std::sort(uses_.begin(), uses_.end(), [](const Use& a, const Use& b) {
    return a.lower != b.lower ? a.lower < b.lower
                              : (a.upper != b.upper ? a.upper < b.upper : a.polygon < b.polygon);
  });
}

bool Simplification::isFeature(const Polygon& p, const Polygon& q) const
{
  return surface_.boundary[p.triangle] != surface_.boundary[q.triangle] ||
    dot(p.axis, q.axis) < featureCosine_;
}

// Nodes of sharp edges and borders, and of edges that are no one's or several polygons'.
void Simplification::markFeatures()
{
  feature_.assign(at_.size(), 0);
  cones_.assign(at_.size(), Cone{ { 0, 0, 0 }, 0 });
  for (const Polygon& p : polygons_)
  {
    for (std::uint32_t i = 0; p.alive && i < p.size; ++i)
    {
      Cone& cone = cones_[corners_[p.first + i]];
      cone = around(cone, { p.axis, p.spread });
    }
  }
  listUses();
  for (std::size_t i = 0; i < uses_.size();)
  {
    std::size_t end = i + 1;
    while (end < uses_.size() && uses_[i].sameEdge(uses_[end]))
    {
      ++end;
    }
    if (end - i != 2 || isFeature(polygons_[uses_[i].polygon], polygons_[uses_[i + 1].polygon]))
    {
      feature_[uses_[i].lower] = feature_[uses_[i].upper] = 1;
    }
    i = end;
  }
}

// The polygons around a node in order, and the loop around them; false where they are no single fan,
// or too many.
bool Simplification::gatherFan(std::uint32_t node)
{
  fan_.clear();
  for (const std::uint32_t p : of_[node])
  {
    if (polygons_[p].alive)
    {
      fan_.push_back(p);
    }
  }
  if (fan_.size() > LargestFan)
  {
    return false;
  }
  const auto neighbour = [&](std::uint32_t p, bool next) {
    const std::uint32_t* const c = corners_.data() + polygons_[p].first;
    const std::uint32_t size = polygons_[p].size;
    const auto i = static_cast<std::uint32_t>(std::find(c, c + size, node) - c);
    return c[(i + (next ? 1 : size - 1)) % size];
  };
  // A fan that is not closed begins with the polygon whose last neighbour is no one's first.
  for (std::size_t i = 0; i < fan_.size(); ++i)
  {
    const std::uint32_t to = neighbour(fan_[i], true);
    if (std::none_of(fan_.begin(), fan_.end(),
          [&](std::uint32_t other) { return neighbour(other, false) == to; }))
    {
      std::swap(fan_[0], fan_[i]);
      break;
    }
  }
  loop_.clear();
  for (std::size_t i = 0; i < fan_.size(); ++i)
  {
    if (i > 0)
    {
      const std::uint32_t shared = neighbour(fan_[i - 1], false);
      const auto at = std::find_if(fan_.begin() + std::ptrdiff_t(i), fan_.end(),
        [&](std::uint32_t other) { return neighbour(other, true) == shared; });
      if (at == fan_.end())
      {
        return false;
      }
      std::swap(fan_[i], *at);
    }
    const Polygon& p = polygons_[fan_[i]];
    const std::uint32_t* const c = corners_.data() + p.first;
    const auto here = static_cast<std::uint32_t>(std::find(c, c + p.size, node) - c);
    for (std::uint32_t k = i == 0 ? 1 : 2; k < p.size; ++k)
    {
      loop_.push_back(c[(here + k) % p.size]);
    }
  }
  if (!fan_.empty() && loop_.size() > 1 && loop_.front() == loop_.back())
  {
    loop_.pop_back(); // closed
  }
  ring_ = loop_;
  std::sort(ring_.begin(), ring_.end());
  return !fan_.empty() && std::adjacent_find(ring_.begin(), ring_.end()) == ring_.end();
}

// Puts triangles over the loop around a node. Forced: unless a feature passes; else only where they
// differ by no more than half of Merge Angle from what they replace, and from the surface at their
// corners.
bool Simplification::removeNode(std::uint32_t node, bool forced)
{
  if (!gatherFan(node))
  {
    return false;
  }
  Cone cone{ { 0, 0, 0 }, 0 };
  const Polygon* largest = &polygons_[fan_[0]];
  for (const std::uint32_t p : fan_)
  {
    cone = around(cone, { polygons_[p].axis, polygons_[p].spread });
    largest = polygons_[p].area > largest->area ? &polygons_[p] : largest;
  }
  if (cone.spread > (forced ? featureAngle_ : mergeRadius_))
  {
    return false;
  }
  nodes_.clear();
  for (const std::uint32_t n : loop_)
  {
    nodes_.push_back({ n, at_[n], cone.axis, planes_[n] });
  }
  const Polygon like = *largest;
  static const std::vector<LoopTriangulation::Triangle> nothing;
  const auto& triangles = loop_.size() < 3 ? nothing : triangulation_.triangulate(nodes_);
  if (!forced)
  {
    for (const auto& t : triangles)
    {
      const Vector normal = unit(
        cross(minus(nodes_[t[1]].at, nodes_[t[0]].at), minus(nodes_[t[2]].at, nodes_[t[0]].at)));
      const auto fits = [&](std::uint32_t corner) {
        const std::uint32_t n = loop_[corner];
        return feature_[n] != 0 ||
          angleBetween(normal, cones_[n].axis) <= mergeRadius_ + cones_[n].spread;
      };
      if (dot(normal, normal) == 0 || angleBetween(normal, cone.axis) > mergeRadius_ ||
        (nodes_[t[0]].planes & nodes_[t[1]].planes & nodes_[t[2]].planes) != 0 || !fits(t[0]) ||
        !fits(t[1]) || !fits(t[2]))
      {
        return false;
      }
    }
  }
  for (const std::uint32_t p : fan_)
  {
    polygons_[p].alive = false;
  }
  for (const auto& t : triangles)
  {
    const std::array<std::uint32_t, 3> c = { loop_[t[0]], loop_[t[1]], loop_[t[2]] };
    const Vector normal = unit(cross(minus(at_[c[1]], at_[c[0]]), minus(at_[c[2]], at_[c[0]])));
    append(c.data(), c.data() + 3, like, { dot(normal, cone.axis) > 0 ? normal : cone.axis, 0 });
  }
  return true;
}

// Where a node can't be removed its polygons take another instead.
void Simplification::collapse(std::uint32_t node, std::uint32_t onto)
{
  const std::size_t count = of_[node].size();
  for (std::size_t i = 0; i < count; ++i)
  {
    Polygon& p = polygons_[of_[node][i]];
    if (!p.alive)
    {
      continue;
    }
    p.alive = false;
    const Polygon like = p;
    loop_.assign(corners_.begin() + std::ptrdiff_t(p.first),
      corners_.begin() + std::ptrdiff_t(p.first + p.size));
    std::replace(loop_.begin(), loop_.end(), node, onto);
    forEachSimpleLoop(loop_, [&](const std::uint32_t* begin, const std::uint32_t* end) {
      append(begin, end, like, { like.axis, like.spread });
    });
  }
}

void Simplification::removeTied(const SideTying& tying)
{
  const std::vector<std::uint32_t>& onto = tying.onto();
  for (std::uint32_t node = 0; node < onto.size(); ++node)
  {
    if (onto[node] != node && (tying.wentForShortness(node) || !removeNode(node, true)))
    {
      collapse(node, onto[node]);
    }
  }
}

void Simplification::removeInner()
{
  markFeatures();
  for (bool changed = true; changed;)
  {
    changed = false;
    for (std::uint32_t node = 0; node < at_.size(); ++node)
    {
      if (planes_[node] == 0 && feature_[node] == 0 && !of_[node].empty() &&
        removeNode(node, false))
      {
        of_[node].clear();
        changed = true;
      }
    }
  }
  // What is left of edges shorter than the clearance of nodes from planes.
  listUses();
  for (const Use& use : uses_)
  {
    if (planes_[use.lower] == 0 && planes_[use.upper] == 0 &&
      lengthOf(minus(at_[use.lower], at_[use.upper])) < shortest_)
    {
      collapse(use.upper, use.lower);
    }
  }
}

bool Simplification::isSliver(const Polygon& p) const
{
  const std::uint32_t* const c = corners_.data() + p.first;
  double longest = 0;
  for (std::uint32_t i = 0; i < p.size; ++i)
  {
    longest = std::max(longest, lengthOf(minus(at_[c[i]], at_[c[i + 1 < p.size ? i + 1 : 0]])));
  }
  return 2 * lengthOf(areaVector(at_, c, c + p.size)) < shortest_ * longest;
}

void Simplification::listCandidates()
{
  candidates_.clear();
  listUses();
  for (std::size_t i = 0; i < uses_.size();)
  {
    std::size_t end = i + 1;
    while (end < uses_.size() && uses_[i].sameEdge(uses_[end]))
    {
      ++end;
    }
    const Use& a = uses_[i];
    if (end - i == 2 && a.down != uses_[i + 1].down && a.polygon != uses_[i + 1].polygon)
    {
      const std::uint32_t left = a.down ? uses_[i + 1].polygon : a.polygon;
      const std::uint32_t right = a.down ? a.polygon : uses_[i + 1].polygon;
      candidates_.push_back({ lengthOf(minus(at_[a.lower], at_[a.upper])),
        isSliver(polygons_[left]) || isSliver(polygons_[right]), left, right, a.lower, a.upper });
    }
    i = end;
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return a.sliver != b.sliver
      ? a.sliver
      : (a.length != b.length ? a.length > b.length
                              : (a.from != b.from ? a.from < b.from : a.to < b.to));
  });
}

std::uint32_t Simplification::current(std::uint32_t polygon)
{
  while (polygon < joined_.size() && joined_[polygon] != polygon)
  {
    polygon = joined_[polygon];
  }
  return polygon;
}

void Simplification::merge()
{
  listCandidates();
  joined_.resize(polygons_.size());
  for (std::uint32_t i = 0; i < joined_.size(); ++i)
  {
    joined_[i] = i;
  }
  for (const Candidate& candidate : candidates_)
  {
    joinAcross(candidate);
  }
  splitTurned();
}

bool Simplification::joinAcross(const Candidate& candidate)
{
  const std::uint32_t left = current(candidate.left);
  const std::uint32_t right = current(candidate.right);
  if (left == right)
  {
    return false;
  }
  const Polygon p = polygons_[left];
  const Polygon q = polygons_[right];
  if (p.size + q.size > MostCorners)
  {
    return false;
  }
  const bool pSliver = isSliver(p);
  const bool sliver = pSliver || isSliver(q);
  Cone cone = around({ p.axis, p.spread }, { q.axis, q.spread });
  if (sliver)
  {
    cone = pSliver ? Cone{ q.axis, q.spread } : Cone{ p.axis, p.spread };
  }
  else if (cone.spread > mergeRadius_ ||
    surface_.boundary[p.triangle] != surface_.boundary[q.triangle] ||
    dot(p.axis, q.axis) < featureCosine_)
  {
    return false;
  }
  if (!unite(p, q, candidate.from, candidate.to) || !isConvex(ring_, sliver ? 1 : MostConcave))
  {
    return false;
  }
  const bool likeP = pSliver == isSliver(q) ? p.area >= q.area : !pSliver;
  Polygon like = likeP ? p : q;
  polygons_[left].alive = false;
  polygons_[right].alive = false;
  joined_[left] = joined_[right] = static_cast<std::uint32_t>(polygons_.size());
  joined_.push_back(static_cast<std::uint32_t>(polygons_.size()));
  append(ring_.data(), ring_.data() + ring_.size(), like, cone);
  return true;
}

// The ring around two polygons that share the edge from `from` to `to`, without what they share;
// false where they share more than one chain of edges.
bool Simplification::unite(
  const Polygon& left, const Polygon& right, std::uint32_t from, std::uint32_t to)
{
  const std::uint32_t* const l = corners_.data() + left.first;
  const std::uint32_t* const r = corners_.data() + right.first;
  const auto i = static_cast<std::uint32_t>(std::find(l, l + left.size, to) - l);
  const auto j = static_cast<std::uint32_t>(std::find(r, r + right.size, from) - r);
  if (i == left.size || j == right.size || l[(i + left.size - 1) % left.size] != from ||
    r[(j + right.size - 1) % right.size] != to)
  {
    return false;
  }
  ring_.clear();
  for (std::uint32_t k = 0; k < left.size; ++k)
  {
    ring_.push_back(l[(i + k) % left.size]); // to, ..., from
  }
  for (std::uint32_t k = 1; k + 1 < right.size; ++k)
  {
    ring_.push_back(r[(j + k) % right.size]); // between from and to
  }
  // A longer chain leaves spikes.
  for (bool spike = true; spike && ring_.size() > 2;)
  {
    spike = false;
    for (std::size_t k = 0; k < ring_.size() && ring_.size() > 2; ++k)
    {
      const std::size_t next = (k + 1) % ring_.size();
      const std::size_t after = (k + 2) % ring_.size();
      if (ring_[k] == ring_[after])
      {
        ring_.erase(ring_.begin() + std::ptrdiff_t(std::max(next, after)));
        ring_.erase(ring_.begin() + std::ptrdiff_t(std::min(next, after)));
        spike = true;
        break;
      }
    }
  }
  loop_ = ring_;
  std::sort(loop_.begin(), loop_.end());
  return ring_.size() > 2 && std::adjacent_find(loop_.begin(), loop_.end()) == loop_.end();
}

// No corner of more than 180 degrees, no star triangle turned over.
bool Simplification::isConvex(const std::vector<std::uint32_t>& ring, double mostConcave) const
{
  const Vector normal = unit(areaVector(at_, ring.data(), ring.data() + ring.size()));
  Vector centre{ 0, 0, 0 };
  for (const std::uint32_t c : ring)
  {
    centre = plus(centre, at_[c]);
  }
  for (double& x : centre)
  {
    x /= static_cast<double>(ring.size());
  }
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Vector& p = at_[ring[i]];
    const Vector& q = at_[ring[(i + 1) % ring.size()]];
    const Vector& r = at_[ring[(i + 2) % ring.size()]];
    const Vector pq = minus(q, p);
    const Vector qr = minus(r, q);
    if (dot(cross(pq, qr), normal) < -mostConcave * lengthOf(pq) * lengthOf(qr) ||
      !(dot(cross(minus(p, centre), minus(q, centre)), normal) > 0))
    {
      return false;
    }
  }
  return true;
}

// A polygon that rounding or tying has left without a star triangulation falls into triangles.
void Simplification::splitTurned()
{
  const std::size_t count = polygons_.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!polygons_[i].alive || polygons_[i].size == 3)
    {
      continue;
    }
    const Polygon p = polygons_[i];
    ring_.assign(corners_.begin() + std::ptrdiff_t(p.first),
      corners_.begin() + std::ptrdiff_t(p.first + p.size));
    if (isConvex(ring_, 1))
    {
      continue;
    }
    nodes_.clear();
    for (const std::uint32_t n : ring_)
    {
      nodes_.push_back({ n, at_[n], p.axis, planes_[n] });
    }
    polygons_[i].alive = false;
    for (const auto& t : triangulation_.triangulate(nodes_))
    {
      const std::array<std::uint32_t, 3> c = { ring_[t[0]], ring_[t[1]], ring_[t[2]] };
      append(c.data(), c.data() + 3, p, { p.axis, p.spread });
    }
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Faces/ChordSimplification.h"

#include "Lattice/Vector.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// More chords than this are not compared with each other.
constexpr std::size_t MostChords = 256;

double distanceFrom(const PlanePoint& p, const PlanePoint& from, const PlanePoint& to)
{
  const auto x = static_cast<double>(p.a - from.a);
  const auto y = static_cast<double>(p.b - from.b);
  const auto u = static_cast<double>(to.a - from.a);
  const auto v = static_cast<double>(to.b - from.b);
  const double length = u * u + v * v;
  const double t = length > 0 ? std::min(1.0, std::max(0.0, (x * u + y * v) / length)) : 0;
  return std::hypot(x - t * u, y - t * v);
}

// Of chords that share no end: whether they have a point in common.
bool meet(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  const int c1 = sign(turn(a, b, c));
  const int d1 = sign(turn(a, b, d));
  const int a2 = sign(turn(c, d, a));
  const int b2 = sign(turn(c, d, b));
  if (c1 == 0 && d1 == 0)
  {
    const auto overlap = [](std::int64_t p, std::int64_t q, std::int64_t s, std::int64_t t) {
      return std::max(std::min(p, q), std::min(s, t)) <= std::min(std::max(p, q), std::max(s, t));
    };
    return overlap(a.a, b.a, c.a, d.a) && overlap(a.b, b.b, c.b, d.b);
  }
  return c1 * d1 <= 0 && a2 * b2 <= 0;
}

// Of chords that share the node p: whether one lies on the other.
bool overlap(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b)
{
  const auto along = static_cast<double>(a.a - p.a) * static_cast<double>(b.a - p.a) +
    static_cast<double>(a.b - p.b) * static_cast<double>(b.b - p.b);
  return turn(p, a, b) == 0 && along > 0;
}

}

std::uint32_t ChordSimplifier::local(std::uint32_t node) const
{
  return static_cast<std::uint32_t>(
    std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin());
}

void ChordSimplifier::run(const Rectangle& r, std::vector<SideEdge>& chords)
{
  const auto edge = static_cast<double>(std::min(r.high.a - r.low.a, r.high.b - r.low.b));
  tolerance_ = ChordTolerance * edge;
  narrowest_ = NarrowestLoop * edge;
  link(r, chords);
  result_.clear();
  for (const SideEdge& chord : chords)
  {
    const std::uint32_t from = local(chord.from);
    if (fixed_[from])
    {
      line_.assign(1, from);
      trace(local(chord.to));
      addPolyline();
    }
  }
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
  {
    if (next_[i] != None)
    {
      order.push_back(i);
    }
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t x, std::uint32_t y) {
    return std::make_pair(places_[x].a, places_[x].b) < std::make_pair(places_[y].a, places_[y].b);
  });
  for (const std::uint32_t first : order)
  {
    if (next_[first] != None)
    {
      line_.clear();
      trace(first);
      addLoop();
    }
  }
  if (anyCross())
  {
    return;
  }
  chords.clear();
  for (const SideEdge& chord : result_)
  {
    chords.push_back({ nodes_[chord.from], nodes_[chord.to] });
  }
}

void ChordSimplifier::link(const Rectangle& r, const std::vector<SideEdge>& chords)
{
  next_.assign(nodes_.size(), None);
  fixed_.assign(nodes_.size(), 0);
  borders_.assign(nodes_.size(), 0);
  std::vector<std::uint8_t> comes(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i)
  {
    const PlanePoint& p = places_[i];
    borders_[i] = static_cast<std::uint8_t>((p.a == r.low.a ? 1 : 0) | (p.a == r.high.a ? 2 : 0) |
      (p.b == r.low.b ? 4 : 0) | (p.b == r.high.b ? 8 : 0));
    fixed_[i] = borders_[i] != 0 ? 1 : 0;
  }
  for (const SideEdge& chord : chords)
  {
    const std::uint32_t from = local(chord.from);
    const std::uint32_t to = local(chord.to);
    fixed_[from] = fixed_[from] || next_[from] != None ? 1 : 0;
    fixed_[to] = fixed_[to] || comes[to] != 0 ? 1 : 0;
    next_[from] = to;
    comes[to] = 1;
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i)
  {
    fixed_[i] = fixed_[i] || (next_[i] == None) != (comes[i] == 0) ? 1 : 0;
    next_[i] = fixed_[i] ? None : next_[i];
  }
}

// Appends the nodes from here to a fixed one, or round a loop, whose first node comes again.
void ChordSimplifier::trace(std::uint32_t node)
{
  line_.push_back(node);
  while (next_[node] != None)
  {
    const std::uint32_t to = next_[node];
    next_[node] = None;
    node = to;
    line_.push_back(node);
  }
}

std::size_t ChordSimplifier::farthest(std::size_t first, std::size_t last, double& distance) const
{
  std::size_t at = first;
  distance = -1;
  for (std::size_t i = first + 1; i < last; ++i)
  {
    const double d = distanceFrom(places_[line_[i]], places_[line_[first]], places_[line_[last]]);
    if (d > distance)
    {
      distance = d;
      at = i;
    }
  }
  return at;
}

// Marks the nodes between two kept ones that stay (Douglas and Peucker).
void ChordSimplifier::thin(std::size_t first, std::size_t last)
{
  double distance = 0;
  const std::size_t at = farthest(first, last, distance);
  if (distance > tolerance_)
  {
    keeps_[at] = 1;
    thin(first, at);
    thin(at, last);
  }
}

bool ChordSimplifier::sharesBorder(std::uint32_t a, std::uint32_t b) const
{
  return (borders_[a] & borders_[b]) != 0;
}

void ChordSimplifier::addPolyline()
{
  const std::size_t last = line_.size() - 1;
  keeps_.assign(line_.size(), 0);
  keeps_.front() = keeps_.back() = 1;
  thin(0, last);
  // A chord along the border would lie on the next side too; and one from a node to itself is none.
  const bool needsMiddle =
    sharesBorder(line_.front(), line_.back()) || line_.front() == line_.back();
  if (needsMiddle && last > 1 && std::count(keeps_.begin(), keeps_.end(), 1) == 2)
  {
    double distance = 0;
    keeps_[farthest(0, last, distance)] = 1;
  }
  std::size_t before = 0;
  for (std::size_t i = 1; i <= last; ++i)
  {
    if (keeps_[i])
    {
      result_.push_back({ line_[before], line_[i] });
      before = i;
    }
  }
}

// From its first node to the one farthest away, and back.
void ChordSimplifier::addLoop()
{
  const std::size_t last = line_.size() - 1;
  PlanePoint low = places_[line_[0]];
  PlanePoint high = low;
  std::size_t middle = 0;
  double most = 0;
  for (std::size_t i = 1; i < last; ++i)
  {
    const PlanePoint& p = places_[line_[i]];
    low = { std::min(low.a, p.a), std::min(low.b, p.b) };
    high = { std::max(high.a, p.a), std::max(high.b, p.b) };
    const double d = std::hypot(static_cast<double>(p.a - places_[line_[0]].a),
      static_cast<double>(p.b - places_[line_[0]].b));
    if (d > most)
    {
      most = d;
      middle = i;
    }
  }
  const auto width = static_cast<double>(std::min(high.a - low.a, high.b - low.b));
  if (width < narrowest_)
  {
    return;
  }
  keeps_.assign(line_.size(), 0);
  keeps_.front() = keeps_.back() = keeps_[middle] = 1;
  thin(0, middle);
  thin(middle, last);
  std::size_t before = 0;
  for (std::size_t i = 1; i <= last; ++i)
  {
    if (keeps_[i])
    {
      result_.push_back({ line_[before], line_[i] });
      before = i;
    }
  }
}

bool ChordSimplifier::anyCross() const
{
  if (result_.size() > MostChords)
  {
    return true;
  }
  for (std::size_t i = 0; i < result_.size(); ++i)
  {
    const SideEdge& x = result_[i];
    for (std::size_t k = i + 1; k < result_.size(); ++k)
    {
      const SideEdge& y = result_[k];
      const bool same = (x.from == y.from && x.to == y.to) || (x.from == y.to && x.to == y.from);
      bool cross = same;
      if (!same && x.to == y.from)
      {
        cross = overlap(places_[x.to], places_[x.from], places_[y.to]);
      }
      else if (!same && x.from == y.to)
      {
        cross = overlap(places_[x.from], places_[x.to], places_[y.from]);
      }
      else if (!same && x.from != y.from && x.to != y.to)
      {
        cross = meet(places_[x.from], places_[x.to], places_[y.from], places_[y.to]);
      }
      if (cross)
      {
        return true;
      }
    }
  }
  return false;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/RimNodeRemoval.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// How far a rim may leave its place, as a part of the box's shortest side.
constexpr double MostFromRim = 0.01;

double distanceFromChord(const Vector& at, const Vector& from, const Vector& to)
{
  const Vector chord = minus(to, from);
  const double square = dot(chord, chord);
  const double along = square > 0 ? std::clamp(dot(minus(at, from), chord) / square, 0., 1.) : 0;
  return norm(minus(at, plus(from, scaled(chord, along))));
}

}

void RimNodeRemoval::run(const std::vector<PolygonEdge>& rims, double turn)
{
  turn_ = turn;
  listLinks(rims);
  for (;;)
  {
    std::uint32_t best = None;
    double least = MostFromRim * box_.shortestSide;
    for (std::uint32_t node = 0; node < links_.size(); ++node)
    {
      if (const double off = offWithout(node); off <= least)
      {
        best = node;
        least = off;
      }
    }
    if (best == None)
    {
      return;
    }
    if (remove(best))
    {
      relink(best);
    }
    links_[best] = {};
  }
}

void RimNodeRemoval::listLinks(const std::vector<PolygonEdge>& rims)
{
  links_.assign(box_.at.size(), {});
  for (const PolygonEdge& edge : rims)
  {
    for (const auto& [node, other] :
      { std::pair{ edge.lower, edge.upper }, { edge.upper, edge.lower } })
    {
      Link& link = links_[node];
      if (link.edges < 2)
      {
        link.next[static_cast<std::size_t>(link.edges)] = other;
      }
      ++link.edges;
    }
  }
}

// How far the rim, as it was, would be from its chord there; more than anything where the node has to stay.
double RimNodeRemoval::offWithout(std::uint32_t node) const
{
  const Link& link = links_[node];
  if (link.edges != 2 || box_.planes[node] != 0 || link.next[0] == link.next[1])
  {
    return std::numeric_limits<double>::infinity();
  }
  return distanceFromChord(box_.at[node], box_.at[link.next[0]], box_.at[link.next[1]]) +
    std::max(link.off[0], link.off[1]);
}

bool RimNodeRemoval::remove(std::uint32_t node)
{
  const auto [p, q] = links_[node].next;
  if (!gather(node, p, q, sectors_[0]) || !gather(node, q, p, sectors_[1]) || !isFree(node, p, q) ||
    !triangulate(sectors_[0]) || !triangulate(sectors_[1]))
  {
    return false;
  }
  replace(sectors_[0]);
  replace(sectors_[1]);
  return true;
}

// The polygons around a node from the edge to one node on to that to another, counter-clockwise.
bool RimNodeRemoval::gather(
  std::uint32_t node, std::uint32_t from, std::uint32_t to, Sector& sector)
{
  sector.fan.clear();
  sector.loop.assign(1, from);
  while (sector.loop.back() != to)
  {
    const std::uint32_t before = sector.loop.back();
    const std::vector<std::uint32_t>& around = box_.of[node];
    std::size_t here = 0;
    const auto next = std::find_if(around.begin(), around.end(), [&](std::uint32_t p) {
      const Polygon& polygon = box_.polygons[p];
      const std::uint32_t* const c = box_.cornersOf(polygon);
      here = static_cast<std::size_t>(std::find(c, c + polygon.size, node) - c);
      return polygon.alive && here < polygon.size && c[(here + 1) % polygon.size] == before;
    });
    if (next == around.end() || sector.fan.size() == around.size())
    {
      return false;
    }
    const Polygon& polygon = box_.polygons[*next];
    const std::uint32_t* const c = box_.cornersOf(polygon);
    for (std::uint32_t k = 2; k < polygon.size; ++k)
    {
      sector.loop.push_back(c[(here + k) % polygon.size]);
    }
    sector.fan.push_back(*next);
  }
  std::vector<std::uint32_t> sorted = sector.loop;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

// Whether there is no edge yet between two nodes, but of what becomes nothing.
bool RimNodeRemoval::isFree(std::uint32_t node, std::uint32_t p, std::uint32_t q) const
{
  const auto isOfFan = [&](std::uint32_t polygon) {
    return std::any_of(sectors_.begin(), sectors_.end(), [&](const Sector& sector) {
      return sector.loop.size() == 2 && sector.fan.front() == polygon;
    });
  };
  const bool vanishes = sectors_[0].loop.size() == 2 || sectors_[1].loop.size() == 2;
  return std::none_of(box_.of[p].begin(), box_.of[p].end(), [&](std::uint32_t polygon) {
    const Polygon& other = box_.polygons[polygon];
    const std::uint32_t* const c = box_.cornersOf(other);
    bool isEdge = false;
    for (std::uint32_t i = 0; i < other.size; ++i)
    {
      const std::uint32_t next = c[(i + 1) % other.size];
      isEdge = isEdge || (c[i] == p && next == q) || (c[i] == q && next == p);
    }
    const bool hasNode = std::find(c, c + other.size, node) != c + other.size;
    return other.alive && isEdge && !isOfFan(polygon) && (hasNode || !vanishes);
  });
}

bool RimNodeRemoval::triangulate(Sector& sector)
{
  NormalCone cone{ { 0, 0, 0 }, 0 };
  for (const std::uint32_t p : sector.fan)
  {
    cone = around(cone, box_.polygons[p].cone);
  }
  sector.axis = cone.axis;
  sector.triangles.clear();
  if (cone.spread > turn_)
  {
    return false;
  }
  if (sector.loop.size() < 3)
  {
    return true;
  }
  nodes_.clear();
  for (const std::uint32_t n : sector.loop)
  {
    nodes_.push_back({ n, box_.at[n], cone.axis, box_.planes[n] });
  }
  sector.triangles = triangulation_.triangulate(nodes_);
  return std::all_of(sector.triangles.begin(), sector.triangles.end(), [&](const auto& t) {
    const Vector normal =
      unit(cross(minus(nodes_[t[1]].at, nodes_[t[0]].at), minus(nodes_[t[2]].at, nodes_[t[0]].at)));
    const bool inSide = (nodes_[t[0]].planes & nodes_[t[1]].planes & nodes_[t[2]].planes) != 0;
    return dot(normal, normal) != 0 && angleBetween(normal, cone.axis) <= turn_ && !inSide;
  });
}

void RimNodeRemoval::replace(const Sector& sector)
{
  const Polygon like = box_.polygons[*std::max_element(
    sector.fan.begin(), sector.fan.end(), [&](std::uint32_t p, std::uint32_t q) {
      return box_.polygons[p].area < box_.polygons[q].area;
    })];
  for (const std::uint32_t p : sector.fan)
  {
    box_.polygons[p].alive = false;
  }
  for (const auto& t : sector.triangles)
  {
    const std::array<std::uint32_t, 3> c{ sector.loop[t[0]], sector.loop[t[1]], sector.loop[t[2]] };
    const Vector normal =
      unit(cross(minus(box_.at[c[1]], box_.at[c[0]]), minus(box_.at[c[2]], box_.at[c[0]])));
    box_.append(c.data(), c.data() + 3, like, { normal, 0 });
  }
}

void RimNodeRemoval::relink(std::uint32_t node)
{
  const Link gone = links_[node];
  const double off = offWithout(node);
  for (const std::size_t end : { 0, 1 })
  {
    Link& link = links_[gone.next[end]];
    for (const std::size_t k : { 0, 1 })
    {
      if (link.next[k] == node)
      {
        link.next[k] = gone.next[1 - end];
        link.off[k] = off;
      }
    }
  }
}

}

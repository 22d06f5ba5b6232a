// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/NodeRemoval.h"

#include "Base/Loops.h"
#include "Lattice/Vector.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr double Degree = Pi / 180;

// Polygons around a node that is removed: the time to order them grows with the square of their number.
constexpr std::size_t LargestFan = 256;

}

NodeRemoval::NodeRemoval(const Surface& surface, const PatchSpec& spec, BoxPolygons& box)
  : surface_(surface)
  , box_(box)
  , mergeRadius_(spec.mergeAngle * Degree / 2)
  , featureAngle_(spec.featureAngle * Degree)
  , featureCosine_(std::cos(featureAngle_))
  , alongRims_(box)
{
}

void NodeRemoval::removeTied(const SideTying& tying)
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

void NodeRemoval::removeInner()
{
  markFeatures();
  for (bool changed = true; changed;)
  {
    changed = false;
    for (std::uint32_t node = 0; node < box_.at.size(); ++node)
    {
      if (box_.planes[node] == 0 && feature_[node] == 0 && !box_.of[node].empty() &&
        removeNode(node, false))
      {
        box_.of[node].clear();
        changed = true;
      }
    }
  }
  alongRims_.run(rims_, mergeRadius_);
  // Edges that are still too short collapse.
  box_.listEdges(edges_);
  for (const PolygonEdge& edge : edges_)
  {
    if (box_.planes[edge.lower] == 0 && box_.planes[edge.upper] == 0 &&
      box_.edgeLength(edge.lower, edge.upper) < box_.shortest)
    {
      collapse(edge.upper, edge.lower);
    }
  }
}

bool NodeRemoval::isFeature(const PolygonEdge& a, const PolygonEdge& b) const
{
  const Polygon& p = box_.polygons[a.polygon];
  const Polygon& q = box_.polygons[b.polygon];
  return surface_.boundary[p.triangle] != surface_.boundary[q.triangle] ||
    box_.isSharp(surface_, p, q, a.lower, a.upper, featureCosine_);
}

bool NodeRemoval::isOfSheet(std::uint32_t polygon) const
{
  const std::uint32_t triangle = box_.polygons[polygon].triangle;
  return surface_.isOfSheet(triangle);
}

// Marks the ends of sharp edges, of borders between boundaries, and of edges that do not have exactly
// two polygons.
void NodeRemoval::markFeatures()
{
  feature_.assign(box_.at.size(), 0);
  cones_.assign(box_.at.size(), NormalCone{ { 0, 0, 0 }, 0 });
  for (const Polygon& p : box_.polygons)
  {
    for (std::uint32_t i = 0; p.alive && i < p.size; ++i)
    {
      NormalCone& cone = cones_[box_.corners[p.first + i]];
      cone = around(cone, p.cone);
    }
  }
  box_.listEdges(edges_);
  rims_.clear();
  for (std::size_t i = 0; i < edges_.size();)
  {
    const std::size_t end = endOfEqual(edges_, i);
    if (end - i != 2 || isFeature(edges_[i], edges_[i + 1]))
    {
      feature_[edges_[i].lower] = feature_[edges_[i].upper] = 1;
      if (end - i == 2 && isOfSheet(edges_[i].polygon) && isOfSheet(edges_[i + 1].polygon))
      {
        rims_.push_back(edges_[i]);
      }
    }
    i = end;
  }
}

// The corner of a polygon next to a node of it, or the one before.
std::uint32_t NodeRemoval::neighbourOf(std::uint32_t node, std::uint32_t polygon, bool next) const
{
  const std::uint32_t size = box_.polygons[polygon].size;
  const std::uint32_t* const c = box_.cornersOf(box_.polygons[polygon]);
  const auto i = static_cast<std::uint32_t>(std::find(c, c + size, node) - c);
  return c[(i + (next ? 1 : size - 1)) % size];
}

// Lists the polygons around a node. A fan that is not closed begins with the polygon whose next corner
// is no other polygon's corner before.
void NodeRemoval::startFan(std::uint32_t node)
{
  fan_.clear();
  for (const std::uint32_t p : box_.of[node])
  {
    if (box_.polygons[p].alive)
    {
      fan_.push_back(p);
    }
  }
  for (std::size_t i = 0; i < fan_.size() && fan_.size() <= LargestFan; ++i)
  {
    const std::uint32_t to = neighbourOf(node, fan_[i], true);
    if (std::none_of(fan_.begin(), fan_.end(),
          [&](std::uint32_t other) { return neighbourOf(node, other, false) == to; }))
    {
      std::swap(fan_[0], fan_[i]);
      break;
    }
  }
}

// Orders the polygons around a node, and finds the loop around them. Returns false where they are no
// single fan, or too many.
bool NodeRemoval::gatherFan(std::uint32_t node)
{
  startFan(node);
  if (fan_.empty() || fan_.size() > LargestFan)
  {
    return false;
  }
  loop_.clear();
  for (std::size_t i = 0; i < fan_.size(); ++i)
  {
    if (i > 0)
    {
      const std::uint32_t shared = neighbourOf(node, fan_[i - 1], false);
      const auto at = std::find_if(fan_.begin() + std::ptrdiff_t(i), fan_.end(),
        [&](std::uint32_t other) { return neighbourOf(node, other, true) == shared; });
      if (at == fan_.end())
      {
        return false;
      }
      std::swap(fan_[i], *at);
    }
    const Polygon& p = box_.polygons[fan_[i]];
    const std::uint32_t* const c = box_.cornersOf(p);
    const auto here = static_cast<std::uint32_t>(std::find(c, c + p.size, node) - c);
    for (std::uint32_t k = i == 0 ? 1 : 2; k < p.size; ++k)
    {
      loop_.push_back(c[(here + k) % p.size]);
    }
  }
  if (loop_.size() > 1 && loop_.front() == loop_.back())
  {
    loop_.pop_back(); // closed
  }
  sorted_ = loop_;
  std::sort(sorted_.begin(), sorted_.end());
  return std::adjacent_find(sorted_.begin(), sorted_.end()) == sorted_.end();
}

NormalCone NodeRemoval::coneOfFan() const
{
  NormalCone cone{ { 0, 0, 0 }, 0 };
  for (const std::uint32_t p : fan_)
  {
    cone = around(cone, box_.polygons[p].cone);
  }
  return cone;
}

Polygon NodeRemoval::largestOfFan() const
{
  return box_
    .polygons[*std::max_element(fan_.begin(), fan_.end(), [&](std::uint32_t p, std::uint32_t q) {
      return box_.polygons[p].area < box_.polygons[q].area;
    })];
}

// Replaces the polygons around a node by triangles over the loop around them. Forced: unless a feature
// passes through; else only if each triangle differs by no more than half of Merge Angle from what it
// replaces, and from the surface at its corners.
bool NodeRemoval::removeNode(std::uint32_t node, bool forced)
{
  if (!gatherFan(node))
  {
    return false;
  }
  const NormalCone cone = coneOfFan();
  if (cone.spread > (forced ? featureAngle_ : mergeRadius_))
  {
    return false;
  }
  nodes_.clear();
  for (const std::uint32_t n : loop_)
  {
    nodes_.push_back({ n, box_.at[n], cone.axis, box_.planes[n] });
  }
  static const std::vector<LoopTriangulation::Triangle> nothing;
  const auto& triangles = loop_.size() < 3 ? nothing : triangulation_.triangulate(nodes_);
  if (!forced &&
    !std::all_of(triangles.begin(), triangles.end(),
      [&](const LoopTriangulation::Triangle& t) { return fits(t, cone.axis); }))
  {
    return false;
  }
  const Polygon like = largestOfFan();
  for (const std::uint32_t p : fan_)
  {
    box_.polygons[p].alive = false;
  }
  for (const auto& t : triangles)
  {
    const std::array<std::uint32_t, 3> c = { loop_[t[0]], loop_[t[1]], loop_[t[2]] };
    const Vector normal =
      unit(cross(minus(box_.at[c[1]], box_.at[c[0]]), minus(box_.at[c[2]], box_.at[c[0]])));
    box_.append(
      c.data(), c.data() + 3, like, { dot(normal, cone.axis) > 0 ? normal : cone.axis, 0 });
  }
  return true;
}

// Whether a triangle of the loop may replace polygons about this axis.
bool NodeRemoval::fits(const LoopTriangulation::Triangle& t, const Vector& axis) const
{
  const Vector normal =
    unit(cross(minus(nodes_[t[1]].at, nodes_[t[0]].at), minus(nodes_[t[2]].at, nodes_[t[0]].at)));
  const auto fitsAt = [&](std::uint32_t corner) {
    const std::uint32_t n = loop_[corner];
    return feature_[n] != 0 ||
      angleBetween(normal, cones_[n].axis) <= mergeRadius_ + cones_[n].spread;
  };
  const bool inSide = (nodes_[t[0]].planes & nodes_[t[1]].planes & nodes_[t[2]].planes) != 0;
  return dot(normal, normal) != 0 && angleBetween(normal, axis) <= mergeRadius_ && !inSide &&
    fitsAt(t[0]) && fitsAt(t[1]) && fitsAt(t[2]);
}

// Where a node cannot be removed, its polygons take another node instead.
void NodeRemoval::collapse(std::uint32_t node, std::uint32_t onto)
{
  if (!box_.kinds.empty())
  {
    raise(box_.kinds[onto], box_.kinds[node]);
  }
  const std::size_t count = box_.of[node].size();
  for (std::size_t i = 0; i < count; ++i)
  {
    Polygon& p = box_.polygons[box_.of[node][i]];
    if (!p.alive)
    {
      continue;
    }
    p.alive = false;
    const Polygon like = p;
    loop_.assign(box_.cornersOf(like), box_.cornersOf(like) + like.size);
    std::replace(loop_.begin(), loop_.end(), node, onto);
    forEachSimpleLoop(loop_, [&](const std::uint32_t* begin, const std::uint32_t* end) {
      box_.append(begin, end, like, like.cone);
    });
  }
}

}

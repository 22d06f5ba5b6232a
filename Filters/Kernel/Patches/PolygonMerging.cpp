// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/PolygonMerging.h"

#include "Base/Rings.h"
#include "Lattice/Vector.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr double Degree = Pi / 180;

// Sine of the angle beyond 180 degrees up to which a corner still counts as straight.
constexpr double MostConcave = 1e-3;

// Of a merged polygon: the time to merge grows with the square of their number.
constexpr std::uint32_t MostCorners = 128;

}

PolygonMerging::PolygonMerging(const Surface& surface, const PatchSpec& spec, BoxPolygons& box)
  : surface_(surface)
  , box_(box)
  , mergeRadius_(spec.mergeAngle * Degree / 2)
  , featureCosine_(std::cos(spec.featureAngle * Degree))
{
}

void PolygonMerging::merge()
{
  listCandidates();
  joined_.resize(box_.polygons.size());
  for (std::uint32_t i = 0; i < joined_.size(); ++i)
  {
    joined_[i] = i;
  }
  for (const MergeCandidate& candidate : candidates_)
  {
    joinAcross(candidate);
  }
  splitTurned();
}

// Lists the edges between two polygons: those of slivers first, then the longest.
void PolygonMerging::listCandidates()
{
  candidates_.clear();
  box_.listEdges(edges_);
  for (std::size_t i = 0; i < edges_.size();)
  {
    const std::size_t end = endOfEqual(edges_, i);
    const PolygonEdge& a = edges_[i];
    if (end - i == 2 && a.down != edges_[i + 1].down && a.polygon != edges_[i + 1].polygon)
    {
      const std::uint32_t left = a.down ? edges_[i + 1].polygon : a.polygon;
      const std::uint32_t right = a.down ? a.polygon : edges_[i + 1].polygon;
      candidates_.push_back({ box_.edgeLength(a.lower, a.upper),
        box_.isSliver(box_.polygons[left]) || box_.isSliver(box_.polygons[right]), left, right,
        a.lower, a.upper });
    }
    i = end;
  }
  std::sort(
    candidates_.begin(), candidates_.end(), [](const MergeCandidate& a, const MergeCandidate& b) {
      return a.sliver != b.sliver
        ? a.sliver
        : (a.length != b.length ? a.length > b.length
                                : (a.from != b.from ? a.from < b.from : a.to < b.to));
    });
}

std::uint32_t PolygonMerging::current(std::uint32_t polygon) const
{
  while (polygon < joined_.size() && joined_[polygon] != polygon)
  {
    polygon = joined_[polygon];
  }
  return polygon;
}

void PolygonMerging::joinAcross(const MergeCandidate& candidate)
{
  const std::uint32_t left = current(candidate.left);
  const std::uint32_t right = current(candidate.right);
  if (left == right)
  {
    return;
  }
  const Polygon p = box_.polygons[left];
  const Polygon q = box_.polygons[right];
  if (p.size + q.size > MostCorners)
  {
    return;
  }
  const bool pSliver = box_.isSliver(p);
  const bool sliver = pSliver || box_.isSliver(q);
  if (!surface_.walls.areAlike(surface_.boundary[p.triangle], surface_.boundary[q.triangle]))
  {
    return;
  }
  NormalCone cone = around(p.cone, q.cone);
  if (sliver)
  {
    cone = pSliver ? q.cone : p.cone;
  }
  else if (cone.spread > mergeRadius_ ||
    surface_.boundary[p.triangle] != surface_.boundary[q.triangle] ||
    box_.isSharp(surface_, p, q, candidate.from, candidate.to, featureCosine_))
  {
    return;
  }
  if (!unite(p, q, candidate.from, candidate.to) || !isConvex(ring_, sliver ? 1 : MostConcave))
  {
    return;
  }
  const bool likeP = pSliver == box_.isSliver(q) ? p.area >= q.area : !pSliver;
  const Polygon like = likeP ? p : q;
  box_.polygons[left].alive = false;
  box_.polygons[right].alive = false;
  joined_[left] = joined_[right] = static_cast<std::uint32_t>(box_.polygons.size());
  joined_.push_back(static_cast<std::uint32_t>(box_.polygons.size()));
  box_.append(ring_.data(), ring_.data() + ring_.size(), like, cone);
}

// Puts the ring around two polygons that share the edge from `from` to `to` into ring_. Returns false
// where they share more than one chain of edges.
bool PolygonMerging::unite(
  const Polygon& left, const Polygon& right, std::uint32_t from, std::uint32_t to)
{
  const std::uint32_t* const l = box_.cornersOf(left);
  const std::uint32_t* const r = box_.cornersOf(right);
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
  removeSpikes();
  sorted_ = ring_;
  std::sort(sorted_.begin(), sorted_.end());
  return ring_.size() > 2 && std::adjacent_find(sorted_.begin(), sorted_.end()) == sorted_.end();
}

// Two polygons that share a chain of several edges leave spikes.
void PolygonMerging::removeSpikes()
{
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
}

// Whether no corner is concave, and no star triangle inverted.
bool PolygonMerging::isConvex(const std::vector<std::uint32_t>& ring, double mostConcave) const
{
  const Vector normal = unit(box_.areaVector(ring.data(), ring.data() + ring.size()));
  Vector centre{ 0, 0, 0 };
  for (const std::uint32_t c : ring)
  {
    centre = plus(centre, box_.at[c]);
  }
  for (double& x : centre)
  {
    x /= static_cast<double>(ring.size());
  }
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Vector& p = box_.at[ring[i]];
    const Vector& q = box_.at[following(ring, i)];
    const Vector& r = box_.at[ring[(i + 2) % ring.size()]];
    const Vector pq = minus(q, p);
    const Vector qr = minus(r, q);
    if (dot(cross(pq, qr), normal) < -mostConcave * norm(pq) * norm(qr) ||
      !(dot(cross(minus(p, centre), minus(q, centre)), normal) > 0))
    {
      return false;
    }
  }
  return true;
}

// Cuts polygons that rounding or tying has left without a star triangulation into triangles.
void PolygonMerging::splitTurned()
{
  const std::size_t count = box_.polygons.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!box_.polygons[i].alive || box_.polygons[i].size == 3)
    {
      continue;
    }
    const Polygon p = box_.polygons[i];
    ring_.assign(box_.cornersOf(p), box_.cornersOf(p) + p.size);
    if (isConvex(ring_, 1))
    {
      continue;
    }
    nodes_.clear();
    for (const std::uint32_t n : ring_)
    {
      nodes_.push_back({ n, box_.at[n], p.cone.axis, box_.planes[n] });
    }
    box_.polygons[i].alive = false;
    for (const auto& t : triangulation_.triangulate(nodes_))
    {
      const std::array<std::uint32_t, 3> c = { ring_[t[0]], ring_[t[1]], ring_[t[2]] };
      box_.append(c.data(), c.data() + 3, p, p.cone);
    }
  }
}

}

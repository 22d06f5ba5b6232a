// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/MarchingCubes.h"

#include <numeric>

namespace cartesian
{

namespace
{

constexpr double Base = 7;
constexpr double MostCriterion = 4;

// Penalty for a triangle in a side of the box, where only inner faces should be.
constexpr double CostInSide = 1e3;

// No triangle costs less: the criterion is 1 where normals agree, to within rounding.
constexpr double LeastCost = 1 - 1e-12;

double costOf(const LoopNode& a, const LoopNode& b, const LoopNode& c)
{
  const Vector normal = unit(cross(minus(b.at, a.at), minus(c.at, a.at)));
  double cost = (a.planes & b.planes & c.planes) != 0 ? CostInSide : 0;
  if (dot(normal, normal) == 0)
  {
    return cost + MostCriterion;
  }
  const double cosine = dot(normal, a.normal);
  const double first = criterion(cosine) / 3;
  cost += first;
  for (const LoopNode* node : { &b, &c })
  {
    const double other = dot(normal, node->normal); // often the same: of a node that is removed
    cost += other == cosine ? first : criterion(other) / 3;
  }
  return cost;
}

}

double criterion(double s)
{
  static const double logBase = std::log(Base);
  return ((MostCriterion - 1) * std::exp(logBase * (1 - s)) + Base * Base - MostCriterion) /
    (Base * Base - 1);
}

const std::vector<LoopTriangulation::Triangle>& LoopTriangulation::triangulate(
  const std::vector<LoopNode>& loop)
{
  triangles_.clear();
  whole_.resize(loop.size());
  std::iota(whole_.begin(), whole_.end(), 0);
  if (loop.size() > MostNodes)
  {
    cutApart(loop, whole_);
  }
  else
  {
    optimise(loop, whole_);
  }
  return triangles_;
}

// Cuts at the shortest diagonal that leaves at least a third of the nodes on either side.
void LoopTriangulation::cutApart(
  const std::vector<LoopNode>& loop, std::vector<std::uint32_t> nodes)
{
  if (nodes.size() <= MostNodes)
  {
    optimise(loop, nodes);
    return;
  }
  const std::size_t n = nodes.size();
  double shortest = -1;
  std::array<std::size_t, 2> cut{ 0, n / 2 };
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = i + n / 3; j < n && j <= i + n - n / 3; ++j)
    {
      const LoopNode& p = loop[nodes[i]];
      const LoopNode& q = loop[nodes[j]];
      const Vector along = minus(q.at, p.at);
      const double length = dot(along, along);
      if ((p.planes & q.planes) == 0 && (shortest < 0 || length < shortest))
      {
        shortest = length;
        cut = { i, j };
      }
    }
  }
  const auto begin = nodes.begin() + std::ptrdiff_t(cut[0]);
  const auto end = nodes.begin() + std::ptrdiff_t(cut[1]);
  std::vector<std::uint32_t> part(begin, end + 1);
  nodes.erase(begin + 1, end);
  cutApart(loop, std::move(part));
  cutApart(loop, std::move(nodes));
}

// Dynamic programming over the chords: the part from node i to node j consists of a triangle on its
// chord and the two parts behind that triangle's other sides.
void LoopTriangulation::optimise(
  const std::vector<LoopNode>& loop, const std::vector<std::uint32_t>& nodes)
{
  const std::size_t n = nodes.size();
  cost_.assign(n * n, 0);
  apex_.assign(n * n, 0);
  for (std::size_t length = 2; length < n; ++length)
  {
    for (std::size_t i = 0; i + length < n; ++i)
    {
      const std::size_t j = i + length;
      double least = -1;
      for (std::size_t k = i + 1; k < j; ++k)
      {
        const double behind = cost_[i * n + k] + cost_[k * n + j];
        if (least >= 0 && behind + LeastCost >= least)
        {
          continue;
        }
        const double cost =
          behind + (n == 3 ? 0 : costOf(loop[nodes[i]], loop[nodes[k]], loop[nodes[j]]));
        if (least < 0 || cost < least)
        {
          least = cost;
          apex_[i * n + j] = static_cast<std::uint8_t>(k);
        }
      }
      cost_[i * n + j] = least;
    }
  }
  collect(nodes, 0, n - 1);
}

void LoopTriangulation::collect(
  const std::vector<std::uint32_t>& nodes, std::size_t first, std::size_t last)
{
  if (last - first < 2)
  {
    return;
  }
  const std::size_t apex = apex_[first * nodes.size() + last];
  triangles_.push_back({ nodes[first], nodes[apex], nodes[last] });
  collect(nodes, first, apex);
  collect(nodes, apex, last);
}

}

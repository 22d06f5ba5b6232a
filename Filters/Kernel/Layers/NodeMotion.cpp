// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/NodeMotion.h"

#include "Polyhedra/OffsetPlanes.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

// Conjugate gradients, until the residual is this part of the first one.
constexpr double Tolerance = 1e-3;
constexpr int MostSteps = 200;

// The weights of shorter edges, relative to the mean edge, are not larger.
constexpr double ShortestEdge = 1e-3;

struct Edge
{
  std::uint32_t from;
  std::uint32_t to;

  bool operator<(const Edge& other) const
  {
    return from != other.from ? from < other.from : to < other.to;
  }
  bool operator==(const Edge& other) const { return from == other.from && to == other.to; }
};

double product(const std::vector<Vector>& a, const std::vector<Vector>& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += dot(a[i], b[i]);
  }
  return sum;
}

}

NodeMotion::NodeMotion(
  const NearCells& near, const LayeredWall& wall, const std::vector<double>& points)
{
  for (std::uint32_t p = 0; p < near.mayMove.size(); ++p)
  {
    if (near.mayMove[p])
    {
      moving_.push_back(p);
    }
  }
  ways_.assign(moving_.size(), Vector{});
  fixed_.assign(moving_.size(), nullptr);
  for (std::size_t n = 0; n < wall.nodes(); ++n)
  {
    const auto point = static_cast<std::uint32_t>(wall.faces.meshPoint[n]);
    const auto at = std::lower_bound(moving_.begin(), moving_.end(), point);
    if (at != moving_.end() && *at == point)
    {
      fixed_[static_cast<std::size_t>(at - moving_.begin())] = &wall.fixed[n];
    }
  }
  listLinks(near, points);
}

void NodeMotion::listLinks(const NearCells& near, const std::vector<double>& points)
{
  std::vector<std::uint32_t> indexOf(near.mayMove.size(), None); // in moving_, or beyond a node
  for (std::uint32_t i = 0; i < moving_.size(); ++i)
  {
    indexOf[moving_[i]] = i;
  }
  std::vector<Edge> edges;
  const auto add = [&](std::uint32_t p, std::uint32_t q) {
    if (near.mayMove[p])
    {
      edges.push_back({ p, q });
    }
  };
  const CellFaces& cells = near.cells;
  for (std::size_t f = 0; f < cells.faceCount(); ++f)
  {
    std::uint32_t from = cells.corners[cells.firstCorner[f + 1] - 1];
    for (std::size_t i = cells.firstCorner[f]; i < cells.firstCorner[f + 1]; ++i)
    {
      const std::uint32_t to = cells.corners[i];
      add(from, to);
      add(to, from);
      from = to;
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const auto length = [&](const Edge& edge) {
    const double* const a = &points[3 * std::size_t(edge.from)];
    const double* const b = &points[3 * std::size_t(edge.to)];
    return norm(Vector{ b[0] - a[0], b[1] - a[1], b[2] - a[2] });
  };
  double mean = 0;
  for (const Edge& edge : edges)
  {
    mean += length(edge) / static_cast<double>(edges.size());
  }
  firstLink_.assign(moving_.size() + 1, 0);
  sums_.assign(moving_.size(), 0);
  for (const Edge& edge : edges)
  {
    const std::uint32_t i = indexOf[edge.from];
    const double weight = 1 / std::max(length(edge), ShortestEdge * mean);
    sums_[i] += weight;
    const std::uint32_t node = near.wallNode[edge.to];
    if (near.mayMove[edge.to] || node != None)
    {
      ++firstLink_[i + 1];
      links_.push_back({ node != None ? static_cast<std::uint32_t>(moving_.size()) + node
                                      : indexOf[edge.to],
        weight });
    }
  }
  for (std::size_t i = 0; i < moving_.size(); ++i)
  {
    firstLink_[i + 1] += firstLink_[i];
  }
}

Vector NodeMotion::within(std::size_t i, const Vector& v) const
{
  return fixed_[i] ? cartesian::within(*fixed_[i], v) : v;
}

std::vector<Vector> NodeMotion::residual(const LayeredWall& wall) const
{
  std::vector<Vector> r(ways_.size());
  for (std::size_t i = 0; i < r.size(); ++i)
  {
    Vector sum = scaled(ways_[i], -sums_[i]);
    for (std::size_t l = firstLink_[i]; l < firstLink_[i + 1]; ++l)
    {
      const std::size_t to = links_[l].to;
      const std::size_t node = to - ways_.size();
      sum = plus(sum,
        scaled(to < ways_.size() ? ways_[to] : scaled(wall.way[node], wall.parts[node]),
          links_[l].weight));
    }
    r[i] = within(i, sum);
  }
  return r;
}

void NodeMotion::run(const LayeredWall& wall)
{
  std::vector<Vector> r = residual(wall);
  std::vector<Vector> z(r.size());
  std::vector<Vector> ofStep(r.size());
  const auto precondition = [&] {
    for (std::size_t i = 0; i < r.size(); ++i)
    {
      z[i] = scaled(r[i], 1 / sums_[i]);
    }
  };
  precondition();
  std::vector<Vector> step = z;
  double rz = product(r, z);
  const double enough = Tolerance * Tolerance * rz;
  for (int s = 0; s < MostSteps && rz > enough; ++s)
  {
    for (std::size_t i = 0; i < r.size(); ++i)
    {
      Vector sum = scaled(step[i], sums_[i]);
      for (std::size_t l = firstLink_[i]; l < firstLink_[i + 1]; ++l)
      {
        if (links_[l].to < step.size())
        {
          sum = minus(sum, scaled(step[links_[l].to], links_[l].weight));
        }
      }
      ofStep[i] = within(i, sum);
    }
    const double alpha = rz / product(step, ofStep);
    for (std::size_t i = 0; i < r.size(); ++i)
    {
      ways_[i] = plus(ways_[i], scaled(step[i], alpha));
      r[i] = minus(r[i], scaled(ofStep[i], alpha));
    }
    precondition();
    const double next = product(r, z);
    for (std::size_t i = 0; i < r.size(); ++i)
    {
      step[i] = plus(z[i], scaled(step[i], next / rz));
    }
    rz = next;
  }
}

}

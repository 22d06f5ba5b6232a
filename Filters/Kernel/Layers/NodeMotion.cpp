// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/NodeMotion.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Over so many thicknesses a way along the wall fades to a third.
constexpr double FadeLength = 5;

// The weights of edges shorter than this part of the mean one are not larger.
constexpr double ShortestEdge = 1e-3;

struct Edge
{
  std::uint32_t from;
  std::uint32_t to;
  double length;

  bool operator<(const Edge& other) const
  {
    return from != other.from ? from < other.from : to < other.to;
  }
  bool operator==(const Edge& other) const { return from == other.from && to == other.to; }
};

// Each once, with no length below ShortestEdge.
void tidy(std::vector<Edge>& edges)
{
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  double mean = 0;
  for (const Edge& edge : edges)
  {
    mean += edge.length / static_cast<double>(edges.size());
  }
  for (Edge& edge : edges)
  {
    edge.length = std::max(edge.length, ShortestEdge * mean);
  }
}

}

void spreadWays(LayeredWall& wall, Execution& execution)
{
  std::vector<Edge> edges;
  for (std::size_t f = 0; f < wall.layered.size(); ++f)
  {
    for (std::size_t i = 0; wall.layered[f] && i < wall.corners(f); ++i)
    {
      const std::size_t a = wall.node(f, i);
      const std::size_t b = wall.node(f, i + 1);
      const double length = norm(minus(wall.place[b], wall.place[a]));
      edges.push_back({ static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), length });
      edges.push_back({ static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(a), length });
    }
  }
  tidy(edges);
  std::vector<HarmonicField::Link> links;
  std::vector<double> damping(wall.nodes());
  for (const Edge& edge : edges)
  {
    links.push_back({ edge.from, edge.to, 1 / edge.length });
    const double thickness = wall.usual[edge.from];
    damping[edge.from] += edge.length / (2 * FadeLength * FadeLength * thickness * thickness);
  }
  std::vector<const std::vector<Vector>*> fixed;
  for (const std::vector<Vector>& normals : wall.across)
  {
    fixed.push_back(&normals);
  }
  HarmonicField field(wall.way, std::move(links), std::move(damping), std::move(fixed));
  field.solve(execution);
  wall.way = std::move(field.values());
}

NodeMotion::NodeMotion(
  const NearCells& near, const LayeredWall& wall, const std::vector<double>& points)
  : wall_(wall)
{
  for (std::uint32_t p = 0; p < near.mayMove.size(); ++p)
  {
    if (near.mayMove[p])
    {
      moving_.push_back(p);
    }
  }
  makeField(near, points);
}

void NodeMotion::makeField(const NearCells& near, const std::vector<double>& points)
{
  const auto count = static_cast<std::uint32_t>(moving_.size());
  std::vector<std::uint32_t> indexOf(near.mayMove.size(), None); // in the field
  for (std::uint32_t i = 0; i < count; ++i)
  {
    indexOf[moving_[i]] = i;
  }
  std::vector<const std::vector<Vector>*> fixed(count, nullptr);
  for (std::uint32_t n = 0; n < wall_.nodes(); ++n)
  {
    const auto point = static_cast<std::size_t>(wall_.of.mesh.meshPoint[n]);
    if (near.mayMove[point])
    {
      fixed[indexOf[point]] = &wall_.fixed[n];
    }
    else if (wall_.isOnWall[n])
    {
      indexOf[point] = count + n;
    }
  }
  std::vector<Edge> edges;
  const auto add = [&](std::uint32_t p, std::uint32_t q) {
    const double* const a = &points[3 * std::size_t(p)];
    const double* const b = &points[3 * std::size_t(q)];
    const double length = norm(Vector{ b[0] - a[0], b[1] - a[1], b[2] - a[2] });
    if (near.mayMove[p])
    {
      edges.push_back({ indexOf[p], indexOf[q], length });
    }
    if (near.mayMove[q])
    {
      edges.push_back({ indexOf[q], indexOf[p], length });
    }
  };
  const CellFaces& cells = near.cells;
  for (std::size_t f = 0; f < cells.faceCount(); ++f)
  {
    std::uint32_t from = cells.corners[cells.firstCorner[f + 1] - 1];
    for (std::size_t i = cells.firstCorner[f]; i < cells.firstCorner[f + 1]; ++i)
    {
      add(from, cells.corners[i]);
      from = cells.corners[i];
    }
  }
  tidy(edges);
  std::vector<HarmonicField::Link> links;
  std::vector<double> damping(count);
  for (const Edge& edge : edges)
  {
    if (edge.to == None)
    {
      damping[edge.from] += 1 / edge.length;
    }
    else
    {
      links.push_back({ edge.from, edge.to, 1 / edge.length });
    }
  }
  field_ = HarmonicField(std::vector<Vector>(count + wall_.nodes()), std::move(links),
    std::move(damping), std::move(fixed));
}

bool NodeMotion::hold(std::uint32_t point)
{
  const auto at = std::lower_bound(moving_.begin(), moving_.end(), point);
  return at != moving_.end() && *at == point &&
    field_.hold(static_cast<std::size_t>(at - moving_.begin()));
}

void NodeMotion::run(Execution& execution)
{
  for (std::size_t n = 0; n < wall_.nodes(); ++n)
  {
    field_.values()[moving_.size() + n] = scaled(wall_.way[n], wall_.parts[n]);
  }
  field_.solve(execution);
}

}

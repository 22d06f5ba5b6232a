// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/NodeMotion.h"

#include "Base/ForEachItem.h"
#include "Layers/EdgeGraph.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Over so many thicknesses a way along the wall fades to a third.
constexpr double FadeLength = 5;

// The weights of edges shorter than this part of the mean one are not larger.
constexpr double ShortestEdge = 1e-3;

// Of each edge of a graph, lengthOf(from, to), but none below ShortestEdge.
template <class LengthOf>
std::vector<double> lengthsOf(
  const EdgeGraph& graph, const LengthOf& lengthOf, Execution& execution)
{
  std::vector<double> lengths(graph.edges());
  std::vector<double> sums(chunks(graph.nodes(), ItemsOfALoop));
  forEachItem(graph.nodes(), execution, [&](std::size_t n) {
    for (std::size_t e = graph.first(n); e < graph.end(n); ++e)
    {
      lengths[e] = lengthOf(n, graph.to(e));
      sums[n / ItemsOfALoop] += lengths[e];
    }
  });
  const double mean = std::accumulate(sums.begin(), sums.end(), 0.0) /
    std::max(1.0, static_cast<double>(lengths.size()));
  for (double& length : lengths)
  {
    length = std::max(length, ShortestEdge * mean);
  }
  return lengths;
}

}

void spreadWays(LayeredWall& wall, Execution& execution)
{
  const EdgeGraph graph(
    wall.nodes(),
    [&](auto&& visit) {
      for (std::size_t f = 0; f < wall.layered.size(); ++f)
      {
        for (std::size_t i = 0; wall.layered[f] && i < wall.corners(f); ++i)
        {
          const std::size_t a = wall.node(f, i);
          const std::size_t b = wall.node(f, i + 1);
          visit(a, static_cast<std::uint32_t>(b));
          visit(b, static_cast<std::uint32_t>(a));
        }
      }
    },
    execution);
  const std::vector<double> lengths = lengthsOf(
    graph, [&](std::size_t a, std::size_t b) { return norm(minus(wall.place[b], wall.place[a])); },
    execution);
  std::vector<HarmonicField::Link> links;
  links.reserve(graph.edges());
  std::vector<double> damping(wall.nodes());
  for (std::size_t n = 0; n < wall.nodes(); ++n)
  {
    for (std::size_t e = graph.first(n); e < graph.end(n); ++e)
    {
      links.push_back({ graph.to(e), 1 / lengths[e] });
      const double thickness = wall.usual[n];
      damping[n] += lengths[e] / (2 * FadeLength * FadeLength * thickness * thickness);
    }
  }
  std::vector<const std::vector<Vector>*> fixed;
  for (const std::vector<Vector>& normals : wall.across)
  {
    fixed.push_back(&normals);
  }
  HarmonicField field(
    wall.way, graph.firsts(), std::move(links), std::move(damping), std::move(fixed));
  field.solve(execution);
  wall.way = std::move(field.values());
}

NodeMotion::NodeMotion(const NearCells& near, const LayeredWall& wall,
  const std::vector<double>& points, Execution& execution)
  : wall_(wall)
{
  for (std::uint32_t p = 0; p < near.mayMove.size(); ++p)
  {
    if (near.mayMove[p])
    {
      moving_.push_back(p);
    }
  }
  makeField(near, points, execution);
}

// Of each of the mesh's points in the field; None: it stays where it is.
std::vector<std::uint32_t> NodeMotion::numbersInField(std::size_t points) const
{
  std::vector<std::uint32_t> numbers(points, None);
  const auto count = static_cast<std::uint32_t>(moving_.size());
  for (std::uint32_t n = 0; n < wall_.nodes(); ++n)
  {
    if (wall_.isOnWall[n])
    {
      numbers[static_cast<std::size_t>(wall_.of.mesh.meshPoint[n])] = count + n;
    }
  }
  for (std::uint32_t i = 0; i < count; ++i)
  {
    numbers[moving_[i]] = i;
  }
  return numbers;
}

void NodeMotion::makeField(
  const NearCells& near, const std::vector<double>& points, Execution& execution)
{
  const std::size_t count = moving_.size();
  const std::vector<std::uint32_t> numbers = numbersInField(near.mayMove.size());
  const CellFaces& cells = near.cells;
  // Either face of a cell at an edge has it the other way round.
  const EdgeGraph graph(
    count,
    [&](auto&& visit) {
      for (std::size_t f = 0; f < cells.faceCount(); ++f)
      {
        std::uint32_t from = cells.corners[cells.firstCorner[f + 1] - 1];
        for (std::size_t i = cells.firstCorner[f]; i < cells.firstCorner[f + 1]; ++i)
        {
          near.mayMove[from] ? visit(numbers[from], cells.corners[i]) : void();
          from = cells.corners[i];
        }
      }
    },
    execution);
  const std::vector<double> lengths = lengthsOf(
    graph,
    [&](std::size_t i, std::size_t q) {
      const double* const a = &points[3 * std::size_t(moving_[i])];
      const double* const b = &points[3 * q];
      return norm(Vector{ b[0] - a[0], b[1] - a[1], b[2] - a[2] });
    },
    execution);
  std::vector<HarmonicField::Link> links;
  links.reserve(graph.edges());
  std::vector<std::size_t> firstLink{ 0 };
  std::vector<double> damping(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t e = graph.first(i); e < graph.end(i); ++e)
    {
      const std::uint32_t to = numbers[graph.to(e)];
      to == None ? void(damping[i] += 1 / lengths[e]) : links.push_back({ to, 1 / lengths[e] });
    }
    firstLink.push_back(links.size());
  }
  std::vector<const std::vector<Vector>*> fixed(count, nullptr);
  for (std::size_t n = 0; n < wall_.nodes(); ++n)
  {
    const auto point = static_cast<std::size_t>(wall_.of.mesh.meshPoint[n]);
    if (near.mayMove[point])
    {
      fixed[numbers[point]] = &wall_.fixed[n];
    }
  }
  field_ = HarmonicField(std::vector<Vector>(count + wall_.nodes()), std::move(firstLink),
    std::move(links), std::move(damping), std::move(fixed));
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

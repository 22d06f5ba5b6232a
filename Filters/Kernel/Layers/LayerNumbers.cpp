// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/LayerNumbers.h"

#include <algorithm>
#include <numeric>

namespace cartesian
{

std::vector<Id> numbersWithLayers(const OutputMesh& mesh, const PrismStacks& stacks)
{
  const auto cells = static_cast<std::size_t>(mesh.cellCount());
  std::vector<Id> next(cells + 1); // of each cell
  for (std::size_t c = 0; c < cells; ++c)
  {
    next[c + 1] = 1;
  }
  for (const Id below : stacks.below)
  {
    ++next[static_cast<std::size_t>(below) + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Id> numbers;
  for (std::size_t c = 0; c < cells; ++c)
  {
    numbers.push_back(next[c]++);
  }
  for (const Id below : stacks.below)
  {
    numbers.push_back(next[static_cast<std::size_t>(below)]++);
  }
  return numbers;
}

void renumber(LayeredBoundary& boundary, const std::vector<Id>& numbers)
{
  for (BoundaryFace& face : boundary.faces)
  {
    face.cell = numbers[static_cast<std::size_t>(face.cell)];
  }
  for (LayeredInterface& face : boundary.interfaces)
  {
    face.cell = numbers[static_cast<std::size_t>(face.cell)];
  }
  std::vector<std::size_t> order(boundary.faces.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return boundary.faces[a].cell < boundary.faces[b].cell; });
  LayeredBoundary sorted;
  for (const std::size_t f : order)
  {
    sorted.faces.push_back(boundary.faces[f]);
    sorted.stacks.push_back(boundary.stacks[f]);
    std::vector<Id>& corners = sorted.mesh.corners;
    sorted.mesh.start.push_back(static_cast<Id>(corners.size())); // the end comes last
    corners.insert(corners.end(), boundary.mesh.corners.begin() + boundary.mesh.start[f],
      boundary.mesh.corners.begin() + boundary.mesh.start[f + 1]);
  }
  sorted.mesh.start.push_back(static_cast<Id>(sorted.mesh.corners.size()));
  sorted.mesh.meshPoint = std::move(boundary.mesh.meshPoint);
  sorted.interfaces = std::move(boundary.interfaces);
  boundary = std::move(sorted);
}

}

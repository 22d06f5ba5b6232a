// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/ManifoldComponents.h"

#include "Surface/Components.h"

#include <algorithm>
#include <numeric>

namespace cartesian
{

ManifoldComponents::ManifoldComponents(
  const Surface& surface, const SurfaceEdges& edges, Execution& execution)
  : parent_(surface.triangles.size())
  , turned_(surface.triangles.size())
  , open_(surface.triangles.size())
{
  std::iota(parent_.begin(), parent_.end(), 0);
  edges.forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
    if (end - begin == 2)
    {
      join(begin[0].triangle(), begin[1].triangle(), begin[0].down() == begin[1].down());
    }
  });
  joinAsGiven(surface, edges);
  for (std::size_t t = 0; t < parent_.size(); ++t)
  {
    find(static_cast<std::uint32_t>(t));
  }
  findOpen(edges, execution);
}

// Once each triangle's parent is its root.
void ManifoldComponents::findOpen(const SurfaceEdges& edges, Execution& execution)
{
  std::vector<std::vector<std::uint32_t>> parts(edges.chunkCount());
  edges.forEach(
    execution, [&](std::size_t chunk, std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
      for (const EdgeUse* use = begin; use != end; ++use)
      {
        const std::uint32_t sheet = of(use->triangle());
        if (netUse(sheet, begin, end) != 0)
        {
          parts[chunk].push_back(sheet);
        }
      }
    });
  for (const std::uint32_t sheet : concatenated(parts))
  {
    open_[sheet] = 1;
  }
}

// Joins sheets that close only together, in components whose triangles were all given with consistent
// directions.
void ManifoldComponents::joinAsGiven(const Surface& surface, const SurfaceEdges& edges)
{
  bool any = false;
  edges.forEach(
    [&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) { any = any || end - begin > 2; });
  if (!any)
  {
    return;
  }
  DisjointSets components = connectedComponents(surface);
  std::vector<std::uint8_t> inconsistent(surface.vertices.size());
  edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
    const auto down = std::count_if(begin, end, [](const EdgeUse& use) { return use.down(); });
    if (std::abs((end - begin) - 2 * down) > (end - begin) % 2)
    {
      inconsistent[components.find(lower)] = 1;
    }
  });
  edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
    if ((end - begin) % 2 == 1 || end - begin == 2 || inconsistent[components.find(lower)] != 0)
    {
      return;
    }
    const EdgeUse* before = nullptr;
    for (const EdgeUse* use = begin; use != end; ++use)
    {
      if (netUse(find(use->triangle()), begin, end) != 0)
      {
        if (before)
        {
          join(before->triangle(), use->triangle(), false);
        }
        before = use;
      }
    }
  });
}

// How many more triangles of a sheet run down an edge than up it, if all agree with the sheet's
// first.
int ManifoldComponents::netUse(std::uint32_t sheet, const EdgeUse* begin, const EdgeUse* end)
{
  int net = 0;
  for (const EdgeUse* use = begin; use != end; ++use)
  {
    if (find(use->triangle()) == sheet)
    {
      net += use->down() != turned(use->triangle()) ? 1 : -1;
    }
  }
  return net;
}

// The root, after compressing the path to it.
std::uint32_t ManifoldComponents::find(std::uint32_t t)
{
  std::uint32_t root = t;
  std::uint8_t turned = 0;
  while (parent_[root] != root)
  {
    turned ^= turned_[root];
    root = parent_[root];
  }
  while (parent_[t] != root && t != root)
  {
    const std::uint32_t next = parent_[t];
    const std::uint8_t own = turned_[t];
    parent_[t] = root;
    turned_[t] = turned;
    turned ^= own;
    t = next;
  }
  return root;
}

// The lower root wins. A contradiction (a Moebius band) is left where it is found.
void ManifoldComponents::join(std::uint32_t a, std::uint32_t b, bool opposite)
{
  const std::uint32_t rootA = find(a);
  const std::uint32_t rootB = find(b);
  const auto between =
    static_cast<std::uint8_t>(turned_[a] ^ turned_[b] ^ static_cast<std::uint8_t>(opposite));
  if (rootA != rootB)
  {
    const auto [low, high] = std::minmax(rootA, rootB);
    parent_[high] = low;
    turned_[high] = between;
  }
}

}

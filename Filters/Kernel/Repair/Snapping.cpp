// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Snapping.h"

#include "Lattice/Vector.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Of two faces and the lattice.
constexpr double Roundings = 3;

// Between neighbouring places of vertices.
constexpr double OneStep = 2;

}

Placing placingOf(const Surface& surface)
{
  constexpr double snapped = 64;
  const double together = Roundings * surface.rounding;
  const double reach = std::max(snapped, together);
  return { together, reach, reach, std::max(snapped, 4 * together) };
}

std::array<Placing, 4> otherPlacingsOf(const Surface& surface)
{
  constexpr double decimals = 20; // of a file: a hundred-millionth of the domain
  const Placing given = placingOf(surface);
  const auto placing = [&](double together, double reach) {
    return Placing{ together, reach, 0, given.snap, true };
  };
  return { placing(Roundings, OneStep), placing(decimals, 1.5 * decimals),
    placing(given.together, given.together), placing(Roundings, OneStep / 2) };
}

VertexIndex::VertexIndex(std::vector<Point>& vertices, double reach)
  : vertices_(vertices)
  , reach_(reach)
  , given_(vertices.size())
{
  while (static_cast<double>(1U << cellBits_) < reach)
  {
    ++cellBits_;
  }
  cells_.reserve(2 * vertices.size());
  for (std::uint32_t v = 0; v < vertices.size(); ++v)
  {
    add(v);
  }
}

std::uint32_t VertexIndex::at(const Point& place)
{
  auto best = static_cast<std::uint32_t>(vertices_.size());
  double least = reach_;
  for (int i = 0; i < 27; ++i)
  {
    const auto cell = cells_.find(keyOf(place, { i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 }));
    for (std::uint32_t v = cell == cells_.end() ? None : cell->second; v != None; v = next_[v])
    {
      const double distance = norm(minus(vertices_[v], place));
      if (distance < least || (distance == least && v < best))
      {
        least = distance;
        best = v;
      }
    }
  }
  if (best == vertices_.size())
  {
    vertices_.push_back(place);
    add(best);
  }
  return same_.find(best);
}

bool VertexIndex::merge(std::uint32_t p, std::uint32_t q)
{
  const bool merges =
    p != q && std::max(p, q) >= given_ && norm(minus(vertices_[p], vertices_[q])) < 2 * reach_;
  if (merges)
  {
    same_.unite(p, q);
  }
  return merges;
}

std::uint64_t VertexIndex::keyOf(const Point& p, const std::array<int, 3>& aside) const
{
  std::uint64_t key = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::uint64_t cell = (p[axis] >> cellBits_) + static_cast<std::uint64_t>(aside[axis] + 1);
    key = (key ^ cell) * 0x9e3779b97f4a7c15u;
    key ^= key >> 29;
  }
  return key;
}

void VertexIndex::add(std::uint32_t v)
{
  same_.add();
  const auto [first, isNew] = cells_.emplace(keyOf(vertices_[v]), v);
  next_.push_back(isNew ? None : first->second);
  first->second = v;
}

}

// Connected components of a surface.
#pragma once

#include "Surface/Surface.h"

#include <numeric>

namespace cartesian
{

// Sets of vertices that triangles connect.
class Components
{
public:
  explicit Components(const Surface& surface)
    : parent_(surface.vertices.size())
  {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const auto& t : surface.triangles)
    {
      join(t[0], t[1]);
      join(t[0], t[2]);
    }
  }

  std::uint32_t of(std::uint32_t v)
  {
    while (parent_[v] != v)
    {
      parent_[v] = parent_[parent_[v]];
      v = parent_[v];
    }
    return v;
  }

private:
  void join(std::uint32_t a, std::uint32_t b)
  {
    const std::uint32_t rootA = of(a);
    const std::uint32_t rootB = of(b);
    parent_[std::max(rootA, rootB)] = std::min(rootA, rootB);
  }

  std::vector<std::uint32_t> parent_;
};

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Duplicates.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::uint32_t None = ~0u;

std::uint32_t thirdVertex(const Surface& surface, std::uint32_t lower, const EdgeUse& use)
{
  const auto& v = surface.triangles[use.triangle()];
  return v[0] ^ v[1] ^ v[2] ^ lower ^ use.upper;
}

// Sets of groups that share edges.
class Regions
{
public:
  explicit Regions(std::size_t groups)
    : sets_(groups)
    , balance_(groups)
    , inconsistent_(groups)
  {
  }

  void join(std::uint32_t a, std::uint32_t b)
  {
    const std::uint32_t rootA = sets_.find(a);
    const std::uint32_t rootB = sets_.find(b);
    if (rootA != rootB)
    {
      const std::uint32_t root = sets_.unite(rootA, rootB);
      const std::uint32_t absorbed = root == rootA ? rootB : rootA;
      balance_[root] += balance_[absorbed];
      inconsistent_[root] |= inconsistent_[absorbed];
    }
  }

  void vote(std::uint32_t group, bool keep) { balance_[sets_.find(group)] += keep ? 1 : -1; }
  bool keeps(std::uint32_t group) { return balance_[sets_.find(group)] >= 0; }

  void setInconsistent(std::uint32_t group) { inconsistent_[sets_.find(group)] = 1; }
  bool consistent(std::uint32_t group) { return inconsistent_[sets_.find(group)] == 0; }

private:
  DisjointSets sets_;
  std::vector<long long> balance_;
  std::vector<std::uint8_t>
    inconsistent_; // an edge is run through more often one way than the other
};

// Whether the corners ascend, but for their rotation.
bool ascends(const std::array<std::uint32_t, 3>& v)
{
  return (v[0] < v[1]) + (v[1] < v[2]) + (v[2] < v[0]) == 2;
}

// Sorts those to keep to the front; returns how many they are.
std::ptrdiff_t sortByUse(
  const Surface& surface, std::uint32_t* begin, std::uint32_t* end, bool keepsOne, bool consistent)
{
  const auto up =
    std::count_if(begin, end, [&](std::uint32_t t) { return ascends(surface.triangles[t]); });
  const std::ptrdiff_t net = 2 * up - (end - begin);
  std::stable_sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
    const bool oppositeA = consistent && ascends(surface.triangles[a]) != (net > 0);
    const bool oppositeB = consistent && ascends(surface.triangles[b]) != (net > 0);
    return std::make_tuple(oppositeA, surface.boundary[a]) <
      std::make_tuple(oppositeB, surface.boundary[b]);
  });
  return keepsOne ? 1 : (consistent ? std::abs(net) : 0);
}

}

Duplicates findDuplicates(const Surface& surface, const SurfaceEdges& edges)
{
  Duplicates result;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found; // third vertex, triangle
  edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
    if (end - begin < 2)
    {
      return;
    }
    found.clear();
    for (const EdgeUse* use = begin; use != end; ++use)
    {
      const std::uint32_t third = thirdVertex(surface, lower, *use);
      if (third > use->upper) // once for each triangle
      {
        found.emplace_back(third, use->triangle());
      }
    }
    std::sort(found.begin(), found.end());
    for (std::size_t i = 0; i < found.size();)
    {
      std::size_t next = i + 1;
      while (next < found.size() && found[next].first == found[i].first)
      {
        ++next;
      }
      if (next > i + 1)
      {
        result.start.push_back(result.triangles.size());
        for (; i < next; ++i)
        {
          result.triangles.push_back(found[i].second);
        }
      }
      i = next;
    }
  });
  result.start.push_back(result.triangles.size());
  return result;
}

std::vector<DroppedTriangle> dropDuplicates(
  Surface& surface, const SurfaceEdges& edges, const Duplicates& duplicates)
{
  std::vector<DroppedTriangle> dropped;
  if (duplicates.groups() == 0)
  {
    return dropped;
  }
  std::vector<std::uint32_t> groupOf(surface.triangles.size(), None);
  for (std::size_t g = 0; g < duplicates.groups(); ++g)
  {
    for (std::size_t i = duplicates.start[g]; i < duplicates.start[g + 1]; ++i)
    {
      groupOf[duplicates.triangles[i]] = static_cast<std::uint32_t>(g);
    }
  }
  Regions regions(duplicates.groups());
  std::vector<std::uint32_t> groups;
  edges.forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
    std::size_t others = 0;
    std::ptrdiff_t down = 0;
    groups.clear();
    for (const EdgeUse* use = begin; use != end; ++use)
    {
      const std::uint32_t group = groupOf[use->triangle()];
      others += group == None;
      down += use->down();
      if (group != None)
      {
        groups.push_back(group);
        regions.join(groups.front(), group);
      }
    }
    if (groups.empty())
    {
      return;
    }
    if (2 * down != end - begin)
    {
      regions.setInconsistent(groups.front());
    }
    std::sort(groups.begin(), groups.end());
    const std::ptrdiff_t here = std::unique(groups.begin(), groups.end()) - groups.begin();
    if (here % 2 == 1) // else it is all the same to this edge
    {
      regions.vote(groups.front(), others % 2 == 1);
    }
  });
  std::vector<std::uint32_t> group;
  for (std::uint32_t g = 0; g < duplicates.groups(); ++g)
  {
    const auto first = duplicates.triangles.begin();
    group.assign(first + static_cast<std::ptrdiff_t>(duplicates.start[g]),
      first + static_cast<std::ptrdiff_t>(duplicates.start[g + 1]));
    const std::ptrdiff_t kept = sortByUse(
      surface, group.data(), group.data() + group.size(), regions.keeps(g), regions.consistent(g));
    for (auto t = group.begin() + kept; t != group.end(); ++t)
    {
      dropped.push_back({ *t, surface.triangles[*t] });
      surface.triangles[*t].fill(surface.triangles[*t][0]);
    }
  }
  return dropped;
}

}

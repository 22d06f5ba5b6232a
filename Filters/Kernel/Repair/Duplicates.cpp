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

// Connected groups, and the votes of their edges.
class ConnectedGroups
{
public:
  explicit ConnectedGroups(std::size_t groups)
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
  std::vector<long long> balance_; // votes to keep one triangle minus votes to keep none
  std::vector<std::uint8_t>
    inconsistent_; // whether more triangles run one way along some edge than the other
};

// Whether the corners ascend, up to rotation.
bool ascends(const std::array<std::uint32_t, 3>& v)
{
  return (v[0] < v[1]) + (v[1] < v[2]) + (v[2] < v[0]) == 2;
}

// Sorts the triangles of a group so that those to keep come first; returns their number.
std::ptrdiff_t sortKeptFirst(
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

// The group of each triangle, or None.
std::vector<std::uint32_t> listGroups(const Duplicates& duplicates, std::size_t triangles)
{
  std::vector<std::uint32_t> groupOf(triangles, None);
  for (std::size_t g = 0; g < duplicates.groups(); ++g)
  {
    for (std::size_t i = duplicates.start[g]; i < duplicates.start[g + 1]; ++i)
    {
      groupOf[duplicates.triangles[i]] = static_cast<std::uint32_t>(g);
    }
  }
  return groupOf;
}

// Connects the groups that share edges; each edge votes on whether its groups keep a triangle.
ConnectedGroups connectGroups(
  const Surface& surface, const SurfaceEdges& edges, const Duplicates& duplicates)
{
  const std::vector<std::uint32_t> groupOf = listGroups(duplicates, surface.triangles.size());
  ConnectedGroups connected(duplicates.groups());
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
        connected.join(groups.front(), group);
      }
    }
    if (groups.empty())
    {
      return;
    }
    if (2 * down != end - begin)
    {
      connected.setInconsistent(groups.front());
    }
    std::sort(groups.begin(), groups.end());
    const std::ptrdiff_t here = std::unique(groups.begin(), groups.end()) - groups.begin();
    if (here % 2 == 1) // with an even number of groups, either choice closes the edge
    {
      connected.vote(groups.front(), others % 2 == 1);
    }
  });
  return connected;
}

// Adds the groups of the triangles at an edge that have no lower vertex than it, nor a lower one beside its lower one.
void addGroups(const Surface& surface, std::uint32_t lower, const EdgeUse* begin,
  const EdgeUse* end, Duplicates& result)
{
  if (end - begin < 2)
  {
    return;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found; // third vertex, triangle
  for (const EdgeUse* use = begin; use != end; ++use)
  {
    const std::uint32_t third = thirdVertex(surface, lower, *use);
    if (third > use->upper) // once for each triangle
    {
      found.emplace_back(third, use->triangle());
    }
  }
  std::sort(found.begin(), found.end());
  for (std::size_t i = 0, next = 0; i < found.size(); i = next)
  {
    while (next < found.size() && found[next].first == found[i].first)
    {
      ++next;
    }
    if (next > i + 1)
    {
      result.start.push_back(result.triangles.size());
      for (std::size_t t = i; t < next; ++t)
      {
        result.triangles.push_back(found[t].second);
      }
    }
  }
}

}

Duplicates findDuplicates(const Surface& surface, const SurfaceEdges& edges, Execution& execution)
{
  std::vector<Duplicates> parts(edges.chunkCount());
  edges.forEach(execution,
    [&](std::size_t chunk, std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      addGroups(surface, lower, begin, end, parts[chunk]);
    });
  Duplicates result;
  for (const Duplicates& part : parts)
  {
    for (const std::size_t start : part.start)
    {
      result.start.push_back(result.triangles.size() + start);
    }
    result.triangles.insert(result.triangles.end(), part.triangles.begin(), part.triangles.end());
  }
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
  ConnectedGroups connected = connectGroups(surface, edges, duplicates);
  std::vector<std::uint32_t> group;
  for (std::uint32_t g = 0; g < duplicates.groups(); ++g)
  {
    const auto first = duplicates.triangles.begin();
    group.assign(first + static_cast<std::ptrdiff_t>(duplicates.start[g]),
      first + static_cast<std::ptrdiff_t>(duplicates.start[g + 1]));
    const std::ptrdiff_t kept = sortKeptFirst(surface, group.data(), group.data() + group.size(),
      connected.keeps(g), connected.consistent(g));
    for (auto t = group.begin() + kept; t != group.end(); ++t)
    {
      dropped.push_back({ *t, surface.triangles[*t] });
      surface.triangles[*t].fill(surface.triangles[*t][0]);
    }
  }
  return dropped;
}

}

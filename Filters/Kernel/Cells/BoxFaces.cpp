// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/BoxFaces.h"

#include <numeric>

namespace cartesian
{

// Calls visit(lower node, upper node, whether it runs up, seen from outside).
template <class Visitor>
void BoxFaces::forEachEdge(std::size_t face, Visitor&& visit) const
{
  const CornerRange& corners = corners_[face];
  std::uint32_t from = corners.last[-1];
  for (const std::uint32_t* to = corners.first; to != corners.last; ++to)
  {
    visit(std::min(from, *to), std::max(from, *to), (from < *to) != corners.turned);
    from = *to;
  }
}

bool BoxFaces::list(std::size_t n, std::int32_t region)
{
  faces_.clear();
  corners_.clear();
  if (const std::uint32_t box = sides_.patchBox[n]; box != None)
  {
    for (std::size_t p = patches_.boxStart[box]; p < patches_.boxStart[box + 1]; ++p)
    {
      if (patches_.walls.behind(patches_.boundary[p]) == region)
      {
        add({ p, false });
      }
      else if (patches_.walls.front(patches_.boundary[p]) == region)
      {
        add({ p, true });
      }
    }
  }
  bool whole = true;
  for (std::size_t i = sides_.boxStart[n]; i < sides_.boxStart[n + 1]; ++i)
  {
    const auto [side, upper] = sides_.ofBox[i];
    whole = whole && !inner_.flawed[side];
    for (std::size_t f = inner_.sideStart[side]; f < inner_.sideStart[side + 1u]; ++f)
    {
      if (inner_.regionOf(f) == region)
      {
        add({ patches_.size() + f, !upper });
      }
    }
  }
  return whole;
}

void BoxFaces::add(const FaceUse& face)
{
  const bool patch = face.face < patches_.size();
  const std::size_t* const at =
    patch ? patches_.start.data() + face.face : inner_.start.data() + (face.face - patches_.size());
  const std::uint32_t* const nodes = (patch ? patches_.corners : inner_.nodes).data();
  corners_.push_back({ nodes + at[0], nodes + at[1], face.turned != 0 });
  faces_.push_back(face);
}

// Volumes that only touch at an edge stay apart where each closes by itself.
bool BoxFaces::connect()
{
  shared_.clear();
  if (joinInPairs())
  {
    return true;
  }
  listEdges();
  sets_.reset(faces_.size());
  for (std::size_t i = 0; i < edges_.size();)
  {
    std::size_t end = i;
    int sum = 0;
    for (; end < edges_.size() && edges_[end].sameEdge(edges_[i]); ++end)
    {
      sum += edges_[end].direction;
    }
    if (sum != 0)
    {
      return false;
    }
    if (end - i == 2)
    {
      sets_.unite(edges_[i].face, edges_[i + 1].face);
    }
    else
    {
      shared_.emplace_back(i, end);
    }
    i = end;
  }
  joinFlatCells();
  joinAtSharedEdges();
  return true;
}

// Connects the faces where each edge has two of them, one each way, as in nearly all boxes. Returns
// false elsewhere.
bool BoxFaces::joinInPairs()
{
  sets_.reset(faces_.size());
  firstAtEdge_.reset(std::accumulate(corners_.begin(), corners_.end(), std::size_t(0),
    [](std::size_t sum, const CornerRange& corners) { return sum + corners.size(); }));
  std::size_t single = 0;
  bool paired = true;
  for (std::uint32_t f = 0; f < faces_.size() && paired; ++f)
  {
    forEachEdge(f, [&](std::uint32_t lower, std::uint32_t upper, bool up) {
      std::uint32_t& first = firstAtEdge_.at(lower, upper);
      if (first == EdgeTable::Fresh)
      {
        first = 2 * f + (up ? 1 : 0);
        ++single;
      }
      else if (first == Paired || (first % 2 == 1) == up)
      {
        paired = false;
      }
      else
      {
        sets_.unite(f, first / 2);
        first = Paired;
        --single;
      }
    });
  }
  return paired && single == 0;
}

void BoxFaces::listEdges()
{
  edges_.clear();
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
  {
    forEachEdge(f, [&](std::uint32_t lower, std::uint32_t upper, bool up) {
      edges_.push_back({ lower, upper, f, up ? 1 : -1 });
    });
  }
  std::sort(edges_.begin(), edges_.end());
}

// A patch that lies on an inner face forms a cell without volume with it, whatever
// other faces share its edges.
void BoxFaces::joinFlatCells()
{
  if (shared_.empty())
  {
    return;
  }
  cycles_.clear();
  for (std::uint32_t face = 0; face < faces_.size(); ++face)
  {
    const bool patch = isPatch(face);
    cycles_.emplace_back(cycleOf(face, patch), face);
  }
  std::sort(cycles_.begin(), cycles_.end());
  for (std::size_t i = 0; i + 1 < cycles_.size(); ++i)
  {
    const std::uint32_t f = cycles_[i].second;
    const std::uint32_t g = cycles_[i + 1].second;
    const bool patch = isPatch(f);
    const bool other = isPatch(g);
    if (cycles_[i].first == cycles_[i + 1].first && patch != other)
    {
      sets_.unite(f, g);
    }
  }
}

// At an edge with more than two faces, those of a volume that does not close without the others are
// joined to them. Repeats, as joining at one edge may close another.
void BoxFaces::joinAtSharedEdges()
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const auto& [begin, end] : shared_)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        int sum = 0;
        for (std::size_t j = begin; j < end; ++j)
        {
          sum += root(edges_[j].face) == root(edges_[i].face) ? edges_[j].direction : 0;
        }
        if (sum != 0)
        {
          for (std::size_t j = begin; j < end; ++j)
          {
            sets_.unite(edges_[i].face, edges_[j].face);
          }
          changed = true;
          break;
        }
      }
    }
  }
}

BoxFaces::Cycle BoxFaces::cycleOf(std::uint32_t face, bool opposite) const
{
  Cycle cycle(corners_[face].first, corners_[face].last);
  if (opposite != corners_[face].turned)
  {
    std::reverse(cycle.begin(), cycle.end());
  }
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  return cycle;
}

void BoxFaces::listPatchCycles(const std::vector<std::uint32_t>& faces, Cycles& cycles) const
{
  cycles.clear();
  for (const std::uint32_t face : faces)
  {
    if (isPatch(face))
    {
      cycles.emplace_back(cycleOf(face, false), face);
    }
  }
  std::sort(cycles.begin(), cycles.end());
}

bool BoxFaces::anyPatchTwice()
{
  if (shared_.empty())
  {
    return false;
  }
  std::vector<std::uint32_t> all(faces_.size());
  std::iota(all.begin(), all.end(), 0);
  listPatchCycles(all, cycles_);
  const auto count = [&](const Cycle& cycle) {
    const auto begin =
      std::lower_bound(cycles_.begin(), cycles_.end(), std::make_pair(cycle, std::uint32_t(0)));
    const auto end = std::upper_bound(begin, cycles_.end(), std::make_pair(cycle, None));
    return end - begin;
  };
  return std::any_of(cycles_.begin(), cycles_.end(),
    [&](const auto& patch) { return count(patch.first) > count(cycleOf(patch.second, true)) + 1; });
}

}

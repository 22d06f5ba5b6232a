// SPDX-License-Identifier: BSD-3-Clause
#include "Collapse/MergingNodes.h"

namespace cartesian
{

namespace
{

constexpr std::size_t FacesAChunk = 4096;

}

void MergingNodes::find(const std::vector<ShortEdge>& edges, Execution& execution)
{
  slotOf_.assign(nodes_.at.size(), None);
  for (const ShortEdge& edge : edges)
  {
    slotOf_[edge.a] = slotOf_[edge.b] = 0;
  }
  for (std::uint32_t node = 0; node < slotOf_.size(); ++node)
  {
    if (slotOf_[node] != None)
    {
      const auto slot = static_cast<std::uint32_t>(slots_.size());
      slotOf_[node] = slot;
      slots_.push_back({ node, slot, slot, nodes_.at[node] });
    }
  }
  listFaces(execution);
}

void MergingNodes::listFaces(Execution& execution)
{
  const std::size_t faceCount = patches_.size() + inner_.size();
  std::vector<std::vector<FaceOfSlot>> uses(chunks(faceCount, FacesAChunk));
  execution.forEach(faceCount, FacesAChunk, [&](std::size_t begin, std::size_t end) {
    for (auto face = static_cast<std::uint32_t>(begin); face < end; ++face)
    {
      const auto [first, last] = cornersOf(face);
      for (const std::uint32_t* node = first; node != last; ++node)
      {
        if (slotOf_[*node] != None)
        {
          uses[begin / FacesAChunk].push_back({ slotOf_[*node], face });
        }
      }
    }
  });
  facesOf_ = sortIntoBuckets(
    uses, slots_.size(), [](const FaceOfSlot& use) { return use.slot; }, execution);
}

void MergingNodes::ringOf(
  const std::uint32_t* begin, const std::uint32_t* end, std::vector<std::uint32_t>& ring) const
{
  ring.clear();
  for (const std::uint32_t* corner = begin; corner != end; ++corner)
  {
    const std::uint32_t slot = slotOf_[*corner];
    const std::uint32_t now = slot == None ? *corner : slots_[standing(slot)].node;
    if (ring.empty() || ring.back() != now)
    {
      ring.push_back(now);
    }
  }
  while (ring.size() > 1 && ring.front() == ring.back())
  {
    ring.pop_back();
  }
}

Vector MergingNodes::areaOf(const std::vector<std::uint32_t>& ring) const
{
  Vector twice{ 0, 0, 0 };
  const Point& base = placeOf(ring[0]);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
  {
    twice = plus(twice, cross(minus(placeOf(ring[i]), base), minus(placeOf(ring[i + 1]), base)));
  }
  return twice;
}

Vector MergingNodes::originalArea(std::uint32_t face) const
{
  Vector twice{ 0, 0, 0 };
  const auto [begin, end] = cornersOf(face);
  const Point& base = nodes_.at[*begin];
  for (const std::uint32_t* corner = begin + 1; corner + 1 < end; ++corner)
  {
    twice =
      plus(twice, cross(minus(nodes_.at[corner[0]], base), minus(nodes_.at[corner[1]], base)));
  }
  return twice;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Faces/SideChords.h"

namespace cartesian
{

namespace
{

// Appends a node if it lies on the border. A corner belongs to the piece of the border that begins there.
void addToBorder(const PlanePoint& p, const Rectangle& r, std::uint32_t node, int change,
  std::vector<BorderNode>& border)
{
  if (p.b == r.low.b && p.a < r.high.a)
  {
    border.push_back({ 0, p.a, node, change, p.a == r.low.a ? r.corner[0] : KnownStatus::Unknown });
  }
  else if (p.a == r.high.a && p.b < r.high.b)
  {
    border.push_back({ 1, p.b, node, change, p.b == r.low.b ? r.corner[1] : KnownStatus::Unknown });
  }
  else if (p.b == r.high.b && p.a > r.low.a)
  {
    border.push_back(
      { 2, -p.a, node, change, p.a == r.high.a ? r.corner[2] : KnownStatus::Unknown });
  }
  else if (p.a == r.low.a)
  {
    border.push_back(
      { 3, -p.b, node, change, p.b == r.high.b ? r.corner[3] : KnownStatus::Unknown });
  }
}

bool lies(const Point& p, Level plane, const Rectangle& r)
{
  const PlanePoint at = flatten(p, r.axis);
  return p[static_cast<std::size_t>(r.axis)] == plane && at.a >= r.low.a && at.a <= r.high.a &&
    at.b >= r.low.b && at.b <= r.high.b;
}

}

void listBorder(const std::vector<Point>& nodes, const Rectangle& r,
  const std::vector<SideEdge>& chords, std::vector<BorderNode>& border)
{
  border.clear();
  const auto add = [&](std::uint32_t node, int change) {
    addToBorder(flatten(nodes[node], r.axis), r, node, change, border);
  };
  for (std::size_t i = 0; i < r.borderSize; ++i)
  {
    add(r.border[i], 0);
  }
  for (const SideEdge& chord : chords)
  {
    add(chord.from, -1);
    add(chord.to, +1);
  }
  std::sort(border.begin(), border.end(), [](const BorderNode& x, const BorderNode& y) {
    return x.border != y.border ? x.border < y.border : x.along < y.along;
  });
}

void dropOpposite(std::vector<SideEdge>& edges, std::vector<std::uint8_t>& scratch)
{
  std::sort(edges.begin(), edges.end());
  scratch.assign(edges.size(), 0);
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const SideEdge opposite{ edges[i].to, edges[i].from };
    if (scratch[i] || opposite < edges[i])
    {
      continue;
    }
    auto j = static_cast<std::size_t>(
      std::lower_bound(edges.begin(), edges.end(), opposite) - edges.begin());
    for (; j < edges.size() && !(opposite < edges[j]); ++j)
    {
      if (!scratch[j])
      {
        scratch[i] = scratch[j] = 1;
        break;
      }
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (!scratch[i])
    {
      edges[kept++] = edges[i];
    }
  }
  edges.resize(kept);
}

Rectangle SideChords::rectangle(std::size_t s, std::int32_t region) const
{
  const Side& side = sides_.common[s];
  Rectangle r;
  r.axis = side.axis;
  r.border = nodes_.border.data() + nodes_.borderStart[s];
  r.borderSize = nodes_.borderStart[s + 1] - nodes_.borderStart[s];
  r.low = flatten(nodes_.at[r.border[0]], side.axis);
  r.high = r.low;
  for (std::size_t i = 0; i < r.borderSize; ++i)
  {
    const PlanePoint p = flatten(nodes_.at[r.border[i]], side.axis);
    r.high = { std::max(r.high.a, p.a), std::max(r.high.b, p.b) };
  }
  r.corner.fill(KnownStatus::Unknown);
  const std::array<PlanePoint, 4> at = { r.low, PlanePoint{ r.high.a, r.low.b }, r.high,
    PlanePoint{ r.low.a, r.high.b } };
  for (const bool upper : { true, false })
  {
    const std::uint32_t b = upper ? side.low : side.high;
    if (b == None)
    {
      continue;
    }
    const PackedBox& box = boxes_.packed[b];
    const std::array<unsigned, 4> corners = sideCorners(side.axis, upper ? 1 : 0);
    const auto isAt = [&](unsigned corner, const PlanePoint& place) {
      const PlanePoint p = flatten(cornerOf(boxes_.placed(box), corner), side.axis);
      return p.a == place.a && p.b == place.b;
    };
    for (std::size_t i = 0; i < 4; ++i)
    {
      if (boxes_.globalOf(box).nearDepth == 0 || isAt(corners[i], at[i]))
      {
        r.corner[i] =
          boxes_.regionAt(b, corners[i]) == region ? KnownStatus::Inside : KnownStatus::Outside;
      }
    }
  }
  return r;
}

std::uint32_t SideChords::patchBoxOf(const Side& side, bool& isLow) const
{
  const std::uint32_t low = sides_.polyhedralOrdinal(side.low);
  isLow = low != None && sides_.patchBox[low] != None;
  const std::uint32_t n = isLow ? low : sides_.polyhedralOrdinal(side.high);
  return n == None ? None : sides_.patchBox[n];
}

// Faces of the side run along these edges in the opposite direction to the patch. For the upper box, or where the
// region is in front of the patch, the face is reversed.
void SideChords::find(
  std::size_t s, const Rectangle& r, std::vector<SideEdge>& chords, std::int32_t region) const
{
  const Side& side = sides_.common[s];
  chords.clear();
  bool fromLow = false;
  const std::uint32_t box = patchBoxOf(side, fromLow);
  if (box == None)
  {
    return;
  }
  const Level plane = planeAt(boxes_.planes, side.axis, side.corner[side.axis]);
  for (std::size_t p = patches_.boxStart[box]; p < patches_.boxStart[box + 1]; ++p)
  {
    const bool isBehind = patches_.walls.behind(patches_.boundary[p]) == region;
    if (!isBehind && patches_.walls.front(patches_.boundary[p]) != region)
    {
      continue;
    }
    std::uint32_t from = patches_.corners[patches_.start[p + 1] - 1];
    for (std::size_t c = patches_.start[p]; c < patches_.start[p + 1]; ++c)
    {
      const std::uint32_t to = patches_.corners[c];
      if (lies(patches_.points[from], plane, r) && lies(patches_.points[to], plane, r))
      {
        chords.push_back(fromLow == isBehind ? SideEdge{ to, from } : SideEdge{ from, to });
      }
      from = to;
    }
  }
}

void SideChords::listRegions(std::size_t s, std::vector<std::int32_t>& regions) const
{
  regions.assign(1, FirstRegion);
  if (!patches_.walls.any())
  {
    return;
  }
  regions.clear();
  const Side& side = sides_.common[s];
  for (const std::uint32_t b : { side.low, side.high })
  {
    for (unsigned corner = 0; b != None && corner < 8; ++corner)
    {
      regions.push_back(boxes_.regionAt(b, corner));
    }
  }
  bool isLow = false;
  const std::uint32_t box = patchBoxOf(side, isLow);
  for (std::size_t p = box == None ? 0 : patches_.boxStart[box];
       box != None && p < patches_.boxStart[box + 1]; ++p)
  {
    regions.push_back(patches_.walls.behind(patches_.boundary[p]));
    regions.push_back(patches_.walls.front(patches_.boundary[p]));
  }
  std::sort(regions.begin(), regions.end());
  regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
  regions.erase(std::remove(regions.begin(), regions.end(), OutsideRegion), regions.end());
}

}

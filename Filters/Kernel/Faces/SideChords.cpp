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

Rectangle SideChords::rectangle(std::size_t s) const
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
          (box.corners >> corners[i] & 1) != 0 ? KnownStatus::Inside : KnownStatus::Outside;
      }
    }
  }
  return r;
}

// Faces of the side run along these edges in the opposite direction to the patch. For the upper box, the
// face is turned over.
void SideChords::find(std::size_t s, const Rectangle& r, std::vector<SideEdge>& chords) const
{
  const Side& side = sides_.common[s];
  chords.clear();
  const std::uint32_t low = sides_.polyhedralOrdinal(side.low);
  const bool fromLow = low != None && sides_.patchBox[low] != None;
  const std::uint32_t n = fromLow ? low : sides_.polyhedralOrdinal(side.high);
  if (n == None || sides_.patchBox[n] == None)
  {
    return;
  }
  const Level plane = planeAt(boxes_.planes[side.axis], side.corner[side.axis]);
  const std::uint32_t box = sides_.patchBox[n];
  for (std::size_t p = patches_.boxStart[box]; p < patches_.boxStart[box + 1]; ++p)
  {
    std::uint32_t from = patches_.corners[patches_.start[p + 1] - 1];
    for (std::size_t c = patches_.start[p]; c < patches_.start[p + 1]; ++c)
    {
      const std::uint32_t to = patches_.corners[c];
      if (lies(patches_.points[from], plane, r) && lies(patches_.points[to], plane, r))
      {
        chords.push_back(fromLow ? SideEdge{ to, from } : SideEdge{ from, to });
      }
      from = to;
    }
  }
}

}

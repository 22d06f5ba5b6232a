// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/JoinedSides.h"

#include "Repair/RadialEdgeSort.h"
#include "Repair/TrianglePlane.h"
#include "Surface/Places.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace cartesian
{

namespace
{

using Triple = std::array<std::uint32_t, 3>;

Triple sorted(Triple v)
{
  std::sort(v.begin(), v.end());
  return v;
}

// Of a side of a piece, by its number.
constexpr std::uint32_t sideOf(std::uint32_t piece, bool front)
{
  return 2 * piece + (front ? 1 : 0);
}

// The sides that a line comes from and goes to where it crosses a piece.
std::uint32_t below(const RayCrossing& crossing)
{
  return sideOf(crossing.triangle, !crossing.up);
}
std::uint32_t above(const RayCrossing& crossing)
{
  return sideOf(crossing.triangle, crossing.up);
}

// One triangle of each piece, in order.
Surface flatOf(const Surface& surface, const std::vector<Piece>& pieces)
{
  Surface flat;
  flat.lattice = surface.lattice;
  flat.vertices = surface.vertices;
  flat.triangles.reserve(pieces.size());
  for (const Piece& piece : pieces)
  {
    flat.triangles.push_back(piece.vertices);
  }
  return flat;
}

}

bool faceAlike(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b)
{
  const auto at = std::find(a.begin(), a.end(), b[0]) - a.begin();
  return a[static_cast<std::size_t>(at + 1) % 3] == b[1];
}

std::vector<Piece> piecesOf(const Surface& surface)
{
  struct Entry
  {
    Triple corners; // sorted
    std::int32_t region;
    std::uint32_t triangle;

    bool operator<(const Entry& other) const
    {
      return std::tie(corners, region, triangle) <
        std::tie(other.corners, other.region, other.triangle);
    }
  };
  std::vector<Entry> entries(surface.triangles.size());
  for (std::uint32_t t = 0; t < entries.size(); ++t)
  {
    entries[t] = { sorted(surface.triangles[t]), surface.region[t], t };
  }
  std::sort(entries.begin(), entries.end());
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (i == 0 || entries[i - 1].corners != entries[i].corners)
    {
      pieces.push_back({ surface.triangles[entries[i].triangle], {} });
    }
    pieces.back().triangles.push_back(entries[i].triangle);
  }
  return pieces;
}

JoinedSides::JoinedSides(
  const Surface& surface, const std::vector<Piece>& pieces, Execution& execution)
  : flat_(flatOf(surface, pieces))
  , sides_(2 * pieces.size() + 1)
  , tree_(flat_, execution)
  , far_(static_cast<std::uint32_t>(2 * pieces.size()))
{
  DisjointSets parts(pieces.size()); // that share edges
  RadialEdgeSort fan(flat_.vertices);
  SurfaceEdges(flat_, execution)
    .forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      fan.start(lower, begin->upper);
      for (const EdgeUse* use = begin; use != end; ++use)
      {
        fan.add(use->triangle(), flat_.triangles[use->triangle()], use->down());
        parts.unite(begin->triangle(), use->triangle());
      }
      fan.forEachSpace([&](const RadialEdgeSort::IncidentTriangle& one,
                         const RadialEdgeSort::IncidentTriangle& next) {
        sides_.unite(sideOf(one.triangle, !one.down), sideOf(next.triangle, next.down));
      });
    });
  placeParts(parts);
}

std::uint32_t JoinedSides::beside(std::uint32_t piece, bool front)
{
  return sides_.find(sideOf(piece, front));
}

std::uint32_t JoinedSides::at(const Point& place)
{
  std::vector<RayCrossing> crossings;
  std::size_t along = 0;
  while (!cross(along, place, crossings) && along < 2)
  {
    ++along;
  }
  std::uint32_t side = far_;
  for (const RayCrossing& crossing : crossings)
  {
    side = crossing.level < place[along] ? above(crossing) : side;
  }
  return sides_.find(side);
}

// Each part by a line through one of its largest pieces.
void JoinedSides::placeParts(DisjointSets& parts)
{
  std::vector<double> area(flat_.triangles.size());
  for (std::size_t p = 0; p < area.size(); ++p)
  {
    area[p] = areaOf(flat_, p);
  }
  std::vector<std::uint32_t> order(area.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
  std::vector<std::uint8_t> isPlaced(area.size());
  for (const std::uint32_t piece : order)
  {
    std::uint8_t& is = isPlaced[parts.find(piece)];
    is = is != 0 || joinAlongLine(piece) ? 1 : 0;
  }
}

// Joins what is next to each other along a line through a piece; false where that misses it, or is not sure.
bool JoinedSides::joinAlongLine(std::uint32_t piece)
{
  Point place;
  const Vector middle = middleOf(flat_, piece);
  std::transform(middle.begin(), middle.end(), place.begin(),
    [](double level) { return static_cast<Level>(level / 2) * 2; });
  std::vector<RayCrossing> crossings;
  if (!cross(axisOfNormal(flat_.corners(piece)), place, crossings) ||
    std::none_of(crossings.begin(), crossings.end(),
      [&](const RayCrossing& crossing) { return crossing.triangle == piece; }))
  {
    return false;
  }
  std::uint32_t before = far_;
  for (const RayCrossing& crossing : crossings)
  {
    sides_.unite(before, below(crossing));
    before = above(crossing);
  }
  sides_.unite(before, far_);
  return true;
}

// All crossings of the line through a place; false where it is not sure which of two comes first.
bool JoinedSides::cross(
  std::size_t along, const Point& place, std::vector<RayCrossing>& crossings) const
{
  crossings = crossingsOf(flat_, tree_, along, place);
  return std::adjacent_find(crossings.begin(), crossings.end(),
           [](const RayCrossing& a, const RayCrossing& b) { return a.level == b.level; }) ==
    crossings.end();
}

}

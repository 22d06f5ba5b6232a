// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/UnitStatuses.h"

#include "Surface/LineCrossings.h"

namespace cartesian
{

namespace
{

template <class Visitor>
void forEachTriangle(const TriangleRange& triangles, Visitor&& visit)
{
  for (const std::uint32_t* t = triangles.first; t != triangles.second; ++t)
  {
    visit(*t);
  }
}

}

std::size_t UnitStatuses::vertex(std::size_t x, std::size_t y, std::size_t z) const
{
  const std::size_t n = (std::size_t(1) << depth_) + 1;
  return x + n * (y + n * z);
}

void UnitStatuses::compute(const Surface& surface, const TriangleRange& triangles,
  const Meshlines& planes, const std::array<std::uint32_t, 3>& index, int depth, const Winding& low)
{
  depth_ = depth;
  for (int axis = 0; axis < 3; ++axis)
  {
    planes_[axis].clear();
    for (std::int64_t part = 0; part <= 1 << depth; ++part)
    {
      planes_[axis].push_back(
        planeAt(planes, axis, index[axis] * FinePerBox + part * (FinePerBox >> depth)));
    }
    inner_[axis].assign(planes_[axis].begin() + 1, planes_[axis].end() - 1);
  }
  findVertices(surface, triangles, low);
  findUnits(surface, triangles);
}

// Paths run from the low corner along y, then z, then x. At first, vertices_ holds the crossings
// between each vertex and the one before it on the path.
void UnitStatuses::findVertices(
  const Surface& surface, const TriangleRange& triangles, const Winding& low)
{
  const std::size_t n = planes_[0].size();
  vertices_.assign(n * n * n, {});
  const std::vector<Level> firstX{ planes_[0].front() };
  const std::vector<Level> firstZ{ planes_[2].front() };
  const auto add = [&](int axis, const Point& p, const Winding& crossing,
                     std::array<std::size_t, 3> at) {
    if (p[axis] > planes_[axis].front() && p[axis] < planes_[axis].back())
    {
      at[axis] = static_cast<std::size_t>(intervalOf(planes_[axis], p[axis]) + 1);
      vertices_[vertex(at[0], at[1], at[2])].add(crossing);
    }
  };
  forEachTriangle(triangles, [&](std::uint32_t t) {
    const Corners corners = surface.corners(t);
    forEachLineCrossing(corners, RowsAlong[1], firstX, firstZ,
      [&](std::size_t, std::size_t, const Point& p, bool up) {
        add(1, p, surface.crossing(t, up), { 0, 0, 0 });
      });
    forEachLineCrossing(corners, RowsAlong[2], firstX, planes_[1],
      [&](std::size_t, std::size_t y, const Point& p, bool up) {
        add(2, p, surface.crossing(t, up), { 0, y, 0 });
      });
    forEachLineCrossing(corners, RowsAlong[0], planes_[1], planes_[2],
      [&](std::size_t y, std::size_t z, const Point& p, bool up) {
        add(0, p, surface.crossing(t, up), { 0, y, z });
      });
  });
  vertices_[0] = low;
  for (std::size_t z = 0; z < n; ++z)
  {
    for (std::size_t y = 0; y < n; ++y)
    {
      for (std::size_t x = 0; x < n; ++x)
      {
        if (x + y + z > 0)
        {
          const std::size_t before =
            x > 0 ? vertex(x - 1, y, z) : (z > 0 ? vertex(0, y, z - 1) : vertex(0, y - 1, 0));
          vertices_[vertex(x, y, z)].add(vertices_[before]);
        }
      }
    }
  }
}

void UnitStatuses::findUnits(const Surface& surface, const TriangleRange& triangles)
{
  const std::size_t n = planes_[0].size() - 1;
  units_.assign(n * n * n, BoxStatus::Outside);
  for (std::size_t z = 0; z < n; ++z)
  {
    for (std::size_t y = 0; y < n; ++y)
    {
      for (std::size_t x = 0; x < n; ++x)
      {
        units_[x + n * (y + n * z)] =
          vertices_[vertex(x, y, z)].inside() ? BoxStatus::Inside : BoxStatus::Outside;
      }
    }
  }
  const Point low = { planes_[0].front(), planes_[1].front(), planes_[2].front() };
  const Point high = { planes_[0].back(), planes_[1].back(), planes_[2].back() };
  forEachTriangle(triangles, [&](std::uint32_t t) {
    const Corners corners = surface.corners(t);
    forEachSlice(corners, clip(corners, low, high), 2, inner_[2],
      [&](std::int64_t below, const Fragment& slice) {
        const auto z = static_cast<std::size_t>(below + 1);
        forEachSlice(corners, slice, 1, inner_[1], [&](std::int64_t under, const Fragment& piece) {
          const auto y = static_cast<std::size_t>(under + 1);
          const auto [least, most] = rangeOf(piece, 0);
          const auto last = static_cast<std::size_t>(intervalOf(inner_[0], most) + 1);
          for (auto x = static_cast<std::size_t>(intervalOf(inner_[0], least) + 1); x <= last; ++x)
          {
            units_[x + n * (y + n * z)] = BoxStatus::Intersected;
          }
        });
      });
  });
}

std::uint8_t UnitStatuses::corners(
  const std::array<std::uint16_t, 3>& fineOffset, const std::array<std::uint8_t, 3>& level) const
{
  unsigned bits = 0;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    std::array<std::size_t, 3> at;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const std::int64_t size = FinePerBox >> level[axis];
      const std::int64_t fine = fineOffset[axis] + (corner >> axis & 1) * size;
      at[axis] = static_cast<std::size_t>(fine >> (DeepestLevel - depth_));
    }
    bits |= static_cast<unsigned>(vertices_[vertex(at[0], at[1], at[2])].inside()) << corner;
  }
  return static_cast<std::uint8_t>(bits);
}

Winding windingAt(const Surface& surface, const TriangleRange& triangles, const Point& corner,
  const Winding& low, const Point& at)
{
  Winding winding = low;
  forEachTriangle(triangles, [&](std::uint32_t t) {
    const Corners corners = surface.corners(t);
    const auto addUpTo = [&](int axis) {
      return [&, axis](std::size_t, std::size_t, const Point& p, bool up) {
        if (p[axis] > corner[axis] && p[axis] < at[axis])
        {
          winding.add(surface.crossing(t, up));
        }
      };
    };
    forEachLineCrossing(corners, RowsAlong[1], { corner[0] }, { corner[2] }, addUpTo(1));
    forEachLineCrossing(corners, RowsAlong[2], { corner[0] }, { at[1] }, addUpTo(2));
    forEachLineCrossing(corners, RowsAlong[0], { at[1] }, { at[2] }, addUpTo(0));
  });
  return winding;
}

}

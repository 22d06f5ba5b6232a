#include "UnitStatuses.h"

#include "LineCrossings.h"

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
  const Meshlines& planes, const std::array<std::uint32_t, 3>& index, int depth, bool cornerInside)
{
  depth_ = depth;
  for (int axis = 0; axis < 3; ++axis)
  {
    planes_[axis].clear();
    for (std::int64_t part = 0; part <= 1 << depth; ++part)
    {
      planes_[axis].push_back(
        planeAt(planes[axis], index[axis] * FinePerBox + part * (FinePerBox >> depth)));
    }
    inner_[axis].assign(planes_[axis].begin() + 1, planes_[axis].end() - 1);
  }
  findVertices(surface, triangles, cornerInside);
  findUnits(surface, triangles);
}

// From the low corner along y, from there along z, from there along x: each crossing on the way
// changes the status. vertices_ first holds whether it changes on the way to each vertex.
void UnitStatuses::findVertices(
  const Surface& surface, const TriangleRange& triangles, bool cornerInside)
{
  const std::size_t n = planes_[0].size();
  vertices_.assign(n * n * n, 0);
  const std::vector<Level> firstX{ planes_[0].front() };
  const std::vector<Level> firstZ{ planes_[2].front() };
  const auto toggle = [&](int axis, const Point& p, std::array<std::size_t, 3> at) {
    if (p[axis] > planes_[axis].front() && p[axis] < planes_[axis].back())
    {
      at[axis] = static_cast<std::size_t>(intervalOf(planes_[axis], p[axis]) + 1);
      vertices_[vertex(at[0], at[1], at[2])] ^= 1;
    }
  };
  forEachTriangle(triangles, [&](std::uint32_t t) {
    const Corners corners = surface.corners(t);
    forEachLineCrossing(
      corners, RowsAlong[1], firstX, firstZ, [&](std::size_t, std::size_t, const Point& p) {
        toggle(1, p, { 0, 0, 0 });
      });
    forEachLineCrossing(
      corners, RowsAlong[2], firstX, planes_[1], [&](std::size_t, std::size_t y, const Point& p) {
        toggle(2, p, { 0, y, 0 });
      });
    forEachLineCrossing(corners, RowsAlong[0], planes_[1], planes_[2],
      [&](std::size_t y, std::size_t z, const Point& p) {
        toggle(0, p, { 0, y, z });
      });
  });
  vertices_[0] = cornerInside ? 1 : 0;
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
          vertices_[vertex(x, y, z)] ^= vertices_[before];
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
          vertices_[vertex(x, y, z)] ? BoxStatus::Inside : BoxStatus::Outside;
      }
    }
  }
  const Point low = { planes_[0].front(), planes_[1].front(), planes_[2].front() };
  const Point high = { planes_[0].back(), planes_[1].back(), planes_[2].back() };
  forEachTriangle(triangles, [&](std::uint32_t t) {
    const Corners corners = surface.corners(t);
    forEachSlab(corners, clip(corners, low, high), 2, inner_[2],
      [&](std::int64_t below, const Fragment& slab) {
        const auto z = static_cast<std::size_t>(below + 1);
        forEachSlab(corners, slab, 1, inner_[1], [&](std::int64_t under, const Fragment& piece) {
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
  const std::array<std::uint8_t, 3>& fineOffset, const std::array<std::uint8_t, 3>& level) const
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
    bits |= static_cast<unsigned>(vertices_[vertex(at[0], at[1], at[2])]) << corner;
  }
  return static_cast<std::uint8_t>(bits);
}

bool insideAt(const Surface& surface, const TriangleRange& triangles, const Point& corner,
  bool cornerInside, const Point& at)
{
  bool inside = cornerInside;
  forEachTriangle(triangles, [&](std::uint32_t t) {
    const Corners corners = surface.corners(t);
    const auto countUpTo = [&](int axis) {
      return [&, axis](std::size_t, std::size_t, const Point& p) {
        inside ^= p[axis] > corner[axis] && p[axis] < at[axis];
      };
    };
    forEachLineCrossing(corners, RowsAlong[1], { corner[0] }, { corner[2] }, countUpTo(1));
    forEachLineCrossing(corners, RowsAlong[2], { corner[0] }, { at[1] }, countUpTo(2));
    forEachLineCrossing(corners, RowsAlong[0], { at[1] }, { at[2] }, countUpTo(0));
  });
  return inside;
}

}

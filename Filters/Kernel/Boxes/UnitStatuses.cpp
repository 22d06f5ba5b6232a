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
  const std::size_t n = (std::size_t(1) << bits_) + 1;
  return x + n * (y + n * z);
}

void UnitStatuses::compute(const Surface& surface, const TriangleRange& triangles,
  const Meshlines& planes, const std::array<std::uint32_t, 3>& index, const Cube& cube, int bits,
  const Winding& low)
{
  cube_ = cube;
  bits_ = bits;
  planes_.set(planes, index, cube, bits);
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
  units_.resize(std::size_t(1) << 3 * bits_);
  for (std::size_t unit = 0; unit < units_.size(); ++unit)
  {
    units_[unit] = lowOf(unit).inside() ? BoxStatus::Inside : BoxStatus::Outside;
  }
  passing_.clear();
  forEachTriangle(triangles, [&](std::uint32_t t) {
    planes_.forEachUnit(surface.corners(t), [&](std::size_t unit) {
      units_[unit] = BoxStatus::Intersected;
      passing_.emplace_back(static_cast<std::uint32_t>(unit), t);
    });
  });
}

const Winding& UnitStatuses::lowOf(std::size_t unit) const
{
  const std::size_t mask = (std::size_t(1) << bits_) - 1;
  return vertices_[vertex(unit & mask, unit >> bits_ & mask, unit >> 2 * bits_)];
}

void UnitStatuses::sortPassing()
{
  // Ascending by triangle already, as one of them may be met twice in a unit.
  std::stable_sort(passing_.begin(), passing_.end(),
    [](const auto& a, const auto& b) { return a.first < b.first; });
}

std::vector<std::uint32_t> UnitStatuses::trianglesIn(std::size_t unit) const
{
  const auto less = [](const auto& a, const auto& b) { return a.first < b.first; };
  const auto [begin, end] = std::equal_range(passing_.begin(), passing_.end(),
    std::pair<std::uint32_t, std::uint32_t>(static_cast<std::uint32_t>(unit), 0), less);
  std::vector<std::uint32_t> triangles;
  triangles.reserve(static_cast<std::size_t>(end - begin));
  for (auto passing = begin; passing != end; ++passing)
  {
    if (triangles.empty() || triangles.back() != passing->second)
    {
      triangles.push_back(passing->second);
    }
  }
  return triangles;
}

std::uint8_t UnitStatuses::corners(const LocalBox& box) const
{
  unsigned bits = 0;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    std::array<std::size_t, 3> at;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const std::int64_t size = FinePerBox >> box.level[axis];
      const std::int64_t fine = box.offset[axis] - cube_.offset[axis] + (corner >> axis & 1) * size;
      at[axis] = static_cast<std::size_t>(fine >> (DeepestLevel - cube_.level - bits_));
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

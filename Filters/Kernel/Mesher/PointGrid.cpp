// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/PointGrid.h"

#include "Surface/LineCrossings.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

PointGrid::PointGrid(const Point& low, const Point& high, double spacing)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double extent = double(high[axis]) - low[axis];
    const auto intervals =
      std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(extent / spacing)));
    for (std::size_t i = 0; i <= intervals; ++i)
    {
      const double part = double(i) / double(intervals);
      lines_[axis].push_back(oddLevel(low[axis] + part * extent) - 1);
    }
  }
  isBlocked_.resize(size());
}

void PointGrid::block(const Surface& walls, Execution& execution)
{
  for (std::size_t t = 0; t < walls.triangles.size(); ++t)
  {
    execution.poll();
    for (const RowAxes& axes : RowsAlong)
    {
      block(walls.corners(t), axes);
    }
  }
}

std::array<std::size_t, 8> PointGrid::pointsAround(const Vector& place) const
{
  Index i;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto& lines = lines_[axis];
    const auto above = std::upper_bound(lines.begin() + 1, lines.end() - 1, place[axis],
      [](double at, Level line) { return at < line; });
    i[axis] = static_cast<std::size_t>(above - lines.begin()) - 1;
  }
  std::array<std::size_t, 8> points;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    points[corner] =
      pointAt({ i[0] + (corner & 1), i[1] + (corner >> 1 & 1), i[2] + (corner >> 2) });
  }
  return points;
}

std::vector<std::size_t> PointGrid::wayTo(std::size_t from, std::size_t to) const
{
  const Index i = indexOf(from);
  const Index j = indexOf(to);
  Step step;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    step[axis] = static_cast<int>(j[axis]) - static_cast<int>(i[axis]);
  }
  std::array<std::size_t, 3> way{};
  const std::size_t size = findWay(i, step, way);
  return { way.begin(), way.begin() + static_cast<std::ptrdiff_t>(size) };
}

void PointGrid::block(const Corners& triangle, const RowAxes& axes)
{
  const auto along = static_cast<std::size_t>(axes.along);
  const auto& lines = lines_[along];
  forEachLineCrossing(triangle, axes, lines_[static_cast<std::size_t>(axes.middle)],
    lines_[static_cast<std::size_t>(axes.outer)],
    [&](std::size_t middle, std::size_t outer, const Point& p, bool) {
      const auto above = std::lower_bound(lines.begin(), lines.end(), p[along]);
      if (above == lines.begin() || above == lines.end())
      {
        return;
      }
      Index i{};
      i[along] = static_cast<std::size_t>(above - lines.begin()) - 1;
      i[static_cast<std::size_t>(axes.middle)] = middle;
      i[static_cast<std::size_t>(axes.outer)] = outer;
      isBlocked_[pointAt(i)] |= static_cast<std::uint8_t>(1U << along);
    });
}

std::size_t PointGrid::findWay(
  const Index& i, const Step& step, std::array<std::size_t, 3>& way) const
{
  constexpr std::array<std::array<std::size_t, 3>, 6> Orders{ { { 0, 1, 2 }, { 0, 2, 1 },
    { 1, 0, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 2, 1, 0 } } };
  for (const std::array<std::size_t, 3>& order : Orders)
  {
    Index at = i;
    std::size_t size = 0;
    bool isWay = true;
    for (const std::size_t axis : order)
    {
      if (step[axis] != 0)
      {
        const std::size_t before = pointAt(at);
        at[axis] += static_cast<std::size_t>(step[axis]);
        const std::size_t next = pointAt(at);
        isWay = isWay && isFree(step[axis] > 0 ? before : next, axis);
        way[size++] = next;
      }
    }
    if (isWay)
    {
      return size;
    }
  }
  return 0;
}

}

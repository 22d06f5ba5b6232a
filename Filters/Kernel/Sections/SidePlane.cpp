// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/SidePlane.h"

#include "Sections/PeriodicFaces.h"

#include <algorithm>

namespace cartesian
{

namespace
{

Vector pointOf(const std::vector<double>& points, std::size_t p)
{
  return { points[3 * p], points[3 * p + 1], points[3 * p + 2] };
}

}

Vector doubledArea(const CellFaces& cells, std::size_t face, const std::vector<double>& points)
{
  const std::size_t begin = cells.firstCorner[face];
  const std::size_t end = cells.firstCorner[face + 1];
  const Vector origin = pointOf(points, cells.corners[begin]);
  Vector sum{};
  for (std::size_t i = begin + 1; i + 1 < end; ++i)
  {
    sum = plus(sum,
      cross(minus(pointOf(points, cells.corners[i]), origin),
        minus(pointOf(points, cells.corners[i + 1]), origin)));
  }
  return sum;
}

SidePlane::SidePlane(
  const CellFaces& cells, const std::vector<std::size_t>& faces, const std::vector<double>& points)
{
  Vector area{};
  Vector low = pointOf(points, cells.corners[cells.firstCorner[faces.front()]]);
  Vector high = low;
  origin_ = low;
  const auto forEachPoint = [&](auto&& visit) {
    for (const std::size_t face : faces)
    {
      for (std::size_t i = cells.firstCorner[face]; i < cells.firstCorner[face + 1]; ++i)
      {
        visit(pointOf(points, cells.corners[i]));
      }
    }
  };
  for (const std::size_t face : faces)
  {
    area = plus(area, doubledArea(cells, face, points));
  }
  forEachPoint([&](const Vector& p) {
    for (std::size_t k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  });
  size_ = norm(minus(high, low));
  choose(area);
  forEachPoint([&](const Vector& p) {
    if (!beside_ && std::abs(dot(normal_, minus(p, origin_))) > PeriodicSpec::Flatness * size_)
    {
      beside_ = p;
    }
  });
}

void SidePlane::choose(const Vector& area)
{
  normal_ = unit(area);
  std::size_t most = 0;
  for (std::size_t k = 1; k < 3; ++k)
  {
    most = std::abs(normal_[k]) > std::abs(normal_[most]) ? k : most;
  }
  if (std::abs(normal_[most]) > 1 - PeriodicSpec::Same)
  {
    const double sign = normal_[most] < 0 ? -1 : 1;
    normal_ = {};
    normal_[most] = sign;
    along_[0][(most + 1) % 3] = 1;
    along_[1][(most + 2) % 3] = sign;
    return;
  }
  Vector other{};
  other[(most + 1) % 3] = 1;
  along_[0] = unit(minus(other, scaled(normal_, dot(normal_, other))));
  along_[1] = cross(normal_, along_[0]);
}

}

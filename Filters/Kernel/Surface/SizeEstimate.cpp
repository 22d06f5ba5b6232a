// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SizeEstimate.h"

#include "Base/Rings.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// How many larger boxes there are per finest box at the surface, by depth: measured on five
// surfaces for depths 1 to 5; the last value is for all greater depths.
constexpr std::array<double, 5> LargerBoxes = { 0, 0.15, 0.35, 0.45, 0.5 };

// Areas of a triangle seen along x, y and z, with their signs. Relative to a corner of the bounds: far from the origin,
// cancellation would ruin the volume.
struct Triangle
{
  Triangle(const SurfaceView& view, std::size_t t, const std::array<double, 3>& origin)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        p[corner][axis] =
          view.points[std::size_t(3) * view.triangles[3 * t + corner] + axis] - origin[axis];
      }
    }
    for (std::size_t x = 0; x < 3; ++x)
    {
      const std::size_t y = (x + 1) % 3;
      const std::size_t z = (x + 2) % 3;
      area[x] =
        ((p[1][y] - p[0][y]) * (p[2][z] - p[0][z]) - (p[1][z] - p[0][z]) * (p[2][y] - p[0][y])) / 2;
    }
  }

  std::array<std::array<double, 3>, 3> p;
  std::array<double, 3> area;
};

}

SurfaceSize sizeOf(const SurfaceView& view)
{
  const Bounds bounds = boundsOf(view);
  SurfaceSize size{ 0, {}, 0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    size.longest = std::max(size.longest, bounds.high[axis] - bounds.low[axis]);
  }
  for (std::size_t t = 0; t < view.triangleCount; ++t)
  {
    const Triangle triangle(view, t, bounds.low);
    for (std::size_t x = 0; x < 3; ++x)
    {
      size.shadows[x] += std::abs(triangle.area[x]);
      size.volume += triangle.area[x] * triangle.p[0][x] / 3;
    }
  }
  size.volume = std::abs(size.volume);
  return size;
}

std::map<std::int32_t, Shadows> shadowsOfBoundaries(const SurfaceView& view)
{
  const Bounds bounds = boundsOf(view);
  std::map<std::int32_t, Shadows> shadows;
  for (std::size_t t = 0; t < view.triangleCount; ++t)
  {
    const Triangle triangle(view, t, bounds.low);
    Shadows& sum = shadows[view.boundary ? view.boundary[t] : 0];
    for (std::size_t x = 0; x < 3; ++x)
    {
      sum[x] += std::abs(triangle.area[x]);
    }
  }
  return shadows;
}

double expectedIntersected(const Shadows& shadows, const std::array<double, 3>& box, int depth)
{
  double intersected = 0;
  for (std::size_t x = 0; x < 3; ++x)
  {
    intersected += shadows[x] / (following(box, x) * preceding(box, x));
  }
  return intersected * std::pow(4, depth);
}

double expectedBoxesAlong(const Shadows& shadows, const std::array<double, 3>& box, int depth)
{
  const double larger = LargerBoxes[std::min<std::size_t>(depth, LargerBoxes.size() - 1)];
  return expectedIntersected(shadows, box, depth) * (1 + larger);
}

double expectedInside(const SurfaceSize& surface, const std::array<double, 3>& box)
{
  // On average, half of each intersected box is inside.
  return std::max(0.0,
    surface.volume / (box[0] * box[1] * box[2]) - expectedIntersected(surface.shadows, box, 0) / 2);
}

double expectedBoxes(const SurfaceSize& surface, const std::array<double, 3>& box, int depth)
{
  return expectedInside(surface, box) + expectedBoxesAlong(surface.shadows, box, depth);
}

}

// Which triangles pass through which boxes, against the separating axis theorem in exact numbers,
// with the planes shifted so that nothing merely touches.
#include "Support/Perturbed.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace cartesian;

namespace
{

using Number = Perturbed<std::int64_t>;
using Axis = std::array<std::int64_t, 3>;

Axis cross(const Axis& a, const Axis& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

std::vector<Axis> candidates(const Corners& t)
{
  std::vector<Axis> axes = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  std::array<Axis, 3> edges{};
  for (int i = 0; i < 3; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      edges[i][axis] = std::int64_t(t[(i + 1) % 3][axis]) - t[i][axis];
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      axes.push_back(cross(edges[i], axes[axis]));
    }
  }
  axes.push_back(cross(edges[0], edges[1]));
  return axes;
}

// The box's least (or, with -axis, most) extent along an axis.
Number least(const Point& low, const Point& high, const Axis& n)
{
  Number sum;
  for (int axis = 0; axis < 3; ++axis)
  {
    sum = sum + Number::plane(axis, n[axis] > 0 ? low[axis] : high[axis]) * n[axis];
  }
  return sum;
}

bool separated(const Corners& t, const Point& low, const Point& high, const Axis& n)
{
  bool allBelow = true;
  for (const Point& p : t)
  {
    const Number x(n[0] * p[0] + n[1] * p[1] + n[2] * p[2]);
    allBelow = allBelow && x < least(low, high, n);
  }
  return allBelow;
}

bool overlaps(const Corners& t, const Point& low, const Point& high)
{
  const std::vector<Axis> axes = candidates(t);
  return std::none_of(axes.begin(), axes.end(), [&](const Axis& n) {
    const Axis opposite = { -n[0], -n[1], -n[2] };
    return separated(t, low, high, n) || separated(t, low, high, opposite);
  });
}

void expectExactOverlap(const Surface& surface, const Meshlines& planes)
{
  const Shoeboxes boxes = shoeboxesOf(surface, planes);
  std::size_t row = 0;
  for (std::size_t k = 0; k + 1 < planes[2].size(); ++k)
  {
    for (std::size_t j = 0; j + 1 < planes[1].size(); ++j, ++row)
    {
      for (std::uint32_t i = 0; i + 1 < planes[0].size(); ++i)
      {
        const auto [begin, end] = boxes.triangles(row, i);
        std::vector<std::uint32_t> expected;
        for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
        {
          if (overlaps(surface.corners(t), { planes[0][i], planes[1][j], planes[2][k] },
                { planes[0][i + 1], planes[1][j + 1], planes[2][k + 1] }))
          {
            expected.push_back(t);
          }
        }
        ASSERT_EQ(std::vector<std::uint32_t>(begin, end), expected) << i << " " << j << " " << k;
      }
    }
  }
}

}

// Also for triangles without area, and for those that extend beyond the planes.
TEST(Shoeboxes, HoldThoseTrianglesThatPassThrough)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    const int width = 2 + static_cast<int>(seed % 12);
    const Meshlines planes = randomPlanes(seed, width);
    const Soup soup = randomTetrahedra(seed, 5, width);
    expectExactOverlap(prepareOnLevels(soup, planes).surface, planes);
  }
}

TEST(Shoeboxes, HoldALargeSlantedTriangleWhereItPassesOnly)
{
  const int width = 1000;
  Soup soup = tetrahedron({ { { 1, 1, 1 }, { 2001, 17, 3 }, { 11, 1999, 5 }, { 3, 13, 1997 } } });
  Meshlines planes;
  for (auto& levels : planes)
  {
    for (Level level = 0; level <= 2 * width + 2; level += 182)
    {
      levels.push_back(level);
    }
  }
  expectExactOverlap(prepareOnLevels(soup, planes).surface, planes);
}

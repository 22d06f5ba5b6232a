// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/MeshEstimate.h"

#include "Base/Error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cartesian
{

namespace
{

// Peak memory of smooth surfaces in boxes with four corners of patches each; detail within boxes is only known
// later (Mesher/Mesher.cpp).
constexpr double BytesOfAnInsideBox = 260;
constexpr double BytesOfAnIntersectedBox = 4800;
constexpr double BytesOfATriangle = 150;

// A smooth surface passes through about this many times 4^d units of a box of depth d.
constexpr double UnitsAcrossABox = 1.6;

// The number of boxes that a triangle passes through, from the spacing around its centroid.
double boxesOfTriangle(const Corners& c, const Meshlines& planes)
{
  std::array<double, 3> u;
  std::array<double, 3> v;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double h = spacing(planes[axis], (double(c[0][axis]) + c[1][axis] + c[2][axis]) / 3);
    u[axis] = (double(c[1][axis]) - c[0][axis]) / h;
    v[axis] = (double(c[2][axis]) - c[0][axis]) / h;
  }
  double sum = 0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::size_t b = (a + 1) % 3;
    sum += std::abs(u[a] * v[b] - u[b] * v[a]) / 2;
  }
  return sum;
}

}

double MeshEstimate::bytes() const
{
  return inside * BytesOfAnInsideBox + intersected * BytesOfAnIntersectedBox +
    triangles * BytesOfATriangle;
}

MeshEstimate estimateBox(BoxStatus status, const Depths& depths)
{
  const auto wholly = [&](int allowed, int forced) -> MeshEstimate {
    const double intersected = status == BoxStatus::Intersected
      ? std::min(std::pow(8, allowed), UnitsAcrossABox * std::pow(4, allowed))
      : 0;
    return { std::pow(8, forced), intersected, 0 };
  };
  const MeshEstimate without = wholly(depths.allowed, depths.forced);
  if (depths.touched == 0)
  {
    return without;
  }
  // Where regions' borders pass, they touch half of the global boxes, more or less.
  const MeshEstimate with = wholly(depths.deepest(), depths.touched);
  return { (without.inside + with.inside) / 2, (without.intersected + with.intersected) / 2, 0 };
}

MeshEstimate estimateMesh(const Surface& surface, const Meshlines& planes)
{
  double intersected = 0;
  Bounds bounds = Bounds::none();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners c = surface.corners(t);
    intersected += boxesOfTriangle(c, planes);
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds.include(axis, c[0][axis]);
      bounds.include(axis, c[1][axis]);
      bounds.include(axis, c[2][axis]);
    }
  }
  double all = 1;
  double extent = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    all *= static_cast<double>(planes[axis].size() - 1);
    extent *= std::max(2.0, bounds.high[axis] - bounds.low[axis]) * surface.lattice.step();
  }
  const double inside = surface.around.inside()
    ? all
    : all * std::min(1.0, std::abs(volumeOf(surface)) / extent);
  return { inside, intersected, static_cast<double>(surface.triangles.size()) };
}

void checkMemory(const MeshEstimate& estimate, double mostBytes)
{
  checkMemory(estimate.boxes(), estimate.bytes(), mostBytes);
}

void checkMemory(double boxes, double bytes, double mostBytes)
{
  constexpr double GiB = 1024.0 * 1024 * 1024;
  if (bytes > mostBytes)
  {
    std::array<char, 300> text;
    std::snprintf(text.data(), text.size(),
      "The mesh would have about %.4g boxes and take about %.4g GiB, more than the Memory Limit of "
      "%.4g GiB: choose a larger Cell Size, less refinement, or raise the limit.",
      boxes, bytes / GiB, mostBytes / GiB);
    throw Error(Fault::TooManyBoxes, text.data());
  }
}

}

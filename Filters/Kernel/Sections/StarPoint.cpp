// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/StarPoint.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr int Unknowns = 4; // the point, and the radius of the ball

// a . x <= b
struct Constraint
{
  std::array<double, Unknowns> a{};
  double b = 0;
};

// Coefficients smaller than this, of rows of length 1, do not turn a plane: a division by them would lose all digits.
constexpr double LeastCoefficient = 1e-10;

// The optimum of c . x under the constraints, within a box of -1 to 1 along each axis (Seidel's method, in the order of the
// constraints: the same result each time). False: no point fulfils all of them.
bool maximise(std::vector<Constraint> rows, int unknowns, const std::array<double, Unknowns>& c,
  std::array<double, Unknowns>& x);

// The same on the plane of one constraint: its unknown with the largest coefficient is eliminated.
bool maximiseOn(const Constraint& plane, const std::vector<Constraint>& rows, std::size_t count,
  int unknowns, const std::array<double, Unknowns>& c, std::array<double, Unknowns>& x)
{
  const auto largest = [](double p, double q) { return std::abs(p) < std::abs(q); };
  const auto pivot = static_cast<std::size_t>(
    std::max_element(plane.a.begin(), plane.a.begin() + unknowns, largest) - plane.a.begin());
  if (std::abs(plane.a[pivot]) < LeastCoefficient)
  {
    return plane.b >= 0;
  }
  const auto without = [&](const std::array<double, Unknowns>& a, double factor) {
    std::array<double, Unknowns> rest{};
    std::size_t to = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(unknowns); ++i)
    {
      if (i != pivot)
      {
        rest[to++] = a[i] - factor * plane.a[i];
      }
    }
    return rest;
  };
  std::vector<Constraint> reduced;
  const auto add = [&](const Constraint& row) {
    const double factor = row.a[pivot] / plane.a[pivot];
    reduced.push_back({ without(row.a, factor), row.b - factor * plane.b });
  };
  std::for_each(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count), add);
  for (const double side : { 1.0, -1.0 }) // the box, for the unknown that is eliminated
  {
    Constraint limit;
    limit.a[pivot] = side;
    limit.b = 1;
    add(limit);
  }
  std::array<double, Unknowns> rest{};
  if (!maximise(reduced, unknowns - 1, without(c, c[pivot] / plane.a[pivot]), rest))
  {
    return false;
  }
  double value = plane.b;
  std::size_t from = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(unknowns); ++i)
  {
    if (i != pivot)
    {
      x[i] = rest[from++];
      value -= plane.a[i] * x[i];
    }
  }
  x[pivot] = value / plane.a[pivot];
  return true;
}

bool maximiseAlongLine(
  const std::vector<Constraint>& rows, double c, std::array<double, Unknowns>& x)
{
  double low = -1;
  double high = 1;
  for (const Constraint& row : rows)
  {
    if (row.a[0] > LeastCoefficient)
    {
      high = std::min(high, row.b / row.a[0]);
    }
    else if (row.a[0] < -LeastCoefficient)
    {
      low = std::max(low, row.b / row.a[0]);
    }
    else if (row.b < -LeastCoefficient)
    {
      return false;
    }
  }
  x[0] = c >= 0 ? high : low;
  return low <= high;
}

bool maximise(std::vector<Constraint> rows, int unknowns, const std::array<double, Unknowns>& c,
  std::array<double, Unknowns>& x)
{
  if (unknowns == 1)
  {
    return maximiseAlongLine(rows, c[0], x);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(unknowns); ++i)
  {
    x[i] = c[i] >= 0 ? 1 : -1;
  }
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    double value = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(unknowns); ++i)
    {
      value += rows[row].a[i] * x[i];
    }
    if (value > rows[row].b && !maximiseOn(rows[row], rows, row, unknowns, c, x))
    {
      return false;
    }
  }
  return true;
}

}

std::optional<Vector> starPoint(
  const std::vector<HalfSpace>& spaces, const Vector& near, double size)
{
  std::vector<Constraint> rows;
  rows.reserve(spaces.size());
  for (const HalfSpace& space : spaces)
  {
    const Vector& n = space.outward;
    rows.push_back({ { n[0], n[1], n[2], 1 }, (space.offset - dot(n, near)) / size });
  }
  std::array<double, Unknowns> x{};
  if (!maximise(rows, Unknowns, { 0, 0, 0, 1 }, x) || x[3] <= 0)
  {
    return std::nullopt;
  }
  return plus(near, scaled({ x[0], x[1], x[2] }, size));
}

}

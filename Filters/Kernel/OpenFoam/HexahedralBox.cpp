// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/HexahedralBox.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cartesian
{

namespace
{

constexpr int Whole = 4; // quarters of a side
constexpr double Unset = std::numeric_limits<double>::quiet_NaN();

}

bool HexahedralBox::read(const std::uint32_t* faces, std::size_t count)
{
  faces_ = faces;
  count_ = count;
  if (count < 6 || count > MostFaces)
  {
    return false;
  }
  findBounds();
  return findMiddles() && readSides();
}

double HexahedralBox::shortestEdge() const
{
  return std::min({ high_[0] - low_[0], high_[1] - low_[1], high_[2] - low_[2] });
}

void HexahedralBox::findBounds()
{
  low_.fill(std::numeric_limits<double>::max());
  high_.fill(std::numeric_limits<double>::lowest());
  for (std::size_t i = 0; i < count_; ++i)
  {
    for (std::size_t c = mesh_.start[faces_[i]]; c < mesh_.start[faces_[i] + 1UL]; ++c)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low_[axis] = std::min(low_[axis], at(mesh_.corners[c], axis));
        high_[axis] = std::max(high_[axis], at(mesh_.corners[c], axis));
      }
    }
  }
}

// Planes between boxes may have moved aside a little, so hanging nodes show where the middle is.
bool HexahedralBox::findMiddles()
{
  middle_.fill(Unset);
  quarters_.fill({ Unset, Unset });
  for (std::size_t i = 0; i < count_; ++i)
  {
    for (std::size_t c = mesh_.start[faces_[i]]; c < mesh_.start[faces_[i] + 1UL]; ++c)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        if (!placeInner(axis, at(mesh_.corners[c], axis)))
        {
          return false;
        }
      }
    }
  }
  return true;
}

bool HexahedralBox::placeInner(std::size_t axis, double at)
{
  if (at == low_[axis] || at == high_[axis])
  {
    return true;
  }
  const double eighths = 8 * (at - low_[axis]) / (high_[axis] - low_[axis]);
  double& plane = eighths < 3 ? quarters_[axis][0]
    : eighths > 5             ? quarters_[axis][1]
                              : middle_[axis];
  plane = std::isnan(plane) ? at : plane;
  return plane == at && eighths > 1 && eighths < 7;
}

bool HexahedralBox::readSides()
{
  std::array<int, 6> quarters{};
  for (std::size_t i = 0; i < count_; ++i)
  {
    const int side = sideOf(faces_[i]);
    if (side < 0)
    {
      return false;
    }
    const auto axis = static_cast<std::size_t>(side / 2);
    const int a = partAlong(faces_[i], (axis + 1) % 3);
    const int b = partAlong(faces_[i], (axis + 2) % 3);
    if (a == 0 || a != b)
    {
      return false;
    }
    isWhole_[i] = a == 2;
    quarters[static_cast<std::size_t>(side)] += a * b;
  }
  return std::all_of(quarters.begin(), quarters.end(), [](int n) { return n == Whole; });
}

// 2 * axis, and 1 for the upper one; -1: none.
int HexahedralBox::sideOf(std::uint32_t face) const
{
  const std::uint32_t* const begin = mesh_.corners.data() + mesh_.start[face];
  const std::uint32_t* const end = mesh_.corners.data() + mesh_.start[face + 1UL];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double plane = at(*begin, axis);
    if ((plane == low_[axis] || plane == high_[axis]) &&
      std::all_of(begin, end, [&](std::uint32_t point) { return at(point, axis) == plane; }))
    {
      return static_cast<int>(2 * axis) + (plane == high_[axis] ? 1 : 0);
    }
  }
  return -1;
}

// How many halves of the box a face is long; 0: neither.
int HexahedralBox::partAlong(std::uint32_t face, std::size_t axis) const
{
  double low = high_[axis];
  double high = low_[axis];
  for (std::size_t c = mesh_.start[face]; c < mesh_.start[face + 1UL]; ++c)
  {
    low = std::min(low, at(mesh_.corners[c], axis));
    high = std::max(high, at(mesh_.corners[c], axis));
  }
  const bool toLow = low == low_[axis];
  const bool toHigh = high == high_[axis];
  const bool isHalf = (toLow && high == middle_[axis]) || (toHigh && low == middle_[axis]);
  return toLow && toHigh ? 2 : isHalf ? 1 : 0;
}

int HexahedralBox::halvingsAt(std::uint32_t point) const
{
  int halvings = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double x = at(point, axis);
    const bool isEnd = x == low_[axis] || x == high_[axis];
    halvings = std::max(halvings, isEnd ? 0 : x == middle_[axis] ? 1 : 2);
  }
  return halvings;
}

}

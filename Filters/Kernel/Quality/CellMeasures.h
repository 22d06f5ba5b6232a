// SPDX-License-Identifier: BSD-3-Clause
// What cells are measured by, as sums over the areas of their faces, by OpenFOAM's definitions. Any unit of length.
#pragma once

#include "Polyhedra/CellGeometry.h"

namespace cartesian
{

// Sums of the outward areas of all faces.
class AreaSums
{
public:
  void add(const Vector& area)
  {
    sum_ = plus(sum_, area);
    sizes_ = plus(sizes_, { std::abs(area[0]), std::abs(area[1]), std::abs(area[2]) });
  }

  // The sum of the face vectors (equation 2) by the sum of their sizes, the worst of x, y, z: 0 if the cell is closed.
  double openness() const
  {
    const double most = *std::max_element(sizes_.begin(), sizes_.end());
    double worst = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (sizes_[axis] > RoundingOfAreas * most)
      {
        worst = std::max(worst, std::abs(sum_[axis]) / sizes_[axis]);
      }
    }
    return worst;
  }

  // The largest area across an axis by the smallest, or a sixth of all area by volume^(2/3).
  double aspectRatio(double volume) const
  {
    const auto [least, most] = std::minmax_element(sizes_.begin(), sizes_.end());
    const double edge = std::cbrt(std::max(volume, Tiny));
    return std::max(
      *most / (*least + Tiny), (sizes_[0] + sizes_[1] + sizes_[2]) / 6 / (edge * edge));
  }

private:
  // A cell whose area across one axis is below this part of that across another has no area there.
  static constexpr double RoundingOfAreas = 1e-12;

  Vector sum_{};
  Vector sizes_{}; // across each axis
};

// The sum of squares of a cell's inner faces, of which checkMesh takes the determinant.
template <class Number>
class DeterminantOfCell
{
public:
  void add(const VectorOf<Number>& area)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sum_[axis] = plus(sum_[axis], scaled(area, area[axis]));
    }
    size_ += norm(area);
    ++count_;
  }

  // 1 for a cube, 0 where no inner face has a third direction.
  Number value() const
  {
    if (count_ == 0 || !(valueOf(size_) > Tiny))
    {
      return Number(0);
    }
    const Number mean = size_ * (1.0 / count_);
    const Number square = mean * mean;
    return dot(sum_[0], cross(sum_[1], sum_[2])) / (square * square * square * 8.0);
  }

private:
  std::array<VectorOf<Number>, 3> sum_{};
  Number size_ = Number(0);
  int count_ = 0;
};

// How the areas of a cell's faces spread over three directions: solvers invert the sum of their squares, divided by
// their lengths, to reconstruct velocity from fluxes (OpenFOAM's fvc::reconstruct).
class AreaSpread
{
public:
  void add(const Vector& area)
  {
    const double size = norm(area) + Tiny;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sum_[axis] = plus(sum_[axis], scaled(area, area[axis] / size));
    }
  }

  // The smallest eigenvalue of the sum by the next larger one, about: 1 for a cube, 0 where no face has a third direction.
  double third() const
  {
    const double trace = sum_[0][0] + sum_[1][1] + sum_[2][2];
    const double minors =
      cross(sum_[1], sum_[2])[0] + cross(sum_[2], sum_[0])[1] + cross(sum_[0], sum_[1])[2];
    return 3 * dot(sum_[0], cross(sum_[1], sum_[2])) * trace / std::max(minors * minors, Tiny);
  }

private:
  std::array<Vector, 3> sum_{};
};

}

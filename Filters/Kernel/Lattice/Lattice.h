// SPDX-License-Identifier: BSD-3-Clause
// The integer lattice: Scaling (section 4.1) and Dual Levels (4.2, 7.1).
//
// A cube around the domain is divided into at most 4.2e9 levels in each direction. Vertices of the
// surface are on odd levels, cutting planes on even ones, so that no vertex ever lies on a plane.
// Every point that the mesher makes is a lattice point: even on its cutting planes, odd in its free
// directions. A point *is* its three levels; points are never merged by distance.
#pragma once

#include <array>
#include <cstdint>

namespace cartesian
{

using Level = std::uint32_t;

// Levels along x, y and z; compares by x, then y, then z (7.1).
using Point = std::array<Level, 3>;

// The same as ==, which calls memcmp: this is faster in loops over all points.
inline bool areSame(const Point& p, const Point& q)
{
  return ((p[0] ^ q[0]) | (p[1] ^ q[1]) | (p[2] ^ q[2])) == 0;
}

// For determinants of points: three points in a plane need 67 bits, four points in space 102.
__extension__ using Wide = __int128;

constexpr double LevelsOfTheDomain = 4.2e9;

inline bool onPlane(Level level)
{
  return level % 2 == 0;
}

struct Bounds
{
  std::array<double, 3> low;
  std::array<double, 3> high;

  // Empty: include() makes it grow.
  static Bounds none();
  void include(int axis, double x);
  double longest() const;
};

// Maps user coordinates to levels and back. The step is a power of two and the origin an odd
// multiple of it: single-precision coordinates (STL) are then exactly on odd levels, and are mapped
// back to the very same doubles.
class Lattice
{
public:
  Lattice() = default;

  // The finest lattice that holds `domain`, which is finite and has low <= high.
  explicit Lattice(const Bounds& domain);

  // Restores a lattice from its origin and step.
  Lattice(const std::array<double, 3>& origin, double step);

  // The odd level of a surface vertex, at most one step away.
  Level vertex(int axis, double x) const;

  // The even level of a cutting plane, at most one step away.
  Level plane(int axis, double x) const;

  // The level, odd or even, of a coordinate that position() returned.
  Level level(int axis, double x) const;

  double position(int axis, Level level) const { return origin_[axis] + step_ * level; }

  // In user units.
  const std::array<double, 3>& origin() const { return origin_; }
  double step() const { return step_; }

private:
  std::array<double, 3> origin_{};
  double step_ = 1;
};

}

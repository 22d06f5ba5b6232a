// SPDX-License-Identifier: BSD-3-Clause
// The integer lattice: Scaling (section 4.1) and Dual Levels (4.2, 7.1).
//
// The domain's cube is divided into at most 4.2e9 levels a direction. Vertices of the surface
// sit on odd levels, cutting planes on even ones, so that no vertex ever lies on a plane.
// Every point that the mesher makes is a lattice point: even exactly on its cutting planes,
// odd in its free directions. A point *is* its three levels; nothing is merged by distance.
#pragma once

#include <array>
#include <cstdint>

namespace cartesian
{

using Level = std::uint32_t;

// Levels along x, y and z; compares by x, then y, then z (7.1).
using Point = std::array<Level, 3>;

// As ==, which is a call of memcmp: for loops over all points.
inline bool areSame(const Point& p, const Point& q)
{
  return ((p[0] ^ q[0]) | (p[1] ^ q[1]) | (p[2] ^ q[2])) == 0;
}

// Determinants of points: 67 bits for three on a plane, 102 for four in space.
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

  // An empty box that `include` can only make larger.
  static Bounds none();
  void include(int axis, double x);
  double longest() const;
};

// Maps user coordinates to levels and back. The step is a power of two and the origin an odd
// multiple of it: coordinates in single precision (STL) then sit on odd levels exactly, and the
// way back gives the very doubles that the user gave.
class Lattice
{
public:
  Lattice() = default;

  // The finest lattice that holds `domain`, all finite, low <= high.
  explicit Lattice(const Bounds& domain);

  // A lattice read back from its description.
  Lattice(const std::array<double, 3>& origin, double step);

  // The odd level of a surface vertex, at most one step away.
  Level vertex(int axis, double x) const;

  // The even level of a cutting plane, at most one step away.
  Level plane(int axis, double x) const;

  // The level, odd or even, of a coordinate that `position` gave.
  Level level(int axis, double x) const;

  double position(int axis, Level level) const { return origin_[axis] + step_ * level; }

  // User units.
  const std::array<double, 3>& origin() const { return origin_; }
  double step() const { return step_; }

private:
  std::array<double, 3> origin_{};
  double step_ = 1;
};

}

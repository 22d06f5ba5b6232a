// SPDX-License-Identifier: BSD-3-Clause
// Parts of global boxes that must not be in larger boxes. An octant is a global box halved as often along
// each axis.
#pragma once

#include "Boxes/Boxes.h"

namespace cartesian
{

struct Octant
{
  std::array<std::uint32_t, 3> global;     // I, J, K
  int level = 0;                           // 0 to DeepestLevel
  std::array<std::uint32_t, 3> position{}; // in its global box, below 2^level

  // The half of each axis given by bits 0 to 2 of `which`.
  Octant part(unsigned which) const;
};

Point lowOf(const Octant& octant, const Meshlines& planes);
Point highOf(const Octant& octant, const Meshlines& planes);

class Octants
{
public:
  // First the number of the global box, then the place in it along a Morton curve and the level: an octant comes
  // before those in it, and these are contiguous.
  using Key = std::pair<std::uint64_t, std::uint64_t>;

  // Those in a cube.
  using Range = std::pair<std::vector<Key>::const_iterator, std::vector<Key>::const_iterator>;

  explicit Octants(const Meshlines& planes)
    : across_{ planes[0].size() - 1, planes[1].size() - 1 }
  {
  }

  Key keyOf(const Octant& octant) const;

  // Takes the lists, in which octants may occur more than once; adds the octants that they are in. No octant
  // is of level 0.
  void add(std::vector<std::vector<Key>>& lists);

  std::size_t size() const { return keys_.size(); }

  // The largest level; 0 if there are none.
  int deepest() const;
  static int deepestIn(const Range& range);

  // How many are smaller than those of a level.
  static std::size_t countBelow(const Range& range, int level);

  // Those that are smaller than a cube and in it.
  Range in(const std::array<std::uint32_t, 3>& global) const;
  static Range in(const Range& ofGlobal, const Cube& cube);

  // Raises the forced depth of each unit of a cube, which has 2^bits of them along each axis, x fastest, to the
  // deepest level of an octant that is in the unit or contains it. `range`: of the cube.
  static void raise(
    const Range& range, const Cube& cube, int bits, std::vector<std::uint8_t>& forced);

private:
  void leaveOutTwins();
  std::uint64_t numberOf(const std::array<std::uint32_t, 3>& global) const;

  std::array<std::uint64_t, 2> across_; // global boxes along x and y
  std::vector<Key> keys_;               // ascending
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Finds the fewest boxes that cover a global box (section 4.5), by dynamic programming over all
// splits.
//
// The search considers all dyadic boxes: each has a level and a position along each axis. Its cost
// is 0 if all its units are outside; 1 if its levels are at least the forced depth of all its units
// and these are all inside, or some intersected and its levels at least the allowed depth too; else
// that of its cheapest split into two halves along x, y or z. There are (2^(depth + 1) - 1)^3 such
// boxes, each evaluated once with three additions: 27, 343, 3375, 29,791, 250,047 and 2,048,383 for
// depths 1 to 6. The search is exact among the covers that repeated splitting can make; it does not
// find those that no plane splits (five boxes that wind around a corner). Of equally cheap splits,
// the one along the lowest axis is taken.
#pragma once

#include "Boxes/Boxes.h"

namespace cartesian
{

// A box within its global box.
struct LocalBox
{
  std::array<std::uint16_t, 3> offset; // fine
  std::array<std::uint8_t, 3> level;
  BoxStatus status;
  std::uint8_t corners; // as in Box
};

class FewestBoxes
{
public:
  // `units`, `forced`: status and forced depth of each unit, x fastest; `allowed`: the depth where
  // units are intersected, if their forced depth is not larger. Returns the number of boxes.
  std::uint32_t search(int depth, int allowed, const std::vector<BoxStatus>& units,
    const std::vector<std::uint8_t>& forced);

  // Appends the boxes that the last search found. The caller has to set their corners.
  void collect(std::vector<LocalBox>& boxes) const;

private:
  struct DyadicBox
  {
    std::array<int, 3> level;
    std::array<int, 3> position;
  };

  struct Content
  {
    std::uint8_t statuses = 0; // bits 1 << status of the units
    std::uint8_t forced = 0;   // the largest of the units
  };

  template <class Visitor>
  static void forEachDyadicBox(const std::array<int, 3>& level, Visitor&& visit);
  static DyadicBox whole() { return { { 0, 0, 0 }, { 0, 0, 0 } }; }
  static DyadicBox half(const DyadicBox& box, int axis, int which);
  std::size_t index(const DyadicBox& box) const;
  void evaluate(const DyadicBox& box);
  bool isLeaf(const DyadicBox& box) const;
  int cheapestSplit(const DyadicBox& box, std::uint32_t& cost) const;
  void collect(const DyadicBox& box, std::vector<LocalBox>& boxes) const;

  int depth_ = 0;
  int allowed_ = 0;
  std::vector<std::uint32_t> cost_; // of each dyadic box
  std::vector<Content> content_;    // of each dyadic box
};

}

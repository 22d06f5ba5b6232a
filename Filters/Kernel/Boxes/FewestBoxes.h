// SPDX-License-Identifier: BSD-3-Clause
// Finds the fewest boxes that cover a block (section 4.5), by dynamic programming over all splits.
//
// The search considers all dyadic boxes: each has a level and a position along each axis. Its cost
// is 0 if all its units are outside; 1 if its levels are at least the forced depth of all its units
// and these are all inside, or some intersected and its levels at least the allowed depth too; 1 for
// a unit that must be divided further, by a block of its own; else that of its cheapest split into
// two halves along x, y or z. There are (2^(bits + 1) - 1)^3 such boxes, each evaluated once with
// three additions: 27, 343 and 3375. The search is exact among the covers that repeated splitting can make; it does not
// find those that no plane splits (five boxes that wind around a corner). Of equally cheap splits,
// the one along the lowest axis is taken.
//
// If boxes must be isotropic, only cubes may stay, and splits go along all axes in turn.
#pragma once

#include "Boxes/LocalBox.h"

#include <vector>

namespace cartesian
{

class FewestBoxes
{
public:
  // `isotropic`: boxes are halved along all axes alike.
  explicit FewestBoxes(bool isotropic = false)
    : isotropic_(isotropic)
  {
  }

  // In a cube with 2^bits units along each axis. `units`, `forced`: status and forced depth of each unit, x
  // fastest; `allowed`: the depth where units are intersected, if their forced depth is not larger. Returns
  // the number of boxes and of units to divide further.
  std::uint32_t search(const Cube& cube, int bits, int allowed, const std::vector<BoxStatus>& units,
    const std::vector<std::uint8_t>& forced);

  // Appends the boxes that the last search found, whose corners the caller has to set, and the units to
  // divide further.
  void collect(std::vector<LocalBox>& boxes, std::vector<std::uint32_t>& units) const;

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
  void forEachDyadicBox(const std::array<int, 3>& level, Visitor&& visit) const;
  static DyadicBox whole() { return { { 0, 0, 0 }, { 0, 0, 0 } }; }
  static DyadicBox half(const DyadicBox& box, int axis, int which);
  std::size_t index(const DyadicBox& box) const;
  // The index of the lower half of the box at `here`; the upper one follows a stride later.
  std::size_t lowerHalf(const DyadicBox& box, std::size_t here, std::size_t axis) const;
  void evaluate(const DyadicBox& box, std::size_t here);
  bool isLeaf(const DyadicBox& box, std::size_t here) const;
  bool maySplit(const DyadicBox& box, std::size_t axis) const;
  int cheapestSplit(const DyadicBox& box, std::size_t here, std::uint32_t& cost) const;
  bool isUnit(const DyadicBox& box) const
  {
    return box.level[0] == bits_ && box.level[1] == bits_ && box.level[2] == bits_;
  }
  void collect(
    const DyadicBox& box, std::vector<LocalBox>& boxes, std::vector<std::uint32_t>& units) const;

  bool isotropic_;
  Cube cube_;
  int bits_ = 0;
  int allowed_ = 0;
  std::array<std::size_t, 3> stride_{}; // between neighbours along each axis
  std::vector<std::uint32_t> cost_;     // of each dyadic box
  std::vector<Content> content_;        // of each dyadic box
};

}

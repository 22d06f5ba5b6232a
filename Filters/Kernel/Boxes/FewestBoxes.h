// SPDX-License-Identifier: BSD-3-Clause
// The fewest boxes that cover a global box (section 4.5), by an exact search over all splits.
//
// A box of the search is a dyadic part of the global box: a level and a position along each axis.
// It costs nothing if all its units are outside; one if all are inside, and its levels are as deep
// as forced; one if it is an intersected unit; else the cheapest of its splits into two halves
// along x, y or z. There are (2^(depth + 1) - 1)^3 such boxes, each looked at once: 27, 343, 3375,
// 29,791, 250,047 and 2,048,383 for depths 1 to 6, with three additions each. The search is exact
// for every depth, among boxes that splits can make (five boxes that wind around a corner, which no
// plane can tell apart, are not looked for). Of equal splits the one along the lowest axis is taken.
#pragma once

#include "Boxes/Boxes.h"

namespace cartesian
{

// A box within its global box.
struct LocalBox
{
  std::array<std::uint8_t, 3> offset; // fine
  std::array<std::uint8_t, 3> level;
  BoxStatus status;
  std::uint8_t corners; // as in Box
};

class FewestBoxes
{
public:
  // `units`: status of each unit, x fastest. Returns the number of boxes.
  std::uint32_t search(int depth, int forced, const std::vector<BoxStatus>& units);

  // Appends the boxes that the last search found; their corners are left to the caller.
  void collect(std::vector<LocalBox>& boxes) const;

private:
  struct Part
  {
    std::array<int, 3> level;
    std::array<int, 3> position;
  };

  template <class Visitor>
  static void forEachPart(const std::array<int, 3>& level, Visitor&& visit);
  static Part whole() { return { { 0, 0, 0 }, { 0, 0, 0 } }; }
  static Part half(const Part& part, int axis, int which);
  std::size_t index(const Part& part) const;
  void evaluate(const Part& part);
  bool isLeaf(const Part& part) const;
  int cheapestSplit(const Part& part, std::uint32_t& cost) const;
  void collect(const Part& part, std::vector<LocalBox>& boxes) const;

  int depth_ = 0;
  int forced_ = 0;
  std::vector<std::uint32_t> cost_;   // of each part
  std::vector<std::uint8_t> content_; // of each part: bits 1 << status of its units
};

}

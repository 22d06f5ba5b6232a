// SPDX-License-Identifier: BSD-3-Clause
// Boxes divided into blocks, which are edited in an order of their own: cubes of boxes on the grid, each with a zone around it
// in which edits may change everything. Blocks whose zones have no box in common may be edited at the same time.
//
// Method: blocks of one colour come before those of the next, and small ones last. Along each axis so many colours alternate
// that zones of one colour do not meet, where cells are as large as boxes. Nothing but places and weights decides: a block
// depends on earlier ones within as many zones as there are colours.
#pragma once

#include "Base/Execution.h"
#include "Base/Sorting.h"
#include "Editing/Marks.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace cartesian
{

// Of a box: its place among boxes of its smallest level, which may be a part of it along some axes.
struct BoxPlace
{
  std::array<std::uint32_t, 3> at{};
  std::uint8_t level = 0;
};

struct EditBlockSize
{
  std::uint32_t width;      // in boxes: even
  std::uint32_t reach;      // of its zone, in rings of boxes that touch at nodes
  std::uint32_t mostWeight; // a block of more is divided into eight
  std::uint32_t mostMade =
    2; // cells, for each face that costs much; twice as many nodes, thrice as many faces
};

// A box that is looked at.
struct AskedBox
{
  std::uint32_t box;
  std::uint32_t weight; // grows with the work that it may take
};

struct EditBlock
{
  std::vector<std::uint32_t> own;  // boxes that it looks at, ascending
  std::vector<std::uint32_t> zone; // ... and those around them, ring by ring
};

struct EditBlockDivision
{
  std::vector<EditBlock> blocks; // in order
  std::vector<std::vector<std::uint32_t>>
    after; // of each: the earlier ones that have boxes of its zone
};

// Appends the boxes that touch one, in any order, some several times. `nodes`: marks of its own.
using Beside =
  std::function<void(std::uint32_t box, Marks& nodes, std::vector<std::uint32_t>& beside)>;

// `places`: of all boxes. `asked`: ascending.
EditBlockDivision divideIntoEditBlocks(const std::vector<BoxPlace>& places,
  const std::vector<AskedBox>& asked, const EditBlockSize& size, const Beside& beside,
  Execution& execution);

}

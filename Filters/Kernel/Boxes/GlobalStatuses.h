// SPDX-License-Identifier: BSD-3-Clause
// The statuses of global boxes, row by row (section 4.5).
#pragma once

#include "Boxes/Boxes.h"
#include "Boxes/InOut.h"
#include "Boxes/Shoeboxes.h"

namespace cartesian
{

// A global box that a triangle passes through is intersected, even if the surface only pierces one
// of its edges or sides. All others have the status of their corners.
class GlobalStatuses
{
public:
  GlobalStatuses(const Surface& surface, const Meshlines& planes, const Shoeboxes& shoeboxes,
    Execution& execution)
    : planes_(planes)
    , shoeboxes_(shoeboxes)
    , inOut_(surface, planes, execution)
  {
  }

  // Bits of the corners of a global box, as in Box::corners.
  std::uint8_t corners(std::uint32_t i, std::uint32_t j, std::uint32_t k, BoxStatus status) const
  {
    return status == BoxStatus::Inside ? AllCorners : inOut_.corners(i, j, k);
  }

  Winding lowCorner(const std::array<std::uint32_t, 3>& index) const
  {
    return inOut_.at(index[0], index[1], index[2]);
  }

  // Calls visit(i, status) for the boxes of a row that are inside or intersected.
  template <class Visitor>
  void forEachBox(std::uint32_t j, std::uint32_t k, Visitor&& visit) const
  {
    const std::size_t row = j + k * (planes_[1].size() - 1);
    std::uint32_t next = 0;
    for (std::size_t b = shoeboxes_.rowStart[row]; b < shoeboxes_.rowStart[row + 1]; ++b)
    {
      const std::uint32_t i = shoeboxes_.column[b];
      visitGap(next, i, j, k, visit);
      visit(i, BoxStatus::Intersected);
      next = i + 1;
    }
    visitGap(next, static_cast<std::uint32_t>(planes_[0].size() - 1), j, k, visit);
  }

private:
  // Visits boxes [begin, end) of a row if they are inside. No triangle passes through them, so all
  // have the status of any of their corners.
  template <class Visitor>
  void visitGap(
    std::uint32_t begin, std::uint32_t end, std::uint32_t j, std::uint32_t k, Visitor& visit) const
  {
    if (begin >= end || !inOut_.at(begin, j, k).inside())
    {
      return;
    }
    for (std::uint32_t i = begin; i < end; ++i)
    {
      visit(i, BoxStatus::Inside);
    }
  }

  const Meshlines& planes_;
  const Shoeboxes& shoeboxes_;
  InOut inOut_;
};

}

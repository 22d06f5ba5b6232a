// SPDX-License-Identifier: BSD-3-Clause
// The planes that divide a global box or a part of it into units, and through which of these triangles pass.
#pragma once

#include "Boxes/Boxes.h"
#include "Lattice/TriangleSlicing.h"

namespace cartesian
{

class UnitPlanes
{
public:
  // Of a cube in the global box `index`, with 2^bits units along each axis. Keeps its storage.
  void set(
    const Meshlines& planes, const std::array<std::uint32_t, 3>& index, const Cube& cube, int bits);

  // Both ends included.
  const std::vector<Level>& operator[](std::size_t axis) const { return planes_[axis]; }

  // Calls visit(unit) for the units that a triangle passes through, x fastest: at least once for each.
  template <class Visitor>
  void forEachUnit(const Corners& triangle, Visitor&& visit) const
  {
    forEachSlice(triangle, clip(triangle, low_, high_), 2, inner_[2],
      [&](std::int64_t below, const Fragment& slice) {
        const auto z = static_cast<std::size_t>(below + 1);
        forEachSlice(triangle, slice, 1, inner_[1], [&](std::int64_t under, const Fragment& piece) {
          const auto y = static_cast<std::size_t>(under + 1);
          const auto [least, most] = rangeOf(piece, 0);
          const auto last = static_cast<std::size_t>(intervalOf(inner_[0], most) + 1);
          for (auto x = static_cast<std::size_t>(intervalOf(inner_[0], least) + 1); x <= last; ++x)
          {
            visit(x | y << bits_ | z << 2 * bits_);
          }
        });
      });
  }

private:
  int bits_ = 0;
  Meshlines planes_;
  Meshlines inner_; // without the ends
  Point low_{};
  Point high_{};
};

}

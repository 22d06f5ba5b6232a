// SPDX-License-Identifier: BSD-3-Clause
// The boxes that cover the domain (sections 4 and 4.5).
//
// Meshlines cut space into global boxes. A global box may be divided into boxes: halved along x, y
// or z repeatedly, so that a box has its own level in each direction (0: as wide as the global
// box). Only boxes that are inside or intersected are kept: memory grows with the mesh, not with
// the grid.
#pragma once

#include "Base/Execution.h"
#include "Base/RawVector.h"
#include "Boxes/BoxTree.h"
#include "Boxes/EndlessGrid.h"
#include "Lattice/Meshlines.h"
#include "Lattice/Vector.h"
#include "Surface/Walls.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace cartesian
{

// The least width in levels of a global box that is halved so often. Where boxes are that small, the lattice must still
// resolve the surface in them: patches of the deepest are as good as others with 2^10 levels along each side.
constexpr Level leastWidth(int depth)
{
  return Level(depth > LeastPlaneLevel ? 1024 : 2) << depth;
}

// A box in compact form, as there are about as many as the mesh has cells.
struct PackedBox
{
  std::uint32_t global; // index in Boxes::globals
  Offset offset;
  std::array<std::uint8_t, 3> level; // halvings along x, y, z; its size is FinePerBox >> level
  std::uint8_t corners;              // bit x + 2 y + 4 z: that corner is inside
  BoxStatus status;
};

// A box with its position.
struct Box : PackedBox
{
  Point low;
  Point high;
};

// In levels cubed.
inline double volumeOf(const Box& box)
{
  const Vector size = minus(box.high, box.low);
  return size[0] * size[1] * size[2];
}

using CornerRegions = std::array<std::int32_t, 8>;

inline Point cornerOf(const Box& box, unsigned corner)
{
  return { corner & 1 ? box.high[0] : box.low[0], corner & 2 ? box.high[1] : box.low[1],
    corner & 4 ? box.high[2] : box.low[2] };
}

struct GlobalBox
{
  std::array<std::uint32_t, 3> index; // I, J, K
  std::uint32_t firstBox;             // in Boxes::packed; its boxes end where the next one's begin
  std::uint32_t node;                 // in Boxes::tree, or None: undivided
  std::uint8_t depth;                 // the largest level of its boxes
  std::uint8_t nearDepth; // the largest depth of it and its 26 neighbours; 0: no hanging nodes
};

// A range of layers of global boxes along z: K = begin to end - 1.
struct SlabRange
{
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  bool contains(std::uint32_t k) const { return k >= begin && k < end; }

  // Extended by up to `by` layers on either side within the grid of `all` layers; an empty range
  // stays empty.
  SlabRange grown(std::uint32_t by, std::uint32_t all) const
  {
    return begin == end ? *this : SlabRange{ begin - std::min(begin, by), std::min(end + by, all) };
  }
};

// All boxes of a grid, or those of a part of it: its core, and the halo around it on which the
// core's cells depend (Parts/Decomposition.h).
struct Boxes
{
  Lattice lattice;
  Meshlines planes;
  SlabRange core; // the layers for which cells are made; all layers of a whole grid
  SlabRange kept; // the layers that are here: the core and its halo
  RawVector<GlobalBox>
    globals; // by rows along x (J + K * boxes along y), then by I; with a sentinel at the end
  std::vector<std::size_t> rowStart;  // first global box of each row, and the end
  RawVector<PackedBox> packed;        // by global box
  BoxTree tree;                       // of divided global boxes
  std::vector<CornerRegions> regions; // of each box; empty: one region
  EndBoundaries ends = NoEnds;        // boundaries where the grid cuts the domain

  std::size_t row(std::size_t j, std::size_t k) const { return j + k * (planes[1].size() - 1); }
  const GlobalBox& globalOf(const PackedBox& box) const { return globals[box.global]; }
  bool isCore(const PackedBox& box) const { return core.contains(globalOf(box).index[2]); }

  SlabRange allLayers() const { return { 0, static_cast<std::uint32_t>(planes[2].size() - 1) }; }

  // The first box of a layer; of the one past the last, the number of boxes.
  std::uint32_t firstBoxOf(std::uint32_t layer) const
  {
    return globals[rowStart[row(0, layer)]].firstBox;
  }

  FinePoint fineLow(const PackedBox& box) const;
  static std::int64_t fineSize(const PackedBox& box, int axis)
  {
    return FinePerBox >> box.level[axis];
  }

  std::int32_t regionAt(std::size_t b, unsigned corner) const
  {
    return regions.empty() ? ((packed[b].corners >> corner & 1) != 0 ? FirstRegion : OutsideRegion)
                           : regions[b][corner];
  }

  // Of a box that the surface does not pass through.
  std::int32_t regionOf(std::size_t b) const
  {
    return regions.empty() ? FirstRegion : regions[b][0];
  }

  Box box(std::size_t b) const { return placed(packed[b]); }
  Box placed(const PackedBox& box) const;
  Point lowOf(std::size_t b) const;

  // The global box (i, j, k), or None if it is not kept.
  std::uint32_t globalAt(std::int64_t i, std::int64_t j, std::int64_t k) const;

  // The global box around a place of the fine grid, or None. `near`: a guess.
  std::uint32_t globalAt(const FinePoint& fine, std::uint32_t near) const;

  // The box that contains the fine cell with this low corner, or None. `step` receives the size of
  // the unit or global box there, within which the answer is the same. `near`: a guess of the
  // global box.
  std::uint32_t boxAt(const FinePoint& fine, std::uint32_t near, std::int64_t& step) const;

  // Fills `tree`, GlobalBox::node, depth and nearDepth from the boxes. Returns whether no two overlap.
  bool plantTree(Execution& execution);

  // Fills GlobalBox::nearDepth from the depths.
  void findNearDepths(Execution& execution);
};

// The level of a plane of the fine grid, `part` fine steps (0 to FinePerBox) from meshline i towards
// the next.
inline Level planeAt(const Meshlines& planes, std::size_t axis, std::size_t i, std::int64_t part)
{
  const std::vector<Level>& lines = planes[axis];
  if (part == 0 || part == FinePerBox)
  {
    return lines[i + (part == 0 ? 0 : 1)];
  }
  const std::vector<MovedPlane>& moved = planes.moved[axis];
  if (!moved.empty())
  {
    const std::int64_t fine = static_cast<std::int64_t>(i) * FinePerBox + part;
    const auto found = std::lower_bound(moved.begin(), moved.end(), fine,
      [](const MovedPlane& plane, std::int64_t at) { return plane.fine < at; });
    if (found != moved.end() && found->fine == fine)
    {
      return found->level;
    }
  }
  const std::int64_t half = (std::int64_t(lines[i + 1]) - lines[i]) / 2;
  return static_cast<Level>(lines[i] + 2 * (half * part / FinePerBox));
}

inline Level planeAt(const Meshlines& planes, std::size_t axis, std::int64_t fine)
{
  return planeAt(
    planes, axis, static_cast<std::size_t>(fine >> DeepestLevel), fine & (FinePerBox - 1));
}

inline FinePoint Boxes::fineLow(const PackedBox& box) const
{
  FinePoint fine;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    fine[axis] = globalOf(box).index[axis] * FinePerBox + box.offset[axis];
  }
  return fine;
}

inline Box Boxes::placed(const PackedBox& box) const
{
  Box result{ box, {}, {} };
  const auto& at = globalOf(box).index;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::int64_t low = box.offset[axis];
    result.low[axis] = planeAt(planes, axis, at[axis], low);
    result.high[axis] = planeAt(planes, axis, at[axis], low + (FinePerBox >> box.level[axis]));
  }
  return result;
}

inline Point Boxes::lowOf(std::size_t b) const
{
  const PackedBox& box = packed[b];
  const auto& at = globalOf(box).index;
  return { planeAt(planes, 0, at[0], box.offset[0]), planeAt(planes, 1, at[1], box.offset[1]),
    planeAt(planes, 2, at[2], box.offset[2]) };
}

// For each global box the largest depthOf(g) of it and its 26 neighbours.
std::vector<std::uint8_t> largestAround(const Boxes& boxes, const EndlessGrid& grid,
  const std::function<std::uint8_t(std::size_t)>& depthOf, Execution& execution);

// The boxes across a side of `box` at its four quarters: (low, low), (high, low), (low, high),
// (high, high) along the two other axes in cyclic order. If boxes are balanced, each quarter
// touches only one.
std::array<std::uint32_t, 4> facing(const Boxes& boxes, const PackedBox& box, int axis, bool upper);

// Indices of the intersected boxes, in order.
std::vector<std::uint32_t> intersectedBoxes(const Boxes& boxes, Execution& execution);

}

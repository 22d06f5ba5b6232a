// SPDX-License-Identifier: BSD-3-Clause
// A region of refinement: which boxes a closed surface touches. (The paper has blocks of global boxes
// only.)
#pragma once

#include "Boxes/GlobalBoxSet.h"
#include "Boxes/GlobalStatuses.h"
#include "Boxes/UnitStatuses.h"

namespace cartesian
{

// Boxes that are inside or touch a closed surface.
struct RefinementRegion
{
  SurfaceView surface; // closed; user units
  int depth = 1;       // allowed and forced, 0 to DeepestLevel
};

// The region's surface has its own lattice, as it may be larger than the domain; its boxes are
// those of the grid.
class RefinedRegion
{
public:
  // `lattice`, `planes`: of the grid. Throws Error: EmptySurface, BadCoordinate, FlawedSurface (the
  // region is not closed).
  RefinedRegion(const RefinementRegion& region, const Lattice& lattice, const Meshlines& planes,
    Execution& execution);

  RefinedRegion(const RefinedRegion&) = delete;
  RefinedRegion& operator=(const RefinedRegion&) = delete;

  int depth() const { return depth_; }

  // Of a global box by the region: intersected where only some of its boxes may touch it.
  BoxStatus status(std::int64_t i, std::int64_t j, std::int64_t k) const;

  // About the part of a global box that it touches where it is intersected, in boxes of its depth.
  double shareOf(std::int64_t i, std::int64_t j, std::int64_t k) const;

  // The region's border in a global box, or in a part of it.
  struct Part
  {
    const RefinedRegion* region;
    std::vector<std::uint32_t> triangles; // of the region's surface
    Winding low;                          // around the cube's low corner
  };
  Part in(const std::array<std::uint32_t, 3>& index) const;

  // Raises the forced depths of the units that the region touches to its depth; those of the others to the deepest
  // level whose box around them the region touches. So boxes shrink towards the region in all directions; else its
  // neighbours would be thin slabs. `part`: in a cube with 2^bits units along each axis, x fastest; the region is
  // deeper than the cube. `statuses` receives those of the units by the region, or of its boxes if they are larger.
  void raise(const Part& part, const std::array<std::uint32_t, 3>& index, const Cube& cube,
    int bits, UnitStatuses& statuses, std::vector<std::uint8_t>& forced) const;

private:
  RefinedRegion(const RefinementRegion& region, const Lattice& ofGrid, const Lattice& own,
    const Meshlines& planes, Execution& execution);

  TriangleRange trianglesOf(std::int64_t i, std::int64_t j, std::int64_t k) const;
  bool isTooThin(std::int64_t i, std::int64_t j, std::int64_t k) const;

  int depth_;
  Surface surface_;
  Meshlines planes_;
  Shoeboxes shoeboxes_;
  GlobalStatuses statuses_;
  GlobalBoxSet touched_; // global boxes inside or intersected
  Point low_;            // of the surface
  Point high_;
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Types of Refinement (section 4.6): how deep global boxes may, and must, be divided.
#pragma once

#include "Base/Range.h"
#include "Boxes/Boxes.h"
#include "Boxes/GlobalBoxSet.h"
#include "Boxes/Shoeboxes.h"

#include <string>

namespace cartesian
{

// A block of global boxes, both ends included, 0-based. What lies outside the grid is left out.
struct RefinementBlock
{
  std::array<std::int64_t, 3> first; // IS, JS, KS
  std::array<std::int64_t, 3> last;  // IE, JE, KE
  int allowed;                       // depth where the surface passes, 0 to DeepestLevel
  int forced;                        // depth everywhere in the block, 0 to DeepestLevel
};

// Global boxes that a boundary passes through, and layers of boxes around them.
struct BoundaryRefinement
{
  std::int32_t boundary;
  int depth = 1; // allowed at the boundary, 0 to DeepestLevel
  int blendLayers =
    0; // layers at each forced depth, 0: no blending. The first are the boxes at the
       // boundary themselves, the depth falls by one from group to group, down to 1
  bool blendBelow = false; // blending starts at depth - 1 instead of depth
};

// Global boxes that lie in or touch a closed surface.
struct RefinementRegion
{
  SurfaceView surface; // closed; user units
  int depth = 1;       // allowed and forced, 0 to DeepestLevel
};

struct RefinementSpec
{
  static constexpr Range AllDepths{ 0, DeepestLevel };

  int depth = 0; // of all boxes with no other specification, 0 to DeepestLevel
  std::vector<RefinementBlock> blocks;        // later ones win
  std::vector<BoundaryRefinement> boundaries; // the deepest wins
  std::vector<RefinementRegion> regions;      // only ever deepen
};

struct Depths
{
  int allowed = 0; // where the surface passes
  int forced = 0;  // everywhere; at most `allowed`
};

// Evaluates a specification in the paper's order: default, blocks, boundaries; then regions.
class Refinement
{
public:
  // Throws Error (BadParameter): a depth out of range, IS > IE, an unknown boundary; a region that
  // is no closed surface (EmptySurface, BadCoordinate, FlawedSurface).
  Refinement(const RefinementSpec& spec, const Surface& surface, const Shoeboxes& shoeboxes,
    const Meshlines& planes, Execution& execution);

  Depths at(std::int64_t i, std::int64_t j, std::int64_t k) const;

  // False: no box is divided.
  bool any() const { return any_; }

  // No box is divided more often along an axis.
  int deepest() const { return deepest_; }

  // Rows of tables that reach beyond the grid, in words, or nothing.
  const std::string& warnings() const { return warnings_; }

private:
  struct Boundary
  {
    int depth;
    GlobalBoxSet boxes;
    std::vector<GlobalBoxSet> blends; // boxes whose forced depth is at least blendStart - n
    int blendStart;
  };
  struct Region
  {
    int depth;
    GlobalBoxSet boxes;
  };

  void addBlocks(const RefinementSpec& spec, const Meshlines& planes);
  void addBoundary(const BoundaryRefinement& row, std::size_t number, const Surface& surface,
    const Shoeboxes& shoeboxes, const Meshlines& planes);
  void addRegion(const RefinementRegion& region, const Surface& surface, const Meshlines& planes,
    Execution& execution);

  int depth_;
  std::vector<RefinementBlock> blocks_;
  std::vector<Boundary> boundaries_;
  std::vector<Region> regions_;
  bool any_;
  int deepest_ = 0;
  std::string warnings_;
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Types of Refinement (section 4.6): how deeply global boxes may, and must, be divided.
//
// Depth, blocks and boundaries refine whole global boxes, as in the paper. Regions refine boxes: where a region's
// border passes through a global box, only the boxes that it touches must reach its depth; the others are divided as
// if it were absent, and for balance. The same holds for depths that the surface itself requires (SizingSpec.h).
#pragma once

#include "Base/Range.h"
#include "Boxes/Boxes.h"
#include "Boxes/GlobalBoxSet.h"
#include "Boxes/Octants.h"
#include "Boxes/RefinedRegion.h"
#include "Boxes/SizingSpec.h"

#include <memory>
#include <string>

namespace cartesian
{

// A block of global boxes, given by 0-based inclusive indices. What lies outside the grid is ignored.
struct RefinementBlock
{
  std::array<std::int64_t, 3> first; // IS, JS, KS
  std::array<std::int64_t, 3> last;  // IE, JE, KE
  int allowed;                       // depth where the surface passes, 0 to DeepestLevel
  int forced;                        // least depth everywhere in the block, 0 to DeepestLevel
};

// Global boxes that a boundary passes through, and layers of boxes around them.
struct BoundaryRefinement
{
  std::int32_t boundary;
  int depth = 1; // allowed at the boundary, 0 to DeepestLevel

  // Layers at each forced depth; 0: no blending. The first layer is the boxes at the boundary
  // themselves; the depth falls by one from group to group, down to 1.
  int blendLayers = 0;
  bool blendBelow = false; // blending starts at depth - 1 instead of depth
};

struct RefinementSpec
{
  static constexpr Range AllDepths{ 0, DeepestLevel };
  static constexpr Range AllTransitionLayers{ 0, 10 };

  void addUnlessThere(const BoundaryRefinement& row); // of that boundary

  // The largest depth that is asked for anywhere, right or not; and apart from sizes.
  int deepest() const;
  int deepestOfParts() const;

  int depth = 0; // of all boxes without another specification, 0 to DeepestLevel
  std::vector<RefinementBlock> blocks;        // the last one wins
  std::vector<BoundaryRefinement> boundaries; // never make boxes coarser, as section 4.6 ends
  std::vector<RefinementRegion> regions;      // never make boxes coarser
  SizingSpec sizing;                          // never makes boxes coarser

  // The least number of boxes of one level, across sides, before those twice as large. 0: 1, or the domain's default
  // (Options.h).
  int transitionLayers = 0;

  bool isotropic = false; // boxes are halved along all axes alike

  // The axes along which the grid goes on beyond its ends with the boxes at its other end, for balance and transition
  // layers.
  PeriodicAxes periodic;
};

struct Depths
{
  int allowed = 0;         // where the surface passes
  int forced = 0;          // everywhere; at most `allowed`
  int touched = 0;         // where regions touch that do so in part only; 0, or more than `forced`
  int sized = 0;           // the most that the surface requires anywhere; 0, or more than `forced`
  std::size_t octants = 0; // of them, deeper than `allowed`

  int deepest() const { return std::max({ allowed, touched, sized }); }

  // Whether some units must be deeper than others.
  bool inPart() const { return touched > 0 || sized > 0; }
};

struct TouchedPart
{
  int depth;
  double share; // of the global box
};

// What requires depths in a global box, or a part of it, apart from the surface that passes there.
struct Forcing
{
  int least = 0; // everywhere
  std::vector<RefinedRegion::Part> regions;
  Octants::Range octants;
};

// What is found with the forced depths of units.
struct ForcingScratch
{
  std::vector<UnitStatuses> ofRegions;
};

// Evaluates a specification in the paper's order: default, blocks, boundaries; then regions and sizes.
class Refinement
{
public:
  // Throws Error: BadParameter (a number out of range, IS > IE, an unknown boundary); EmptySurface,
  // BadCoordinate, FlawedSurface (a region is not a closed surface).
  Refinement(const RefinementSpec& spec, const Surface& surface, const Shoeboxes& shoeboxes,
    const Meshlines& planes, Execution& execution);

  // Enlarges the sizes required by the surface or a field by a factor, except for feature depths.
  void relax(double factor, const Surface& surface, const Shoeboxes& shoeboxes,
    const Meshlines& planes, Execution& execution);

  // As if walls with layers did not bend (SizingSpec::halvingsAtLayers).
  Refinement withoutBendsAtLayers() const;

  Depths at(std::int64_t i, std::int64_t j, std::int64_t k) const;

  // Without what the shape of the surface and fields require.
  Depths withoutSizesAt(std::int64_t i, std::int64_t j, std::int64_t k) const;

  // By depth, ascending: about which part of a global box regions touch that do so in part only.
  std::vector<TouchedPart> touchedParts(std::int64_t i, std::int64_t j, std::int64_t k) const;

  // `depths`: of this global box.
  Forcing forcingOf(const std::array<std::uint32_t, 3>& index, const Depths& depths) const;

  // The largest forced depth in each unit of a cube in a global box: 2^bits along each axis, x fastest.
  static void forcedOfUnits(const Forcing& forcing, const std::array<std::uint32_t, 3>& index,
    const Cube& cube, int bits, ForcingScratch& scratch, std::vector<std::uint8_t>& forced);

  // Of one of these units.
  static Forcing forcingOfUnit(
    const Forcing& forcing, const Cube& cube, int bits, std::size_t unit, ForcingScratch& scratch);

  // Whether any box is divided.
  bool any() const { return anyWithoutLayers_ || deepest_ > deepestWithoutSizes_; }

  // Whether any is because a wall with layers bends in it (SizingSpec::halvingsAtLayers).
  bool refinesForLayers() const { return octants_.size() > octantsWithoutBends_.size(); }

  // The most times that a box is halved along an axis.
  int deepest() const { return deepest_; }

  int transitionLayers() const { return transitionLayers_; }

  bool isIsotropic() const { return isotropic_; }

  const PeriodicAxes& periodic() const { return periodic_; }

  // A message about rows of tables that extend beyond the grid, or empty.
  const std::string& warnings() const { return warnings_; }

private:
  struct RefinedBoundary
  {
    int depth;
    GlobalBoxSet boxes;
    std::vector<GlobalBoxSet> blends; // boxes whose forced depth is at least blendStart - n
    int blendStart;
  };
  void addBlocks(const RefinementSpec& spec, const Meshlines& planes);
  void addBoundary(const BoundaryRefinement& row, std::size_t number, const Surface& surface,
    const Shoeboxes& shoeboxes, const Meshlines& planes);
  void addSizes(const SizingSpec& spec, const Surface& surface, const Shoeboxes& shoeboxes,
    const Meshlines& planes, Execution& execution);
  void addBendsAtLayers(const SizingSpec& spec, const Surface& surface, const Shoeboxes& shoeboxes,
    const Meshlines& planes, Execution& execution);
  int depth_;
  SizingSpec sizing_;
  std::vector<RefinementBlock> blocks_;
  std::vector<RefinedBoundary> boundaries_;
  std::vector<std::shared_ptr<const RefinedRegion>> regions_;
  Octants octants_;
  Octants octantsWithoutBends_; // at layers
  int transitionLayers_;
  bool isotropic_;
  PeriodicAxes periodic_;
  bool anyWithoutLayers_;
  int deepest_ = 0;
  int deepestWithoutSizes_ = 0;
  std::string warnings_;
};

}

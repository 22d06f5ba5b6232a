// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Refinement.h"

#include "Base/Error.h"
#include "Boxes/Curvature.h"
#include "Boxes/Gaps.h"
#include "Boxes/WantedSizes.h"

namespace cartesian
{

namespace
{

const std::array<std::string, 3> IndexNames = { "I from ", "J from ", "K from " };

void checkDepth(int depth, const std::string& what)
{
  requireInRange(RefinementSpec::AllDepths, depth, what);
}

// On the lattice.
void requireDivisible(const Meshlines& planes, int depth)
{
  for (const std::vector<Level>& ofAxis : planes)
  {
    for (std::size_t i = 0; i + 1 < ofAxis.size(); ++i)
    {
      if (ofAxis[i + 1] - ofAxis[i] < leastWidth(depth))
      {
        throw Error(Fault::BadParameter,
          "Some boxes are too thin to be halved " + std::to_string(depth) +
            " times on this lattice, as Largest Depth or Feature Depth allow: choose a smaller "
            "one, a larger Cell "
            "Size or a smaller domain.");
      }
    }
  }
}

double shortestEdge(const std::array<std::uint32_t, 3>& global, const Meshlines& planes)
{
  double least = LevelsOfTheDomain;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    least = std::min(least, double(planes[axis][global[axis] + 1]) - planes[axis][global[axis]]);
  }
  return least;
}

int deepestDivisible(const Meshlines& planes)
{
  Level least = std::numeric_limits<Level>::max();
  for (const std::vector<Level>& ofAxis : planes)
  {
    for (std::size_t i = 0; i + 1 < ofAxis.size(); ++i)
    {
      least = std::min(least, ofAxis[i + 1] - ofAxis[i]);
    }
  }
  int depth = 0;
  while (depth < DeepestLevel && least >= leastWidth(depth + 1))
  {
    ++depth;
  }
  return depth;
}

SizingSpec relaxed(SizingSpec spec, double factor)
{
  spec.curvatureAngle = std::min(SizingSpec::CurvatureAngles.most, spec.curvatureAngle * factor);
  spec.angleAtLayers = std::min(SizingSpec::CurvatureAngles.most, spec.angleAtLayers * factor);
  spec.cellsAcrossGaps /= factor;
  for (WantedSize& wanted : spec.sizes)
  {
    wanted.size *= factor;
  }
  for (double& size : spec.sizeOfTriangle)
  {
    size *= factor;
  }
  return spec;
}

GlobalBoxSet emptySet(const Meshlines& planes)
{
  return { static_cast<std::int64_t>(planes[0].size()) - 1,
    static_cast<std::int64_t>(planes[1].size()) - 1,
    static_cast<std::int64_t>(planes[2].size()) - 1 };
}

}

void RefinementSpec::addUnlessThere(const BoundaryRefinement& row)
{
  if (std::none_of(boundaries.begin(), boundaries.end(),
        [&](const BoundaryRefinement& other) { return other.boundary == row.boundary; }))
  {
    boundaries.push_back(row);
  }
}

int RefinementSpec::deepest() const
{
  const int ofParts = deepestOfParts();
  const int atLayers = std::max(ofParts, std::min(ofParts + sizing.halvingsAtLayers, DeepestLevel));
  return std::max(atLayers, sizing.deepest());
}

int RefinementSpec::deepestOfParts() const
{
  int result = depth;
  for (const RefinementBlock& block : blocks)
  {
    result = std::max({ result, block.allowed, block.forced });
  }
  for (const BoundaryRefinement& row : boundaries)
  {
    result = std::max(result, row.depth);
  }
  for (const RefinementRegion& region : regions)
  {
    result = std::max(result, region.depth);
  }
  return result;
}

Refinement::Refinement(const RefinementSpec& spec, const Surface& surface,
  const Shoeboxes& shoeboxes, const Meshlines& planes, Execution& execution)
  : depth_(spec.depth)
  , sizing_(spec.sizing)
  , octants_(planes)
  , octantsWithoutBends_(planes)
  , transitionLayers_(std::max(1, spec.transitionLayers))
  , isotropic_(spec.isotropic)
  , periodic_(spec.periodic)
  , anyWithoutLayers_(spec.depth > 0 || !spec.blocks.empty() || !spec.boundaries.empty() ||
      !spec.regions.empty() || spec.sizing.asksEverywhere())
{
  checkDepth(spec.depth, "Refinement Depth");
  requireInRange(
    RefinementSpec::AllTransitionLayers, double(spec.transitionLayers), "Transition Layers");
  deepest_ = spec.depth;
  addBlocks(spec, planes);
  for (std::size_t n = 0; n < spec.boundaries.size(); ++n)
  {
    addBoundary(spec.boundaries[n], n, surface, shoeboxes, planes);
  }
  for (const RefinementRegion& region : spec.regions)
  {
    checkDepth(region.depth, "The depth of Refinement Regions");
    deepest_ = std::max(deepest_, region.depth);
    regions_.push_back(std::make_shared<RefinedRegion>(region, surface.lattice, planes, execution));
  }
  requireInRange(SizingSpec::CurvatureAngles, sizing_.curvatureAngle, "Curvature Angle");
  requireInRange(SizingSpec::GapCells, sizing_.cellsAcrossGaps, "Cells Across Gaps");
  checkDepth(sizing_.featureDepth, "Feature Depth");
  checkDepth(sizing_.largestDepth, "Largest Depth");
  deepestWithoutSizes_ = deepest_;
  addSizes(sizing_, surface, shoeboxes, planes, execution);
}

void Refinement::relax(double factor, const Surface& surface, const Shoeboxes& shoeboxes,
  const Meshlines& planes, Execution& execution)
{
  octants_ = Octants(planes);
  deepest_ = deepestWithoutSizes_;
  addSizes(relaxed(sizing_, factor), surface, shoeboxes, planes, execution);
}

void Refinement::addSizes(const SizingSpec& spec, const Surface& surface,
  const Shoeboxes& shoeboxes, const Meshlines& planes, Execution& execution)
{
  if (!spec.any())
  {
    return;
  }
  requireDivisible(planes, spec.deepest());
  if (spec.curvatureAngle > 0 || spec.featureDepth > 0)
  {
    const std::pair depths(0, spec.largestDepth);
    addBends({ spec.curvatureAngle, spec.featureDepth, spec.featureAngle, {},
               [&](const std::array<std::uint32_t, 3>&) { return depths; } },
      surface, shoeboxes, planes, octants_, execution);
  }
  if (spec.cellsAcrossGaps > 0 && spec.largestDepth > 0)
  {
    addGaps(spec, surface, planes, octants_, execution);
  }
  if (spec.asksForSizes() && spec.largestDepth > 0)
  {
    addWantedSizes(spec, surface, shoeboxes, planes, octants_, execution);
  }
  octantsWithoutBends_ = octants_;
  if (spec.halvingsAtLayers > 0)
  {
    addBendsAtLayers(spec, surface, shoeboxes, planes, execution);
  }
  deepest_ = std::max(deepest_, octants_.deepest());
}

void Refinement::addBendsAtLayers(const SizingSpec& spec, const Surface& surface,
  const Shoeboxes& shoeboxes, const Meshlines& planes, Execution& execution)
{
  const int most = deepestDivisible(planes);
  BendSpec bends{ spec.angleAtLayers, 0, spec.featureAngle, {},
    [&](const std::array<std::uint32_t, 3>& global) {
      const int allowed = withoutSizesAt(global[0], global[1], global[2]).allowed;
      const double box =
        std::ldexp(shortestEdge(global, planes), -allowed) * surface.lattice.step();
      const int more = isFlat(spec.layers, box) ? spec.halvingsAtLayers : 0;
      return std::pair(allowed, std::max(allowed, std::min(allowed + more, most)));
    } };
  bends.looksAt.reserve(surface.triangles.size());
  for (const std::int32_t wall : surface.boundary)
  {
    bends.looksAt.push_back(hasLayersOn(spec.layers, surface.walls, wall) ? 1 : 0);
  }
  addBends(bends, surface, shoeboxes, planes, octants_, execution);
}

void Refinement::addBlocks(const RefinementSpec& spec, const Meshlines& planes)
{
  for (std::size_t n = 0; n < spec.blocks.size(); ++n)
  {
    RefinementBlock block = spec.blocks[n];
    const std::string name = "row " + std::to_string(n) + " of Refinement Blocks";
    checkDepth(block.allowed, "The allowed depth in " + name);
    checkDepth(block.forced, "The forced depth in " + name);
    bool empty = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::string range = IndexNames[axis] + std::to_string(block.first[axis]) + " to " +
        std::to_string(block.last[axis]);
      if (block.first[axis] > block.last[axis])
      {
        throw Error(Fault::BadParameter,
          "In " + name + ", " + range + " runs backward: give the lower index first.");
      }
      const auto most = static_cast<std::int64_t>(planes[axis].size()) - 2;
      if (block.first[axis] < 0 || block.last[axis] > most)
      {
        warnings_ += (warnings_.empty() ? "In " : " In ") + name + ", " + range +
          " extends beyond the grid (0 to " + std::to_string(most) +
          "): what lies outside is ignored.";
        block.first[axis] = std::max<std::int64_t>(block.first[axis], 0);
        block.last[axis] = std::min(block.last[axis], most);
        empty = empty || block.first[axis] > block.last[axis];
      }
    }
    if (!empty)
    {
      deepest_ = std::max({ deepest_, block.allowed, block.forced });
      blocks_.push_back(block);
    }
  }
}

void Refinement::addBoundary(const BoundaryRefinement& row, std::size_t number,
  const Surface& surface, const Shoeboxes& shoeboxes, const Meshlines& planes)
{
  const std::string name = "row " + std::to_string(number) + " of Boundary Refinement";
  checkDepth(row.depth, "The depth in " + name);
  if (row.blendLayers < 0)
  {
    throw Error(Fault::BadParameter,
      "The blending distance in " + name + " is negative: it must be 0 or more.");
  }
  const auto isRefined = [&](std::int32_t boundary) {
    return surface.walls.isOf(boundary, row.boundary);
  };
  if (std::none_of(surface.boundary.begin(), surface.boundary.end(), isRefined))
  {
    throw Error(Fault::BadParameter,
      "The surface has no boundary " + std::to_string(row.boundary) + ", which " + name +
        " names: correct the number, or remove the row.");
  }
  RefinedBoundary boundary{ row.depth, emptySet(planes), {}, row.depth - (row.blendBelow ? 1 : 0) };
  const std::size_t rowsAlongY = planes[1].size() - 1;
  for (std::size_t r = 0; r + 1 < shoeboxes.rowStart.size(); ++r)
  {
    for (std::size_t b = shoeboxes.rowStart[r]; b < shoeboxes.rowStart[r + 1]; ++b)
    {
      const auto begin =
        shoeboxes.triangle.begin() + static_cast<std::ptrdiff_t>(shoeboxes.triangleStart[b]);
      const auto end =
        shoeboxes.triangle.begin() + static_cast<std::ptrdiff_t>(shoeboxes.triangleStart[b + 1]);
      if (std::any_of(begin, end, [&](std::uint32_t t) { return isRefined(surface.boundary[t]); }))
      {
        boundary.boxes.insert(shoeboxes.column[b], static_cast<std::int64_t>(r % rowsAlongY),
          static_cast<std::int64_t>(r / rowsAlongY));
      }
    }
  }
  for (int level = boundary.blendStart; row.blendLayers > 0 && level > 0; --level)
  {
    const std::int64_t layers = std::int64_t(row.blendLayers) * (boundary.blendStart - level + 1);
    boundary.blends.push_back(boundary.boxes.grown(layers - 1));
  }
  deepest_ = std::max(deepest_, row.depth);
  boundaries_.push_back(std::move(boundary));
}

Refinement Refinement::withoutBendsAtLayers() const
{
  Refinement result = *this;
  result.octants_ = octantsWithoutBends_;
  result.deepest_ = std::max(deepestWithoutSizes_, octantsWithoutBends_.deepest());
  return result;
}

Depths Refinement::at(std::int64_t i, std::int64_t j, std::int64_t k) const
{
  Depths depths = withoutSizesAt(i, j, k);
  const std::array<std::uint32_t, 3> global = { static_cast<std::uint32_t>(i),
    static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(k) };
  const Octants::Range octants = octants_.in(global);
  const int sized = Octants::deepestIn(octants);
  depths.octants = Octants::countBelow(octants, depths.allowed);
  depths.sized = sized > depths.forced ? sized : 0;
  return depths;
}

Depths Refinement::withoutSizesAt(std::int64_t i, std::int64_t j, std::int64_t k) const
{
  const std::array<std::int64_t, 3> at = { i, j, k };
  Depths depths{ depth_, 0 };
  for (const RefinementBlock& block : blocks_)
  {
    bool in = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      in = in && block.first[axis] <= at[axis] && at[axis] <= block.last[axis];
    }
    if (in)
    {
      depths = { block.allowed, block.forced };
    }
  }
  for (const RefinedBoundary& boundary : boundaries_)
  {
    if (boundary.boxes.contains(i, j, k))
    {
      depths.allowed = std::max(depths.allowed, boundary.depth);
    }
    for (std::size_t n = 0; n < boundary.blends.size(); ++n)
    {
      if (boundary.blends[n].contains(i, j, k))
      {
        depths.forced = std::max(depths.forced, boundary.blendStart - static_cast<int>(n));
        break;
      }
    }
  }
  for (const auto& region : regions_)
  {
    const BoxStatus status = region->status(i, j, k);
    int& depth = status == BoxStatus::Inside ? depths.forced : depths.touched;
    depth = std::max(depth, status == BoxStatus::Outside ? 0 : region->depth());
  }
  depths.touched = depths.touched > depths.forced ? depths.touched : 0;
  depths.allowed = std::max(depths.allowed, depths.forced);
  return depths;
}

std::vector<TouchedPart> Refinement::touchedParts(
  std::int64_t i, std::int64_t j, std::int64_t k) const
{
  std::vector<TouchedPart> parts;
  for (const auto& region : regions_)
  {
    if (region->status(i, j, k) == BoxStatus::Intersected)
    {
      parts.push_back({ region->depth(), region->shareOf(i, j, k) });
    }
  }
  std::sort(parts.begin(), parts.end(),
    [](const TouchedPart& a, const TouchedPart& b) { return a.depth < b.depth; });
  return parts;
}

Forcing Refinement::forcingOf(const std::array<std::uint32_t, 3>& index, const Depths& depths) const
{
  Forcing forcing{ depths.forced, {}, {} };
  for (const auto& region : regions_)
  {
    if (depths.touched > 0 && region->depth() > depths.forced &&
      region->status(index[0], index[1], index[2]) == BoxStatus::Intersected)
    {
      forcing.regions.push_back(region->in(index));
    }
  }
  if (depths.sized > 0)
  {
    forcing.octants = octants_.in(index);
  }
  return forcing;
}

void Refinement::forcedOfUnits(const Forcing& forcing, const std::array<std::uint32_t, 3>& index,
  const Cube& cube, int bits, ForcingScratch& scratch, std::vector<std::uint8_t>& forced)
{
  forced.assign(std::size_t(1) << 3 * bits, static_cast<std::uint8_t>(forcing.least));
  scratch.ofRegions.resize(std::max(scratch.ofRegions.size(), forcing.regions.size()));
  for (std::size_t i = 0; i < forcing.regions.size(); ++i)
  {
    const RefinedRegion::Part& part = forcing.regions[i];
    part.region->raise(part, index, cube, bits, scratch.ofRegions[i], forced);
    scratch.ofRegions[i].sortPassing();
  }
  Octants::raise(forcing.octants, cube, bits, forced);
}

Forcing Refinement::forcingOfUnit(
  const Forcing& forcing, const Cube& cube, int bits, std::size_t unit, ForcingScratch& scratch)
{
  const Cube part = cube.part(bits, unit);
  Forcing result{ forcing.least, {}, Octants::in(forcing.octants, part) };
  for (std::size_t i = 0; i < forcing.regions.size(); ++i)
  {
    const RefinedRegion& region = *forcing.regions[i].region;
    if (region.depth() <= part.level)
    {
      continue; // its boxes are no smaller
    }
    const BoxStatus status = scratch.ofRegions[i].units()[unit];
    if (status == BoxStatus::Inside)
    {
      result.least = std::max(result.least, region.depth());
    }
    else if (status == BoxStatus::Intersected)
    {
      result.regions.push_back(
        { &region, scratch.ofRegions[i].trianglesIn(unit), scratch.ofRegions[i].lowOf(unit) });
    }
  }
  return result;
}

}

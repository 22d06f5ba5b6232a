// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Refinement.h"

#include "Base/Error.h"
#include "Boxes/GlobalStatuses.h"
#include "Repair/SurfaceCheck.h"

namespace cartesian
{

namespace
{

const std::array<std::string, 3> IndexNames = { "I from ", "J from ", "K from " };

void checkDepth(int depth, const std::string& what)
{
  requireInRange(RefinementSpec::AllDepths, depth, what);
}

GlobalBoxSet emptySet(const Meshlines& planes)
{
  return { static_cast<std::int64_t>(planes[0].size()) - 1,
    static_cast<std::int64_t>(planes[1].size()) - 1,
    static_cast<std::int64_t>(planes[2].size()) - 1 };
}

}

Refinement::Refinement(const RefinementSpec& spec, const Surface& surface,
  const Shoeboxes& shoeboxes, const Meshlines& planes, Execution& execution)
  : depth_(spec.depth)
  , any_(
      spec.depth > 0 || !spec.blocks.empty() || !spec.boundaries.empty() || !spec.regions.empty())
{
  checkDepth(spec.depth, "Refinement Depth");
  deepest_ = spec.depth;
  addBlocks(spec, planes);
  for (std::size_t n = 0; n < spec.boundaries.size(); ++n)
  {
    addBoundary(spec.boundaries[n], n, surface, shoeboxes, planes);
  }
  for (const RefinementRegion& region : spec.regions)
  {
    addRegion(region, surface, planes, execution);
  }
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
    throw Error(Fault::BadParameter, "The blending distance in " + name + " is negative.");
  }
  if (std::find(surface.boundary.begin(), surface.boundary.end(), row.boundary) ==
    surface.boundary.end())
  {
    throw Error(Fault::BadParameter,
      "The surface has no boundary " + std::to_string(row.boundary) + ", named in " + name + ".");
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
      if (std::any_of(
            begin, end, [&](std::uint32_t t) { return surface.boundary[t] == row.boundary; }))
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

// The region's surface has its own lattice, as it may be larger than the domain; its boxes are
// those of the grid.
void Refinement::addRegion(const RefinementRegion& region, const Surface& surface,
  const Meshlines& planes, Execution& execution)
{
  checkDepth(region.depth, "The depth of Refinement Regions");
  Bounds bounds = boundsOf(region.surface);
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds.include(axis, surface.lattice.position(axis, planes[axis].front()));
    bounds.include(axis, surface.lattice.position(axis, planes[axis].back()));
  }
  const Lattice lattice(bounds);
  Meshlines own;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const Level level : planes[axis])
    {
      const Level plane = lattice.plane(axis, surface.lattice.position(axis, level));
      own[axis].push_back(own[axis].empty() ? plane : std::max(plane, own[axis].back() + 2));
    }
  }
  const Surface closed = onLattice(region.surface, lattice, execution);
  const SurfaceCheck surfaceCheck = check(SurfaceEdges(closed, execution), execution);
  if (!surfaceCheck.closed())
  {
    throw Error(Fault::FlawedSurface,
      "The surface of Refinement Regions has " + std::to_string(surfaceCheck.openEdges) +
        " open edges: connect closed surfaces.");
  }
  const Shoeboxes shoeboxes = fillShoeboxes(closed, own, execution);
  const GlobalStatuses statuses(closed, own, shoeboxes, execution);
  RefinedRegion result{ region.depth, emptySet(planes) };
  for (std::uint32_t k = 0; k + 1 < planes[2].size(); ++k)
  {
    for (std::uint32_t j = 0; j + 1 < planes[1].size(); ++j)
    {
      statuses.forEachBox(j, k, [&](std::uint32_t i, BoxStatus) { result.boxes.insert(i, j, k); });
    }
  }
  deepest_ = std::max(deepest_, region.depth);
  regions_.push_back(std::move(result));
}

Depths Refinement::at(std::int64_t i, std::int64_t j, std::int64_t k) const
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
  int atBoundary = -1;
  for (const RefinedBoundary& boundary : boundaries_)
  {
    if (boundary.boxes.contains(i, j, k))
    {
      atBoundary = std::max(atBoundary, boundary.depth);
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
  depths.allowed = atBoundary >= 0 ? atBoundary : depths.allowed;
  for (const RefinedRegion& region : regions_)
  {
    if (region.boxes.contains(i, j, k))
    {
      depths.allowed = std::max(depths.allowed, region.depth);
      depths.forced = std::max(depths.forced, region.depth);
    }
  }
  depths.allowed = std::max(depths.allowed, depths.forced);
  return depths;
}

}

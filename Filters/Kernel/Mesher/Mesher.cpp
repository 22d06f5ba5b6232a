// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/Mesher.h"

#include "Base/Error.h"
#include "Boxes/MeshEstimate.h"
#include "Displacement/SurfaceDivision.h"
#include "Patches/Patches.h"
#include "Repair/PlanesAside.h"
#include "Repair/Regions.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cartesian
{

namespace
{

// The shortest side of a box, in levels.
double shortestSide(const Meshlines& planes)
{
  double least = LevelsOfTheDomain;
  for (const auto& axis : planes)
  {
    for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    {
      least = std::min(least, double(axis[i + 1]) - axis[i]);
    }
  }
  return least;
}

// Edges of triangles that move are no longer: with shorter ones more edges of patches are in the way of stacks (measured
// with 1, 2, 4, 8 on a cube and the exhaust header).
constexpr double BoxesATriangle = 4;

void makeRoomForLayers(PreparedSurface& prepared, const Options& options, Execution& execution)
{
  requireValid(options.layers);
  if (prepared.surface.walls.any())
  {
    throw Error(Fault::BadParameter,
      "Layers is " + std::to_string(options.layers.count) +
        ", but with several regions there are no layers: set it to 0.");
  }
  const double step = prepared.surface.lattice.step();
  const double levels =
    std::ldexp(shortestSide(prepared.planes), -std::max(0, options.refinement.depth));
  // The sides of a flow domain are not of the surface: nothing could be lifted there.
  WallLayerSpec spec = options.layers;
  const EndBoundaries& ends = prepared.surface.ends;
  spec.boundariesWithout.insert(spec.boundariesWithout.end(), ends.begin(), ends.end());
  prepared.undisplaced = std::make_shared<const Surface>(prepared.surface);
  divideTriangles(prepared.surface, BoxesATriangle * levels);
  prepared.displacement = std::make_shared<const Displacement>(
    displace(prepared.surface, spec, totalThickness(spec, levels * step) / step, execution));
}

Bounds united(Bounds a, const Bounds& b)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    a.include(axis, b.low[static_cast<std::size_t>(axis)]);
    a.include(axis, b.high[static_cast<std::size_t>(axis)]);
  }
  return a;
}

void requireOneRegion(const SurfaceView& view)
{
  if (view.region)
  {
    throw Error(Fault::BadParameter,
      "Domain is Outside, where there is one region: set Regions From to One, or Domain to "
      "Inside.");
  }
}

}

std::unique_ptr<Assembly> mesh(
  const SurfaceView& surface, const Options& options, Execution& execution)
{
  planStages(options, execution);
  const PreparedSurface prepared = prepareSurface(surface, options, execution);
  const std::unique_ptr<Decomposition> decomposition = decompose(prepared, options, execution);
  return meshPart(prepared, *decomposition, decomposition->allLayers(), options, execution);
}

PreparedSurface prepareSurface(
  const SurfaceView& view, const Options& options, Execution& execution, int parts)
{
  execution.stage("Scaling and Dual Levels", 0, AfterSurface);
  PreparedSurface prepared;
  prepared.memoryLimit = memoryLimitOf(options);
  prepared.bounds = boundsOf(view);
  const bool isOutside = options.domain.isOutside();
  const Bounds meshed = isOutside ? boxAround(options.domain, prepared.bounds) : prepared.bounds;
  checkGrid(options.grid, meshed, prepared.memoryLimit.bytes);
  const GridSpec grid = isOutside ? fittedTo(meshed, options.grid) : options.grid;
  const Lattice lattice(united(domainOf(grid, meshed), prepared.bounds));
  prepared.planes = onLattice(grid, meshed, lattice);
  prepared.surface = onLattice(view, lattice, execution);
  if (isOutside)
  {
    requireOneRegion(view);
    prepared.surface.around = Winding{ 1, false };
    prepared.surface.ends = options.domain.sides;
  }
  MeshEstimate estimate = estimateMesh(prepared.surface, prepared.planes);
  estimate.inside /= parts;
  estimate.intersected /= parts;
  estimate.pieces /= parts;
  checkMemory(estimate, prepared.memoryLimit);
  prepared.trianglesGiven = prepared.surface.triangles.size();
  if (view.region)
  {
    RegionSpec regions;
    regions.names = view.regionNames ? *view.regionNames : std::vector<std::string>();
    regions.contactTolerance = options.contactTolerance;
    prepared.contacts = separateRegions(prepared.surface, prepared.planes, regions, execution);
  }
  else
  {
    prepared.repair = repair(prepared.surface, prepared.planes, execution);
  }
  if (isOutside)
  {
    turnInsideOut(prepared.surface);
  }
  if (options.layers.count > 0)
  {
    makeRoomForLayers(prepared, options, execution);
  }
  stepAside(prepared.surface, prepared.planes);
  return prepared;
}

std::unique_ptr<Decomposition> decompose(
  const PreparedSurface& prepared, const Options& options, Execution& execution)
{
  execution.stage("Boxes", AfterSurface, AfterBoxes);
  RefinementSpec refinement = options.refinement;
  refinement.sizing.featureAngle = options.patches.featureAngle;
  return std::make_unique<Decomposition>(prepared.surface, prepared.planes, refinement,
    prepared.memoryLimit, laterStepsOf(options), execution);
}

Patches makePatches(const PreparedSurface& prepared, const Decomposition& decomposition,
  const Boxes& boxes, const Options& options, Execution& execution)
{
  execution.stage("Patches", AfterBoxes, AfterPatches);
  return generatePatches(
    prepared.surface, boxes, decomposition.shoeboxes(), options.patches, execution);
}

namespace
{

std::unique_ptr<Assembly> meshOnce(const PreparedSurface& prepared,
  const Decomposition& decomposition, Layers core, const Options& options, Execution& execution)
{
  Boxes boxes = decomposition.boxes(core, execution);
  const MeshEstimate estimate = estimateMesh(prepared.surface, decomposition.shoeboxes(), boxes);
  const MemoryLimit& limit = prepared.memoryLimit;
  checkMemory(estimate, limit);
  Patches patches = makePatches(prepared, decomposition, boxes, options, execution);
  // How much there is in boxes with other than exact patches is known only here.
  const auto corners = static_cast<double>(patches.corners.size());
  checkMemory(estimate.boxes(), estimate.bytes(limit, corners), limit);
  if (!prepared.displacement)
  {
    return assemble(std::move(boxes), std::move(patches), options, execution);
  }
  const WallLift lift(prepared.surface, *prepared.displacement, execution);
  auto assembly = assemble(std::move(boxes), std::move(patches), options, execution, &lift);
  assembly->layers = std::make_unique<BoundaryLayers>(
    addLayers(*assembly->mesh, prepared.surface.lattice, lift, execution));
  return assembly;
}

// Times that a surface is displaced anew, the last time nowhere.
constexpr int MostDisplacements = 7;

}

std::unique_ptr<Assembly> meshPart(const PreparedSurface& prepared,
  const Decomposition& decomposition, Layers core, const Options& options, Execution& execution)
{
  auto assembly = meshOnce(prepared, decomposition, core, options, execution);
  PreparedSurface next;
  for (int i = 1; assembly->layers && !assembly->layers->faults.empty() && i <= MostDisplacements;
       ++i)
  {
    next = i == 1 ? prepared : next;
    std::vector<std::uint32_t> notAt = assembly->layers->faults;
    if (i == MostDisplacements)
    {
      notAt.resize(next.surface.triangles.size());
      std::iota(notAt.begin(), notAt.end(), 0U);
    }
    next.displacement = std::make_shared<const Displacement>(
      displaceAgain(next.surface, *next.displacement, std::move(notAt), i - 1, execution));
    stepAside(next.surface, next.planes);
    const auto parts = decompose(next, options, execution);
    assembly.reset();
    assembly = meshOnce(next, *parts, parts->allLayers(), options, execution);
  }
  return assembly;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/Mesher.h"

#include "Base/Error.h"
#include "Boxes/MeshEstimate.h"
#include "Patches/Patches.h"
#include "Repair/PlanesAside.h"
#include "Repair/Regions.h"

#include <algorithm>
#include <cmath>

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

void requireOneRegion(const Surface& surface, const WallLayerSpec& layers)
{
  if (surface.walls.any())
  {
    throw Error(Fault::BadParameter,
      "Layers is " + std::to_string(layers.count) +
        ", but with several regions there are no layers: set it to 0.");
  }
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
    requireValid(options.layers);
    requireOneRegion(prepared.surface, options.layers);
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

// Of all layers, in user units.
double thicknessOf(const PreparedSurface& prepared, const Options& options)
{
  return totalThickness(options.layers,
    std::ldexp(shortestSide(prepared.planes) * prepared.surface.lattice.step(),
      -std::max(0, options.refinement.depth)));
}

}

std::unique_ptr<Assembly> meshPart(const PreparedSurface& prepared,
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
  if (options.layers.count == 0)
  {
    return assemble(std::move(boxes), std::move(patches), options, execution);
  }
  // The sides of a flow domain have none.
  WallLayerSpec layers = options.layers;
  const EndBoundaries& ends = prepared.surface.ends;
  layers.boundariesWithout.insert(layers.boundariesWithout.end(), ends.begin(), ends.end());
  auto assembly = assemble(std::move(boxes), std::move(patches), options, execution, &layers);
  assembly->layers = std::make_unique<BoundaryLayers>(addLayers(
    *assembly->mesh, prepared.surface, layers, thicknessOf(prepared, options), execution));
  return assembly;
}

}

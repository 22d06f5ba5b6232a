#include "Mesher/Mesher.h"

#include "Patches/Patches.h"

namespace cartesian
{

std::unique_ptr<Assembly> mesh(
  const SurfaceView& surface, const Options& options, Execution& execution)
{
  planStages(options, execution);
  const PreparedSurface prepared = prepareSurface(surface, options, execution);
  const std::unique_ptr<Division> division = divide(prepared, options, execution);
  return meshPart(prepared, *division, division->allLayers(), options, execution);
}

PreparedSurface prepareSurface(
  const SurfaceView& view, const Options& options, Execution& execution, int parts)
{
  execution.stage("Scaling and Dual Levels", 0, AfterSurface);
  const GridSpec& grid = options.grid;
  PreparedSurface prepared;
  prepared.memoryLimit = bytesAllowed(options);
  prepared.bounds = boundsOf(view);
  const Lattice lattice(domainOf(grid, prepared.bounds));
  checkGrid(grid, prepared.bounds, prepared.memoryLimit);
  prepared.planes = onLattice(grid, prepared.bounds, lattice);
  prepared.surface = onLattice(view, lattice, execution);
  Estimate estimate = estimateMesh(prepared.surface, prepared.planes);
  estimate.inside /= parts;
  estimate.intersected /= parts;
  checkMemory(estimate, prepared.memoryLimit);
  prepared.trianglesGiven = prepared.surface.triangles.size();
  prepared.repair = repair(prepared.surface, prepared.planes, execution);
  return prepared;
}

std::unique_ptr<Division> divide(
  const PreparedSurface& prepared, const Options& options, Execution& execution)
{
  execution.stage("Boxes", AfterSurface, AfterBoxes);
  return std::make_unique<Division>(prepared.surface, prepared.planes, options.refinement,
    prepared.memoryLimit, reachOf(options), execution);
}

Patches makePatches(const PreparedSurface& prepared, const Division& division, const Boxes& boxes,
  const Options& options, Execution& execution)
{
  execution.stage("Patches", AfterBoxes, AfterPatches);
  return generatePatches(prepared.surface, boxes, division.shoeboxes(), options.patches, execution);
}

std::unique_ptr<Assembly> meshPart(const PreparedSurface& prepared, const Division& division,
  Layers core, const Options& options, Execution& execution)
{
  Boxes boxes = division.boxes(core, execution);
  Patches patches = makePatches(prepared, division, boxes, options, execution);
  return assemble(std::move(boxes), std::move(patches), options, execution);
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/Mesher.h"

#include "Boxes/MeshEstimate.h"
#include "Patches/Patches.h"
#include "Repair/PlanesAside.h"
#include "Repair/Regions.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Memory of all that follows the patches, with the arrays that VTK holds: measured on spheres, tori, bumpy
// spheres and their like, at 12 to 60 boxes and depths 0 to 4, where this is 0.7 to 2.0 times what is taken (below 1 for meshes of a few MB).
constexpr double BytesOfABox = 260;
constexpr double BytesOfATriangle = 150;
constexpr double BytesOfACorner = 150;
constexpr double BytesOfAnExactBox = 1400;
constexpr double BytesOfASimplifiedBox = 2600;
constexpr double BytesOfAShapedBox = 4200;

// What the surface is like within boxes is known here only: there can be any number of patches in one.
void requireMemory(const PreparedSurface& prepared, const Boxes& boxes, const Patches& patches,
  const Options& options)
{
  const auto all = static_cast<double>(boxes.packed.size());
  const auto cut = static_cast<double>(std::count_if(boxes.packed.begin(), boxes.packed.end(),
    [](const PackedBox& box) { return box.status == BoxStatus::Intersected; }));
  const double bytesOfACutBox = options.patches.method == PatchMethod::ExactFit ? BytesOfAnExactBox
    : shapesCells(options)                                                      ? BytesOfAShapedBox
                           : BytesOfASimplifiedBox;
  checkMemory(all,
    all * BytesOfABox + cut * bytesOfACutBox +
      static_cast<double>(prepared.surface.triangles.size()) * BytesOfATriangle +
      static_cast<double>(patches.corners.size()) * BytesOfACorner,
    prepared.memoryLimit);
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
  const GridSpec& grid = options.grid;
  PreparedSurface prepared;
  prepared.memoryLimit = bytesAllowed(options);
  prepared.bounds = boundsOf(view);
  const Lattice lattice(domainOf(grid, prepared.bounds));
  checkGrid(grid, prepared.bounds, prepared.memoryLimit);
  prepared.planes = onLattice(grid, prepared.bounds, lattice);
  prepared.surface = onLattice(view, lattice, execution);
  MeshEstimate estimate = estimateMesh(prepared.surface, prepared.planes);
  estimate.inside /= parts;
  estimate.intersected /= parts;
  checkMemory(estimate, prepared.memoryLimit);
  prepared.trianglesGiven = prepared.surface.triangles.size();
  if (view.region)
  {
    separateRegions(prepared.surface, prepared.planes,
      view.regionNames ? *view.regionNames : std::vector<std::string>(), execution);
  }
  else
  {
    prepared.repair = repair(prepared.surface, prepared.planes, execution);
  }
  stepAside(prepared.surface, prepared.planes);
  return prepared;
}

std::unique_ptr<Decomposition> decompose(
  const PreparedSurface& prepared, const Options& options, Execution& execution)
{
  execution.stage("Boxes", AfterSurface, AfterBoxes);
  return std::make_unique<Decomposition>(prepared.surface, prepared.planes, options.refinement,
    prepared.memoryLimit, laterStepsOf(options), execution);
}

Patches makePatches(const PreparedSurface& prepared, const Decomposition& decomposition,
  const Boxes& boxes, const Options& options, Execution& execution)
{
  execution.stage("Patches", AfterBoxes, AfterPatches);
  return generatePatches(
    prepared.surface, boxes, decomposition.shoeboxes(), options.patches, execution);
}

std::unique_ptr<Assembly> meshPart(const PreparedSurface& prepared,
  const Decomposition& decomposition, Layers core, const Options& options, Execution& execution)
{
  Boxes boxes = decomposition.boxes(core, execution);
  Patches patches = makePatches(prepared, decomposition, boxes, options, execution);
  requireMemory(prepared, boxes, patches, options);
  return assemble(std::move(boxes), std::move(patches), options, execution);
}

}

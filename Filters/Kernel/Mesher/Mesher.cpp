// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/Mesher.h"

#include "Base/Error.h"
#include "Boxes/MeshEstimate.h"
#include "Boxes/PlanePerturbation.h"
#include "Layers/BoxSides.h"
#include "Patches/Patches.h"
#include "Repair/DomainBox.h"
#include "Repair/Regions.h"
#include "Repair/Zones.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cartesian
{

namespace
{

constexpr int MostHalvingsAtLayers = 2;

// As edits see them: of walls instead of boundaries. It makes no room at interfaces.
WallLayerSpec forWalls(WallLayerSpec layers, const Walls& walls)
{
  if (!walls.any())
  {
    return layers;
  }
  std::vector<WallLayerSpec::OfBoundary> ofWalls;
  for (std::size_t wall = 0; wall < walls.all.size(); ++wall)
  {
    const Wall& own = walls.all[wall];
    if (own.isInterface() || !layers.isIn(own.behind) || !layers.hasLayers(own.boundary))
    {
      ofWalls.push_back({ static_cast<std::int32_t>(wall), 0 });
    }
  }
  layers.boundaries = std::move(ofWalls);
  return layers;
}

// Of one of some parts that have as much each.
MeshEstimate ofAPart(MeshEstimate estimate, int parts)
{
  estimate.inside /= parts;
  estimate.intersected /= parts;
  estimate.pieces /= parts;
  return estimate;
}

// In a box with more corners, detail is simplified down to about this many, unless the user chose the exact surface.
PatchCorners cornersOf(const Patches& patches)
{
  constexpr double MostKept = 32;
  const auto all = static_cast<double>(patches.corners.size());
  if (isExact(patches))
  {
    return { all, all };
  }
  double kept = 0;
  for (std::size_t n = 0; n + 1 < patches.boxStart.size(); ++n)
  {
    const std::size_t begin = patches.start[patches.boxStart[n]];
    const std::size_t end = patches.start[patches.boxStart[n + 1]];
    kept += std::min(MostKept, static_cast<double>(end - begin));
  }
  return { all, kept };
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

void requireOneRegion(const SurfaceView& view, const DomainSpec& domain)
{
  const std::string name = domain.isOutside() ? "Outside" : "Around Points";
  if (view.region && domain.domain != Domain::Inside)
  {
    throw Error(Fault::BadParameter,
      "Domain is " + name +
        ", which allows only one region: set Regions From to One, or Domain to Inside.");
  }
  if (view.region && !(domain.keepPoints.empty() && domain.keepOut.empty()))
  {
    throw Error(Fault::BadParameter,
      "Keep Points and Keep Out work with one region only: remove them, or set Regions From to "
      "One.");
  }
}

void requireZonesFit(const Options& options)
{
  const bool fit = options.domain.isOutside() && options.domain.keepPoints.empty() &&
    options.domain.keepOut.empty() && options.baffles.empty() && options.closeGaps == 0;
  if (!options.zones.empty() && !fit)
  {
    throw Error(Fault::BadParameter,
      "Boundaries of type zone need the Domain Outside, and neither Keep Points, Keep Out, baffles "
      "nor Close "
      "Gaps: set Domain to Outside and remove those, or give regions instead (Regions From).");
  }
}

// Whether baffles may divide regions into parts (Baffles.h): the other options do not support parts.
bool mayDivide(const Options& options)
{
  return options.domain.domain == Domain::Inside && options.domain.keepPoints.empty() &&
    options.domain.keepOut.empty() && !options.layers.any();
}

MeshedSide meshedOf(const DomainSpec& domain)
{
  return domain.isOutside()
    ? MeshedSide::Outside
    : (domain.domain == Domain::Inside ? MeshedSide::Inside : MeshedSide::Unknown);
}

OpenSheets openSheetsOf(const PreparedSurface& prepared, const SurfaceView& view,
  const Options& options, Execution& execution)
{
  const bool boundSpaces = view.region || options.domain.domain == Domain::Inside;
  const double tolerance = options.contactTolerance / prepared.surface.lattice.step();
  OpenSheets sheets = findOpenSheets(prepared.surface, { options.sheets, boundSpaces, tolerance },
    options.baffles, prepared.planes, execution);
  for (std::size_t t = 0; view.isSheet && t < prepared.surface.given.size(); ++t)
  {
    if (view.isSheet[prepared.surface.given[t]] != 0)
    {
      sheets.isOfOne.resize(prepared.surface.triangles.size());
      sheets.isOfOne[t] = 1;
    }
  }
  return sheets;
}

// Repairs the surface: as regions if there are several or baffles divide the only one, else as one.
void separate(
  PreparedSurface& prepared, const SurfaceView& view, const Options& options, Execution& execution)
{
  const bool isDivided = view.region || !options.zones.empty();
  prepared.fluid = isDivided ? std::nullopt : reachFluid(prepared, options, execution);
  if (prepared.fluid)
  {
    return;
  }
  Surface& surface = prepared.surface;
  RegionSpec spec;
  spec.names = view.regionNames ? *view.regionNames : std::vector<std::string>();
  spec.contactTolerance = options.contactTolerance;
  spec.sheets = options.sheets;
  const double tolerance = options.contactTolerance / surface.lattice.step();
  const std::vector<std::uint8_t>& open = prepared.openSheets.isOfOne;
  if (!options.zones.empty())
  {
    prepared.contacts = separateZones(surface, options.zones, prepared.planes, spec, execution);
    return;
  }
  if (!options.baffles.empty() && mayDivide(options))
  {
    const Surface given = surface;
    if (!open.empty())
    {
      doubleSheets(surface, {}, open, tolerance, execution);
    }
    spec.baffles = options.baffles;
    surface.region.resize(surface.triangles.size(), FirstRegion);
    if (auto contacts = separateRegions(surface, prepared.planes, spec, execution))
    {
      prepared.contacts = std::move(*contacts);
      return;
    }
    spec.baffles.clear();
    surface = given;
  }
  if (!options.baffles.empty() || !open.empty())
  {
    doubleSheets(surface, options.baffles, open, tolerance, execution);
  }
  if (view.region)
  {
    prepared.contacts = separateRegions(surface, prepared.planes, spec, execution).value();
    return;
  }
  prepared.repair = repair(surface, prepared.planes, repairOf(options), execution);
}

std::map<std::int32_t, std::size_t> countsOf(const std::vector<std::int32_t>& boundaries)
{
  std::map<std::int32_t, std::size_t> counts;
  for (auto next = boundaries.begin(); next != boundaries.end();)
  {
    const auto begin = next;
    next =
      std::find_if(begin, boundaries.end(), [&](std::int32_t other) { return other != *begin; });
    counts[*begin] += static_cast<std::size_t>(next - begin);
  }
  return counts;
}

// Lids on a sheet that is all that there is would leave a film.
void requireSpace(const PreparedSurface& prepared, const Options& options)
{
  constexpr double ThinnestBody = 0.05; // in the mean, of a box's side
  const Surface& surface = prepared.surface;
  const double side =
    smallestBoxSide(prepared, refinementOf(options).deepest()) * surface.lattice.step();
  const bool isOneSheet = prepared.openSheets.boundNothing > 0 && surface.region.empty();
  if (isOneSheet && 2 * volumeOf(surface) < ThinnestBody * side * areaOf(surface))
  {
    throw Error(Fault::FlawedSurface,
      "There is nothing to mesh: the surface is an open sheet, with " +
        std::to_string(prepared.repair.check.openEdges) +
        " open edges, and encloses no volume. Add the walls around it, or set Domain to Outside to "
        "mesh the space around it.");
  }
}

// Orients the surface so that the meshed side is inside.
void chooseDomain(const DomainSpec& domain, PreparedSurface& prepared)
{
  Surface& surface = prepared.surface;
  if (domain.isOutside() && !surface.walls.any())
  {
    turnInsideOut(surface);
  }
  prepared.keepPoints = onLattice(domain.keepPoints, surface, prepared.planes);
  if (domain.domain != Domain::AroundPoints)
  {
    requireInside(prepared.keepPoints, domain.isOutside() ? "Outside" : "Inside");
  }
  else if (areOutside(prepared.keepPoints))
  {
    prepared.isEnclosed = true;
    surface.around = Winding{ 1, false };
    turnInsideOut(surface);
  }
  if (prepared.fluid)
  {
    prepared.keepPoints.clear(); // there is nothing else
    return;
  }
  prepared.keepOut = keepOutOnLattice(domain.keepOut, surface, prepared.planes);
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

PreparedSurface placeOnGrid(
  const SurfaceView& view, const Options& options, Execution& execution, int parts)
{
  execution.stage("Scaling and Dual Levels", 0, AfterSurface);
  PreparedSurface prepared;
  prepared.memoryLimit = memoryLimitOf(options, execution.threads());
  prepared.bounds = boundsOf(view, execution);
  const bool isOutside = options.domain.isOutside();
  const Bounds meshed = isOutside ? boxAround(options.domain, prepared.bounds) : prepared.bounds;
  checkGrid(options.grid, meshed, prepared.memoryLimit.bytes);
  const GridSpec grid = isOutside ? fittedTo(meshed, options.grid) : options.grid;
  const Bounds all = united(domainOf(grid, meshed), prepared.bounds);
  const auto place = [&](const Lattice& lattice) {
    prepared.planes = onLattice(grid, meshed, lattice);
    prepared.surface = onLattice(view, lattice, execution);
  };
  place(Lattice(all));
  requireOneRegion(view, options.domain);
  requireZonesFit(options);
  prepared.hasRoom = mayNeedSides(prepared, options, execution);
  if (prepared.hasRoom)
  {
    place(Lattice(isOutside ? withRoom(all) : withRoomAround(all)));
  }
  if (isOutside)
  {
    prepared.surface.around = Winding{ 1, false };
    prepared.surface.ends = options.domain.sides;
  }
  checkMemory(
    ofAPart(estimateMesh(prepared.surface, prepared.planes), parts), prepared.memoryLimit);
  prepared.boundariesGiven = countsOf(prepared.surface.boundary);
  return prepared;
}

double smallestBoxSide(const PreparedSurface& prepared, int depth)
{
  Level least = std::numeric_limits<Level>::max();
  for (const std::vector<Level>& lines : prepared.planes)
  {
    for (std::size_t i = 1; i < lines.size(); ++i)
    {
      least = std::min(least, lines[i] - lines[i - 1]);
    }
  }
  return std::ldexp(double(least), -depth);
}

int depthAtSurface(const Options& options)
{
  return std::max(options.depthAtSurface, refinementOf(options).deepest());
}

RepairSpec repairOf(const Options& options)
{
  return { options.sheets, meshedOf(options.domain) };
}

PreparedSurface joinSurface(
  const SurfaceView& view, const Options& options, Execution& execution, int parts)
{
  PreparedSurface prepared = placeOnGrid(view, options, execution, parts);
  prepared.cracks = joinCracks(
    prepared.surface, prepared.planes, options.cracks, depthAtSurface(options), execution);
  prepared.openSheets = openSheetsOf(prepared, view, options, execution);
  return prepared;
}

PreparedSurface prepareSurface(
  const SurfaceView& view, const Options& options, Execution& execution, int parts)
{
  PreparedSurface prepared = joinSurface(view, options, execution, parts);
  separate(prepared, view, options, execution);
  chooseDomain(options.domain, prepared);
  if (options.layers.any())
  {
    requireValid(options.layers);
  }
  stepAside(prepared.surface, refinementOf(options).deepest(), prepared.planes, execution);
  return prepared;
}

RefinementSpec refinementOf(const Options& options, double longestSide)
{
  RefinementSpec refinement = options.refinement;
  refinement.sizing.featureAngle = options.patches.featureAngle;
  refinement.transitionLayers = transitionLayersOf(options);
  if (options.layers.any() && options.layers.refine)
  {
    refinement.sizing.halvingsAtLayers = MostHalvingsAtLayers;
    refinement.sizing.layers =
      withNumber(forFlow(options.layers, longestSide), options.grid.cellSize);
  }
  return refinement;
}

std::unique_ptr<Decomposition> decompose(
  const PreparedSurface& prepared, const Options& options, Execution& execution)
{
  execution.stage("Boxes", AfterSurface, AfterBoxes);
  return std::make_unique<Decomposition>(prepared.surface, prepared.planes,
    refinementOf(options, prepared.bounds.longest()), prepared.memoryLimit, editsWall(options),
    execution);
}

Patches makePatches(const PreparedSurface& prepared, const Decomposition& decomposition,
  const Boxes& boxes, const Options& options, Execution& execution)
{
  execution.stage("Patches", AfterBoxes, AfterPatches);
  return generatePatches(
    prepared.surface, boxes, decomposition.shoeboxes(), options.patches, execution);
}

std::unique_ptr<Assembly> meshPart(const PreparedSurface& prepared,
  const Decomposition& decomposition, SlabRange core, const Options& options, Execution& execution)
{
  requireSpace(prepared, options);
  const PartsToKeep parts{ prepared.keepPoints, prepared.keepOut, &prepared.surface,
    prepared.isEnclosed };
  Boxes boxes = decomposition.boxes(core, execution);
  const MeshEstimate estimate = decomposition.together(
    estimateLayers(decomposition.shoeboxes(), boxes, execution), decomposition.allLayers());
  const MemoryLimit& limit = prepared.memoryLimit;
  checkMemory(estimate, limit);
  const std::size_t added = decomposition.boxesAddedForLayers(boxes.packed.size(), execution);
  Patches patches = makePatches(prepared, decomposition, boxes, options, execution);
  // The content of boxes with other than exact patches is known only here.
  checkMemory(estimate.boxes(), estimate.bytes(limit, cornersOf(patches)), limit);
  if (!options.layers.any())
  {
    return assemble(std::move(boxes), std::move(patches), options, execution, nullptr, parts);
  }
  // The sides of a flow domain have none.
  const double side = boxSideForLayers(boxes, patches, options.layers, execution);
  WallLayerSpec layers = withNumber(forFlow(options.layers, prepared.bounds.longest()), side);
  const EndBoundaries& ends = prepared.surface.ends;
  for (const std::int32_t end : ends)
  {
    layers.boundaries.push_back({ end, 0 });
  }
  const WallLayerSpec ofWalls = forWalls(layers, prepared.surface.walls);
  auto assembly =
    assemble(std::move(boxes), std::move(patches), options, execution, &ofWalls, parts);
  execution.stage("Layers", AfterNumbering, AfterLayers);
  assembly->layers = std::make_unique<BoundaryLayers>(
    addLayers(*assembly->mesh, prepared.surface, layers, execution));
  assembly->layers->wanted = layersTo(layers, side);
  assembly->layers->boxesAdded = added;
  return assembly;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/Assembly.h"

#include "Mesher/LeakPath.h"

#include "Base/Error.h"
#include "Cells/Cells.h"
#include "Cells/ConnectedCells.h"
#include "Cells/Fragments.h"
#include "Cells/Interfaces.h"
#include "Cells/OverlappingCells.h"
#include "Editing/FlatFaces.h"
#include "Editing/WallClosing.h"
#include "Editing/WallImprovement.h"
#include "Faces/BoxRebuilding.h"
#include "Lattice/Vector.h"
#include "Layers/WarpedWalls.h"
#include "Mesher/Messages.h"
#include "Mesher/Stages.h"
#include "Patches/VolumeGap.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace cartesian
{

namespace
{

using BoxFlags = std::vector<std::uint8_t>; // 0 or 1 for each polyhedral box

// Boxes with more patches may show detail that is smaller than they are, and do where the polygons over their
// polylines move no more than this part of the box's volume. With very many patches they surely do: at 1/25 of
// its length no CAD surface that was measured has boxes with more than 31, while half of the boxes of a scan
// have more than 60.
constexpr std::ptrdiff_t ManyPatches = 8;
constexpr std::ptrdiff_t TooManyPatches = 32;
constexpr double VolumeOfDetail = 0.03;

void unite(BoxFlags& flags, const BoxFlags& others)
{
  std::transform(flags.begin(), flags.end(), others.begin(), flags.begin(), std::bit_or<>());
}

// Nodes and inner faces, from the patches.
void makeInnerFaces(Assembly& a, Execution& execution)
{
  a.nodes = findNodes(a.boxes, a.patches, a.sides, execution);
  execution.stage("Inner faces", AfterSides, AfterInnerFaces);
  a.inner = generateInnerFaces(a.boxes, a.patches, a.sides, a.nodes, execution);
}

// Boxes whose faces do not close.
BoxFlags findFlawed(const Assembly& a, Execution& execution)
{
  return findFlawed(a.boxes, a.patches, a.sides, a.nodes, a.inner, execution);
}

WallMesh makeCells(const Assembly& a, const Options& options, Execution& execution)
{
  return assembleCells(
    a.boxes, a.patches, a.sides, a.nodes, a.inner, options.smallCells, execution);
}

BoxFlags makeFaces(Assembly& a, Execution& execution)
{
  makeInnerFaces(a, execution);
  execution.stage("Cells", AfterInnerFaces, AfterCells);
  return findFlawed(a, execution);
}

std::ptrdiff_t patchesOf(const Assembly& a, std::uint32_t box)
{
  return static_cast<std::ptrdiff_t>(a.patches.boxStart[box + 1] - a.patches.boxStart[box]);
}

// Boxes that may hold more detail than their size can show. Borders between boundaries stay, and what passes
// between the corners of a box without taking any in: its polylines alone would not show it.
BoxFlags findDetailed(const Assembly& a)
{
  const auto& boundary = a.patches.boundary;
  BoxFlags detailed(a.sides.polyhedral.size());
  for (std::size_t n = 0; n < detailed.size(); ++n)
  {
    const std::uint32_t box = a.sides.patchBox[n];
    const std::uint8_t corners = a.boxes.packed[a.sides.polyhedral[n]].corners;
    if (box != None && corners != 0 && corners != AllCorners && patchesOf(a, box) > ManyPatches)
    {
      const auto begin = boundary.begin() + std::ptrdiff_t(a.patches.boxStart[box]);
      const auto end = boundary.begin() + std::ptrdiff_t(a.patches.boxStart[box + 1]);
      detailed[n] = std::all_of(begin, end, [&](std::int32_t other) { return other == *begin; });
    }
  }
  return detailed;
}

// Where a box holds more detail than its size can show, the inner part of its patches is replaced by
// polygons over the polylines on its sides: the paper's IP patches (4.11), before anything else looks at it.
void simplifyDetail(Assembly& a, Execution& execution)
{
  BoxFlags detailed = isExact(a.patches) || a.patches.walls.any() ? BoxFlags{} : findDetailed(a);
  if (std::find(detailed.begin(), detailed.end(), 1) == detailed.end())
  {
    return;
  }
  makeInnerFaces(a, execution);
  const auto simplified = [&] {
    return rebuildFlawedBoxes(
      a.boxes, a.patches, a.sides, a.nodes, a.inner, detailed, RebuildLevel::Detail, execution)
      .patches;
  };
  std::vector<double> behind(detailed.size());
  const Patches trial = simplified();
  for (std::size_t n = 0; n < detailed.size(); ++n)
  {
    if (!detailed[n])
    {
      continue;
    }
    const std::uint32_t box = a.sides.patchBox[n];
    const Box at = a.boxes.box(a.sides.polyhedral[n]);
    behind[n] = spaceBehind(at, a.patches, box).sum();
    if (patchesOf(a, box) <= TooManyPatches)
    {
      detailed[n] =
        std::abs(spaceBehind(at, trial, box).sum() - behind[n]) <= VolumeOfDetail * volumeOf(at);
    }
  }
  a.patches = simplified();
  for (std::size_t n = 0; n < detailed.size(); ++n)
  {
    if (detailed[n] && !a.patches.missing.empty())
    {
      const std::uint32_t box = a.sides.patchBox[n];
      a.patches.missing[box] =
        missingBy(behind[n], spaceBehind(a.boxes.box(a.sides.polyhedral[n]), a.patches, box));
    }
  }
}

// Where several regions meet, patches cannot be rebuilt from corners alone.
Error flawBetweenRegions(const Assembly& a, const BoxFlags& flawed)
{
  const auto n =
    static_cast<std::size_t>(std::find(flawed.begin(), flawed.end(), 1) - flawed.begin());
  const Box box = a.boxes.box(a.sides.polyhedral[n]);
  const auto place = [&](std::size_t axis) {
    return number((a.boxes.lattice.position(static_cast<int>(axis), box.low[axis]) +
                    a.boxes.lattice.position(static_cast<int>(axis), box.high[axis])) /
      2);
  };
  return { Fault::FlawedSurface,
    "The walls of the regions do not close in the box around (" + place(0) + ", " + place(1) +
      ", " + place(2) +
      "): with several regions, no surface may intersect itself. Repair it there." };
}

// The same, by walls instead of boundaries.
Options forWalls(Options options, const Walls& walls)
{
  if (!walls.any())
  {
    return options;
  }
  SmallCellSpec& spec = options.smallCells;
  const std::vector<BoundaryRatio> given = std::move(spec.boundaryRatios);
  spec.boundaryRatios.clear();
  for (std::size_t wall = 0; wall < walls.all.size(); ++wall)
  {
    for (const BoundaryRatio& own : given)
    {
      if (own.boundary == walls.all[wall].boundary)
      {
        spec.boundaryRatios.push_back({ static_cast<std::int32_t>(wall), own.ratio });
      }
    }
  }
  return options;
}

// Each time the boxes that still are flawed keep less. Returns those that are flawed in the end.
BoxFlags rebuildFlawed(Assembly& a, BoxFlags flawed, Execution& execution)
{
  BoxFlags all(flawed.size());
  for (const RebuildLevel givenUp :
    { RebuildLevel::Nothing, RebuildLevel::Chords, RebuildLevel::Crossings })
  {
    if (std::find(flawed.begin(), flawed.end(), 1) == flawed.end())
    {
      break;
    }
    if (a.patches.walls.any())
    {
      throw flawBetweenRegions(a, flawed);
    }
    execution.stage("Flawed boxes", AfterCells, AfterCells);
    RebuiltPatches next =
      rebuildFlawedBoxes(a.boxes, a.patches, a.sides, a.nodes, a.inner, flawed, givenUp, execution);
    unite(all, next.boxes);
    a.patches = std::move(next.patches);
    flawed = makeFaces(a, execution);
  }
  for (std::size_t n = 0; n < all.size(); ++n)
  {
    if (all[n] != 0)
    {
      a.rebuilt.push_back(a.sides.polyhedral[n]); // edits may renumber polyhedral boxes
    }
  }
  return flawed;
}

double smallestSide(const Boxes& boxes)
{
  double least = std::numeric_limits<double>::max();
  for (std::uint32_t b = 0; b < boxes.packed.size(); ++b)
  {
    const Box box = boxes.box(b);
    least = std::min(least, double(box.high[0] - box.low[0]));
  }
  return least;
}

// Leaves out all parts without a point to keep: from then on, it is as if the surface did not have them. Returns
// the boxes that are flawed.
BoxFlags keepParts(Assembly& a, BoxFlags flawed, const PartsToKeep& which, const Options& options,
  Execution& execution)
{
  if (which.points.empty() && which.keepOut.empty())
  {
    return flawed;
  }
  const KeptParts kept = findKeptParts(
    which, a.boxes, a.patches, a.sides, a.nodes, makeCells(a, options, execution), execution);
  if (kept.leak)
  {
    LeakSearch search(
      a.boxes.planes, 0, smallestSide(a.boxes), memoryLimitOf(options, execution.threads()).bytes);
    search.from = kept.leak->from == None ? nullptr : &which.points[kept.leak->from];
    search.to = &which.keepOut[kept.leak->keptOut];
    tellLeak(*which.surface, search, execution);
  }
  a.separate.leftOut = kept.leftOut;
  if (kept.leftOut == 0)
  {
    return flawed;
  }
  std::vector<std::uint32_t> rebuilt;
  for (const std::uint32_t box : a.rebuilt)
  {
    const auto stays = std::lower_bound(kept.boxes.begin(), kept.boxes.end(), box);
    if (stays != kept.boxes.end() && *stays == box)
    {
      rebuilt.push_back(static_cast<std::uint32_t>(stays - kept.boxes.begin()));
    }
  }
  a.rebuilt = std::move(rebuilt);
  keepOnly(kept, a.boxes, a.patches, execution);
  a.sides = findSides(a.boxes, execution);
  return makeFaces(a, execution);
}

// Returns nothing for one beyond the core: another part reports it.
std::optional<RemovedCell> remove(Assembly& a, std::uint32_t c, RemovalReason reason)
{
  Cell& cell = a.wall.cells[c];
  cell.removed = true;
  if (!a.boxes.isCore(a.boxes.packed[cell.box]))
  {
    return std::nullopt;
  }
  return RemovedCell{ cell.box, cell.volumeFraction * volumeOf(a.boxes.box(cell.box)), reason };
}

// Solvers cannot use overlapping cells, however exactly they represent the surface. If edits have made some
// nevertheless, their neighbours cannot be repaired any more: a warning says so.
void removeOverlapping(Assembly& a, Execution& execution)
{
  for (const std::uint32_t c : overlappingCells(a.boxes, a.nodes.at.size(), a.wall, execution))
  {
    if (const auto removed = remove(a, c, RemovalReason::Refused))
    {
      a.edits.overlapping.push_back(*removed);
    }
  }
}

// A solver cannot determine the pressure in fragments: they are removed, unless the surface must stay exact.
void removeFragments(Assembly& a, const Options& options, Execution& execution)
{
  const bool removes = shapesCells(options) && options.smallCells.handling == SmallCells::Merge &&
    options.shaping.refusedCellRatio > 0 && !isExact(a.patches);
  for (const SmallPart& part : findSmallParts(a.boxes, a.patches, a.sides, a.wall, execution))
  {
    for (const std::uint32_t c : part.cells)
    {
      if (!removes || !part.isFragment)
      {
        a.separate.isolatedCells += a.boxes.isCore(a.boxes.packed[a.wall.cells[c].box]) ? 1 : 0;
      }
      else if (const auto removed = remove(a, c, RemovalReason::Fragment))
      {
        a.separate.fragments.push_back(*removed);
      }
    }
  }
}

// What was done to cells of the core.
void count(Assembly& a, const std::vector<MadeEdit>& edits)
{
  for (const MadeEdit& edit : edits)
  {
    if (a.boxes.isCore(a.boxes.packed[edit.boxIndex]))
    {
      a.edits.merged += edit.kind == EditKind::Merge ? 1 : 0;
      a.edits.split += edit.kind == EditKind::Cut ? 1 : 0;
      a.edits.simplified += edit.kind == EditKind::Flatten ? 1 : 0;
      if (edit.kind == EditKind::Remove)
      {
        a.edits.removed.push_back({ edit.boxIndex, edit.removed, edit.reason });
      }
    }
  }
}

ImprovementSpec improvementOf(const Options& options, bool exact)
{
  const bool merges = options.smallCells.handling == SmallCells::Merge;
  const CellShapeSpec& shaping = options.shaping;
  ImprovementSpec spec;
  spec.collapseRatio = options.collapse.ratio;
  spec.smallShare = merges ? shaping.mergeRatio : options.smallCells.ratio;
  spec.small = options.smallCells;
  spec.small.ratio = merges ? shaping.strandedRatio() : options.smallCells.ratio;
  spec.cuts = shaping.splitConcave;
  spec.mayChangeWalls = !exact;
  spec.movesNodes = shaping.optimiseNodes && !exact;
  spec.trueVolume = keepsTrueVolume(options) && !exact;
  spec.removesCells = shaping.refusedCellRatio > 0 && !exact;
  return spec;
}

void editWall(
  Assembly& a, const Options& options, const WallLayerSpec* layers, Execution& execution)
{
  constexpr double AfterOpening = 0.9 * AfterCells + 0.1 * AfterEditing;
  constexpr double AfterEdits = 0.06 * AfterCells + 0.94 * AfterEditing;
  constexpr double AfterClosing = 0.02 * AfterCells + 0.98 * AfterEditing;
  execution.stage("Opening of the wall", AfterCells, AfterOpening);
  const bool isEdited = editsWall(options) || hasFlatFaces(a.nodes, a.wall, execution);
  EditableWall wall = openWall({ a.boxes, a.patches, a.sides, a.nodes, a.wall },
    { options.patches.featureAngle, layers }, execution);
  a.wall.forgetFaces();
  a.sides.forgetSides();
  if (isEdited)
  {
    execution.stage("Edits of the wall", AfterOpening, AfterEdits);
    count(a, improveWall(wall.mesh, improvementOf(options, isExact(a.patches)), execution));
  }
  execution.stage("Closing of the wall", AfterEdits, AfterClosing);
  closeWall(wall, a.boxes, a.patches.walls, a.sides, a.nodes, a.wall, execution);
  wall.mesh.mesh().release(execution);
  execution.stage("Checks of cells", AfterClosing, AfterEditing);
}

bool isWhole(const Assembly& a)
{
  const SlabRange all = a.boxes.allLayers();
  return a.boxes.core.begin == all.begin && a.boxes.core.end == all.end;
}

// User units cubed.
std::vector<double> volumesOfRegions(const Assembly& a)
{
  std::int32_t regions = FirstRegion;
  for (const Wall& wall : a.patches.walls.all)
  {
    regions = std::max(
      { regions, a.patches.walls.givenOf(wall.behind), a.patches.walls.givenOf(wall.front) });
  }
  std::vector<double> volumes(static_cast<std::size_t>(regions));
  const double step = a.boxes.lattice.step();
  const auto add = [&](std::uint32_t b, std::int32_t region, double fraction) {
    const Box box = a.boxes.box(b);
    const Vector size = minus(box.high, box.low);
    volumes[static_cast<std::size_t>(a.patches.walls.givenOf(region) - FirstRegion)] +=
      fraction * size[0] * step * size[1] * step * size[2] * step;
  };
  const std::uint32_t end = a.boxes.firstBoxOf(a.boxes.core.end);
  for (std::uint32_t b = a.boxes.firstBoxOf(a.boxes.core.begin); b < end; ++b)
  {
    const std::uint32_t n = a.sides.polyhedralOrdinal(b);
    if (n == None)
    {
      add(b, a.boxes.regionOf(b), 1);
    }
    for (std::size_t c = n == None ? 0 : a.wall.boxStart[n];
         n != None && c < a.wall.boxStart[n + 1]; ++c)
    {
      const Cell& cell = a.wall.cells[c];
      add(b, cell.region, cell.removed ? 0 : cell.volumeFraction);
    }
  }
  return volumes;
}

void requireCells(const Assembly& a, const Options& options)
{
  if (isWhole(a) && a.mesh->cellCount() == 0)
  {
    throw nothingToMesh(a, options);
  }
}

}

std::unique_ptr<Assembly> cutCells(Boxes boxes, Patches patches, const Options& given,
  Execution& execution, const PartsToKeep& parts)
{
  requireValidCells(given);
  const Options options = forWalls(given, patches.walls);
  auto assembly = std::make_unique<Assembly>();
  Assembly& a = *assembly;
  a.boxes = std::move(boxes);
  a.patches = std::move(patches);

  execution.stage("Common sides of boxes", AfterPatches, AfterSides);
  a.sides = findSides(a.boxes, execution);
  simplifyDetail(a, execution);
  keepParts(a, rebuildFlawed(a, makeFaces(a, execution), execution), parts, options, execution);
  a.wall = makeCells(a, options, execution);
  a.inner = InnerFaces();
  a.nodes.forgetBorders();
  removeOverlapping(a, execution);
  makeInterfaces(a.patches.walls, a.wall);
  return assembly;
}

std::unique_ptr<Assembly> assemble(Boxes boxes, Patches patches, const Options& given,
  Execution& execution, const WallLayerSpec* layers, const PartsToKeep& parts)
{
  auto assembly = cutCells(std::move(boxes), std::move(patches), given, execution, parts);
  Assembly& a = *assembly;
  const Options options = forWalls(given, a.patches.walls);
  editWall(a, options, layers, execution);
  for (const std::uint32_t c : overlappingCells(a.boxes, a.nodes.at.size(), a.wall, execution))
  {
    if (a.boxes.isCore(a.boxes.packed[a.wall.cells[c].box]))
    {
      a.overlapping.push_back(a.wall.cells[c].box);
    }
  }
  removeFragments(a, options, execution);
  if (layers)
  {
    divideWarpedWalls(a.boxes, a.nodes, a.patches.walls, *layers, a.wall);
  }
  if (isWhole(a))
  {
    a.separate.ofRegions = countParts(a.boxes, a.patches.walls, a.sides, a.wall, execution);
  }
  execution.stage("Numbering", AfterEditing, AfterNumbering);
  a.mesh = std::make_unique<OutputMesh>(
    MeshParts{ a.boxes, a.patches, a.sides, a.nodes, a.wall }, execution);
  requireCells(a, options);
  a.regionVolumes = volumesOfRegions(a);
  return assembly;
}

std::size_t countRemoved(const Assembly& a, RemovalReason reason)
{
  std::size_t count = 0;
  for (const auto* cells : { &a.edits.removed, &a.edits.overlapping, &a.separate.fragments })
  {
    count += static_cast<std::size_t>(std::count_if(cells->begin(), cells->end(),
      [&](const RemovedCell& cell) { return cell.reason == reason; }));
  }
  return count;
}

std::vector<std::uint32_t> rebuiltBoxes(const Assembly& a)
{
  std::vector<std::uint32_t> rebuilt;
  std::copy_if(a.rebuilt.begin(), a.rebuilt.end(), std::back_inserter(rebuilt),
    [&](std::uint32_t box) { return a.boxes.isCore(a.boxes.packed[box]); });
  return rebuilt;
}

std::vector<std::uint32_t> flawedBoxes(const Assembly& a)
{
  std::vector<std::uint32_t> flawed;
  for (std::size_t n = 0; n < a.wall.flawed.size(); ++n)
  {
    if (a.wall.flawed[n] && a.boxes.isCore(a.boxes.packed[a.sides.polyhedral[n]]))
    {
      flawed.push_back(a.sides.polyhedral[n]);
    }
  }
  return flawed;
}

}

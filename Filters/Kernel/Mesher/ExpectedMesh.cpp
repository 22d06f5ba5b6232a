// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/ExpectedMesh.h"

#include "Base/Error.h"
#include "Boxes/IntersectedBoxes.h"
#include "Mesher/Mesher.h"
#include "Surface/SizeEstimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <utility>

namespace cartesian
{

namespace
{

// Boxes that a layer of transition adds for each that the surface would pass through at its level: 3.8 around a sphere,
// 4.8 around a motorbike.
constexpr double OfTransitionLayer = 4;

constexpr std::array<double, 4> BoxesAlongLongest = { 25, 50, 100, 200 };

// Significant digits of those sizes.
constexpr int DigitsOfSizes = 3;

// More boxes than these take seconds: their number is estimated from areas.
constexpr double MostLookedAt = 2e6;

// As many take about a second to make.
constexpr double MostMade = 5e5;

// Of the boxes that refinement adds by the estimate of memory, which is on the safe side: measured from 0.5 to 0.9.
constexpr double OfAddedBoxes = 0.7;

// That many halvings for sizes are always looked at. A level has at most so many times the boxes of the one before, as
// it is at surfaces.
constexpr int FirstDepthLookedAt = 4;
constexpr double MostGrowth = 4;

// For each box that the surface passes through: small cells that are merged, and the cells of a layer at the wall. Measured
// on five surfaces: 0.3 to 0.5, and 0.8 to 1.25.
constexpr double CellsMerged = 0.35;
constexpr double CellsOfALayer = 0.95;

// The double next to these digits, which is shown without others.
double rounded(double value)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.*e", DigitsOfSizes - 1, std::max(0.0, value));
  return std::strtod(text.data(), nullptr);
}

struct Counts
{
  double all = 0;
  double intersected = 0;
  double atLayers = 0; // those of the intersected where the wall has layers
};

// Known without a grid: areas of the surface, and of each boundary.
class Areas
{
public:
  Areas(const SurfaceView& view, const Options& options)
    : meshed_(meshedSize(view, options.domain))
  {
    std::map<std::int32_t, int> depths;
    for (const BoundaryRefinement& row : options.refinement.boundaries)
    {
      int& depth = depths[row.boundary];
      depth = std::max(depth, row.depth);
    }
    for (const auto& [boundary, shadows] : shadowsOfBoundaries(view))
    {
      const auto own = depths.find(boundary);
      boundaries_.push_back({ shadows, own == depths.end() ? 0 : own->second,
        options.layers.any() && options.layers.hasLayers(boundary) });
    }
  }

  double longest() const { return meshed_.longest; }

  // With the depths of boundaries, but without blocks, regions and sizes.
  Counts boxes(const GridSpec& grid, int depth, int transitionLayers) const
  {
    std::array<double, 3> box;
    for (std::size_t axis = 0; axis < box.size(); ++axis)
    {
      const std::vector<double>& lines = grid.meshlines[axis];
      box[axis] = lines.size() > 1
        ? (lines.back() - lines.front()) / static_cast<double>(lines.size() - 1)
        : grid.cellSize;
    }
    Counts boxes;
    for (const Boundary& part : boundaries_)
    {
      const int own = std::max(depth, part.depth);
      const double intersected = expectedIntersected(part.shadows, box, own);
      boxes.intersected += intersected;
      boxes.atLayers += part.hasLayers ? intersected : 0;
      boxes.all += expectedBoxesAlong(part.shadows, box, own);
      for (int level = 1; level <= own; ++level)
      {
        boxes.all += OfTransitionLayer * (transitionLayers - 1) *
          expectedIntersected(part.shadows, box, level);
      }
    }
    boxes.all += expectedInside(meshed_, box);
    return boxes;
  }

private:
  struct Boundary
  {
    Shadows shadows;
    int depth;
    bool hasLayers;
  };

  // The meshed space, as if it were inside.
  static SurfaceSize meshedSize(const SurfaceView& view, const DomainSpec& domain)
  {
    SurfaceSize size = sizeOf(view);
    if (domain.isOutside())
    {
      const Bounds box = boxAround(domain, boundsOf(view));
      double volume = 1;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        volume *= box.high[axis] - box.low[axis];
      }
      size.volume = std::max(0.0, volume - size.volume);
      size.longest = box.longest();
    }
    return size;
  }

  SurfaceSize meshed_;
  std::vector<Boundary> boundaries_;
};

// Whether it matters where boxes are. `cellSize`: of the largest, beside which layers are the flattest.
bool asksForPlaces(const RefinementSpec& spec, double cellSize)
{
  return !spec.blocks.empty() || !spec.regions.empty() || spec.sizing.asksEverywhere() ||
    (spec.sizing.halvingsAtLayers > 0 && isFlat(spec.sizing.layers, cellSize)) ||
    std::any_of(spec.boundaries.begin(), spec.boundaries.end(),
      [](const BoundaryRefinement& row) { return row.blendLayers > 0; });
}

// From every global box of a grid.
Counts boxesOfGrid(
  const PreparedSurface& prepared, const Options& options, int depthOfSizes, Execution& execution)
{
  Options limited = options;
  SizingSpec& sizing = limited.refinement.sizing;
  sizing.largestDepth = std::min(sizing.largestDepth, depthOfSizes);
  sizing.featureDepth = std::min(sizing.featureDepth, depthOfSizes);
  const auto decomposition = decompose(prepared, limited, execution);
  const MeshEstimate all =
    decomposition->together(decomposition->estimateLayers(execution), decomposition->allLayers());
  Counts counts;
  if (OfAddedBoxes * all.boxes() < MostMade)
  {
    const Boxes boxes = decomposition->boxes(decomposition->allLayers(), execution);
    counts.all = static_cast<double>(boxes.packed.size());
    counts.intersected = countIntersected(boxes);
  }
  else
  {
    counts.all = OfAddedBoxes * all.boxes();
    counts.intersected = OfAddedBoxes * all.intersected;
  }
  return counts;
}

// Where sizes ask for deep boxes, they are only searched for as deeply as there are not too many; each level beyond
// grows as the last one did.
Counts boxesOfGrid(const SurfaceView& surface, const Options& options, Execution& execution)
{
  PreparedSurface prepared = prepareSurface(surface, options, execution);
  prepared.memoryLimit.bytes = std::numeric_limits<double>::infinity(); // boxes alone take little
  const int deepest = options.refinement.sizing.deepest();
  int depth = std::min(deepest, FirstDepthLookedAt);
  Counts boxes = boxesOfGrid(prepared, options, depth, execution);
  Counts before = boxes;
  double growth = MostGrowth;
  for (; depth < deepest && boxes.all < MostLookedAt && growth > 1; ++depth)
  {
    before = std::exchange(boxes, boxesOfGrid(prepared, options, depth + 1, execution));
    growth = std::clamp(boxes.all / std::max(1.0, before.all), 1., MostGrowth);
  }
  const double beyond = std::pow(growth, deepest - depth);
  return { boxes.all * beyond, boxes.intersected * beyond };
}

// Of options that say how large boxes are.
ExpectedMesh expected(
  const Areas& areas, const SurfaceView& surface, const Options& options, Execution& execution)
{
  Counts boxes = areas.boxes(options.grid, options.refinement.depth, transitionLayersOf(options));
  if (asksForPlaces(refinementOf(options, boundsOf(surface).longest()), options.grid.cellSize) &&
    boxes.all < MostLookedAt)
  {
    const Counts looked = boxesOfGrid(surface, options, execution);
    boxes.atLayers *= looked.intersected / std::max(1.0, boxes.intersected);
    boxes.intersected = looked.intersected;
    boxes.all = looked.all;
  }
  const WallLayerSpec layers = expectedLayers(options, boundsOf(surface)).spec;
  ExpectedMesh mesh;
  mesh.size = options.grid.cellSize;
  mesh.boxes = std::max(1.0, std::round(boxes.all));
  const bool merges = options.smallCells.handling == SmallCells::Merge;
  mesh.cells = std::max(1.0,
    std::round(boxes.all - (merges ? CellsMerged : 0) * boxes.intersected +
      layers.count * CellsOfALayer * boxes.atLayers));
  const MeshEstimate estimate =
    estimateOf(mesh.boxes, boxes.intersected, static_cast<double>(surface.triangleCount));
  mesh.bytes = estimate.bytes(memoryLimitOf(options, execution.threads()));
  return mesh;
}

// The shortest mean distance of planes.
double sizeOfBoxes(const Options& options, const Bounds& surface)
{
  const double usual = options.grid.cellSize > 0
    ? options.grid.cellSize
    : (options.domain.isOutside() ? boxAround(options.domain, surface) : surface).longest() /
      DefaultCellsAlongLongest;
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& lines : options.grid.meshlines)
  {
    const double size = lines.size() > 1
      ? (lines.back() - lines.front()) / static_cast<double>(lines.size() - 1)
      : usual;
    least = std::min(least, size);
  }
  return least;
}

double sizeOrDefault(const Options& options, const Areas& areas)
{
  return options.grid.cellSize > 0 ? options.grid.cellSize
                                   : rounded(areas.longest() / DefaultCellsAlongLongest);
}

}

ExpectedLayers expectedLayers(const Options& options, const Bounds& surface)
{
  int depth = options.refinement.depth;
  for (const BoundaryRefinement& row : options.refinement.boundaries)
  {
    depth = std::max(depth, row.depth);
  }
  const double box = std::ldexp(sizeOfBoxes(options, surface), -depth);
  return { withNumber(forFlow(options.layers, surface.longest()), box), box };
}

ExpectedMesh expectedMesh(const SurfaceView& surface, const Options& options, Execution& execution)
{
  const Areas areas(surface, options);
  Options asked = options;
  asked.grid.cellSize = sizeOrDefault(options, areas);
  return expected(areas, surface, asked, execution);
}

std::vector<ExpectedRow> expectedRows(
  const SurfaceView& surface, const Options& options, Execution& execution)
{
  const Areas areas(surface, options);
  const double own = sizeOrDefault(options, areas);
  std::map<double, bool, std::greater<>> sizes{ { own, true } };
  for (const double along : BoxesAlongLongest)
  {
    sizes.emplace(rounded(areas.longest() / along), false);
  }
  std::vector<ExpectedRow> rows;
  Options asked = options;
  for (const auto& [size, isAsked] : sizes)
  {
    asked.grid.cellSize = size;
    rows.push_back({ expected(areas, surface, asked, execution), isAsked });
  }
  return rows;
}

}

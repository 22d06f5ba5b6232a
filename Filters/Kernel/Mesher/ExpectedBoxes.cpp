// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/ExpectedBoxes.h"

#include "Base/Error.h"
#include "Mesher/Mesher.h"
#include "Surface/SizeEstimate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

namespace cartesian
{

namespace
{

constexpr std::array<double, 4> BoxesAlongLongest = { 25, 50, 100, 200 };

// Significant digits.
constexpr int DigitsOfSizes = 3;
constexpr int DigitsOfNumbers = 2;

// More boxes than these take seconds to look at: only areas tell how many there are.
constexpr double MostLookedAt = 2e6;

// What asks for sizes is looked for in about so many layers of the grid.
constexpr std::size_t LayersLookedFor = 6;

// Of the boxes that refinement adds by the estimate of memory, which is on the safe side: measured from 0.6 to 0.9.
constexpr double OfAddedBoxes = 0.7;

// The double next to these digits, which is shown without others.
double rounded(double value, int digits)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.*e", digits - 1, std::max(0.0, value));
  return std::strtod(text.data(), nullptr);
}

// What is known without a grid: areas of the surface, and of each boundary.
class Areas
{
public:
  Areas(const SurfaceView& view, const Options& options)
    : meshed_(meshedSize(view, options.domain))
  {
    for (const BoundaryRefinement& row : options.refinement.boundaries)
    {
      int& depth = depths_[row.boundary];
      depth = std::max(depth, row.depth);
      ofBoundary_.emplace(row.boundary, SurfaceSize{});
    }
    for (auto& [boundary, size] : ofBoundary_)
    {
      size = sizeOfBoundary(view, boundary);
    }
  }

  double longest() const { return meshed_.longest; }

  // With the depths of boundaries, but without blocks, regions and sizes.
  double boxes(const GridSpec& grid, int depth) const
  {
    std::array<double, 3> box;
    for (std::size_t axis = 0; axis < box.size(); ++axis)
    {
      const std::vector<double>& lines = grid.meshlines[axis];
      box[axis] = lines.size() > 1
        ? (lines.back() - lines.front()) / static_cast<double>(lines.size() - 1)
        : grid.cellSize;
    }
    double boxes = expectedBoxes(meshed_, box, depth);
    for (const auto& [boundary, own] : depths_)
    {
      const SurfaceSize& part = ofBoundary_.at(boundary);
      boxes += own > depth ? expectedBoxes(part, box, own) - expectedBoxes(part, box, depth) : 0;
    }
    return boxes;
  }

private:
  // What is meshed, as if it were inside.
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

  static SurfaceSize sizeOfBoundary(const SurfaceView& view, std::int32_t boundary)
  {
    std::vector<std::uint32_t> corners;
    for (std::size_t t = 0; t < view.triangleCount; ++t)
    {
      if ((view.boundary ? view.boundary[t] : 0) == boundary)
      {
        corners.insert(corners.end(), view.triangles + 3 * t, view.triangles + 3 * t + 3);
      }
    }
    if (corners.empty())
    {
      return {};
    }
    SurfaceSize size = sizeOf({ view.points, view.pointCount, corners.data(), corners.size() / 3 });
    size.volume = 0; // of no closed surface
    return size;
  }

  SurfaceSize meshed_;
  std::map<std::int32_t, int> depths_;
  std::map<std::int32_t, SurfaceSize> ofBoundary_;
};

// Whether it matters where boxes are.
bool asksForPlaces(const RefinementSpec& spec)
{
  return !spec.blocks.empty() || !spec.regions.empty() || spec.sizing.any() ||
    std::any_of(spec.boundaries.begin(), spec.boundaries.end(),
      [](const BoundaryRefinement& row) { return row.blendLayers > 0; });
}

// A grid of which each global box is looked at; where sizes are asked for, in some layers.
class Grid
{
public:
  Grid(const SurfaceView& surface, Options options, Execution& execution)
    : prepared_(prepareSurface(surface, options, execution))
    , execution_(execution)
  {
    SizingSpec sizing = std::exchange(options.refinement.sizing, {});
    withoutSizes_ = decompose(prepared_, options, execution);
    if (sizing.any())
    {
      const std::size_t layers = withoutSizes_->allLayers().end;
      sizing.everyLayer = every_ = (layers + LayersLookedFor - 1) / LayersLookedFor;
      options.refinement.sizing = std::move(sizing);
      withSizes_ = decompose(prepared_, options, execution);
    }
  }

  double boxes(int depth)
  {
    withoutSizes_->setDepth(depth);
    const std::vector<MeshEstimate> without = withoutSizes_->estimateLayers(execution_);
    double boxes = withoutSizes_->together(without, withoutSizes_->allLayers()).boxes();
    if (withSizes_)
    {
      withSizes_->setDepth(depth);
      const std::vector<MeshEstimate> with = withSizes_->estimateLayers(execution_);
      for (std::size_t k = every_ / 2; k < with.size(); k += every_)
      {
        boxes += (with[k].boxes() - without[k].boxes()) * static_cast<double>(every_);
      }
    }
    return boxes;
  }

private:
  PreparedSurface prepared_;
  Execution& execution_;
  std::unique_ptr<Decomposition> withoutSizes_;
  std::unique_ptr<Decomposition> withSizes_;
  std::size_t every_ = 1;
};

// Of a grid, at several depths along the surface, the least first.
std::vector<double> boxesAt(const Areas& areas, const SurfaceView& surface, Options options,
  const std::vector<int>& depths, Execution& execution)
{
  const bool needsGrid = asksForPlaces(options.refinement);
  options.refinement.depth = depths[0];
  std::unique_ptr<Grid> grid;
  double added = 0;
  std::vector<double> result;
  for (const int depth : depths)
  {
    const double boxes = areas.boxes(options.grid, depth);
    if (needsGrid && boxes < MostLookedAt)
    {
      grid = grid ? std::move(grid) : std::make_unique<Grid>(surface, options, execution);
      added = OfAddedBoxes * std::max(0.0, grid->boxes(depth) - boxes);
    }
    result.push_back(boxes + added);
  }
  return result;
}

double sizeOrDefault(const Options& options, const Areas& areas)
{
  return options.grid.cellSize > 0
    ? options.grid.cellSize
    : rounded(areas.longest() / DefaultCellsAlongLongest, DigitsOfSizes);
}

}

double expectedBoxes(const SurfaceView& surface, const Options& options, Execution& execution)
{
  const Areas areas(surface, options);
  Options asked = options;
  asked.grid.cellSize = sizeOrDefault(options, areas);
  return boxesAt(areas, surface, asked, { options.refinement.depth }, execution)[0];
}

std::array<ExpectedRow, 5> expectedRows(
  const SurfaceView& surface, const Options& options, Execution& execution)
{
  const Areas areas(surface, options);
  std::array<ExpectedRow, 5> rows;
  rows[0].size = sizeOrDefault(options, areas);
  for (std::size_t i = 0; i < BoxesAlongLongest.size(); ++i)
  {
    rows[i + 1].size = rounded(areas.longest() / BoxesAlongLongest[i], DigitsOfSizes);
  }
  Options asked = options;
  for (ExpectedRow& row : rows)
  {
    asked.grid.cellSize = row.size;
    const std::vector<double> boxes = boxesAt(areas, surface, asked, { 0, 1, 2 }, execution);
    std::transform(boxes.begin(), boxes.end(), row.boxes.begin(),
      [](double number) { return rounded(std::max(1.0, std::round(number)), DigitsOfNumbers); });
  }
  return rows;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/Options.h"

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace cartesian
{

namespace
{

constexpr double BytesOfAGiB = 1024.0 * 1024.0 * 1024.0;

// Of the machine's memory, where the user sets no limit.
constexpr double ShareOfMemory = 0.75;

double machineMemory()
{
#ifdef _SC_PHYS_PAGES
  const auto pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
  const auto bytesOfAPage = static_cast<double>(sysconf(_SC_PAGESIZE));
  if (pages > 0 && bytesOfAPage > 0)
  {
    return pages * bytesOfAPage;
  }
#endif
  return std::numeric_limits<double>::infinity();
}

}

MemoryLimit memoryLimitOf(const Options& options, int threads)
{
  const double bytes =
    options.memoryLimit > 0 ? options.memoryLimit * BytesOfAGiB : ShareOfMemory * machineMemory();
  return { bytes, options.patches.method == PatchMethod::ExactFit, editsWall(options),
    options.layers.any() ? 1 : 0, threads };
}

int transitionLayersOf(const Options& options)
{
  constexpr int Outside = 3;
  const int asked = options.refinement.transitionLayers;
  return asked > 0 ? asked : (options.domain.isOutside() ? Outside : 1);
}

bool shapesCells(const Options& options)
{
  return options.smallCells.handling == SmallCells::Merge || options.shaping.splitConcave;
}

bool editsWall(const Options& options)
{
  return shapesCells(options) || options.collapse.ratio > 0;
}

bool keepsTrueVolume(const Options& options)
{
  return options.shaping.trueVolume && shapesCells(options) &&
    options.patches.method == PatchMethod::Automatic;
}

void requireValidCells(const Options& options)
{
  requireInRange(SmallCellSpec::Ratios, options.smallCells.ratio, "Small Cell Ratio");
  for (const BoundaryRatio& own : options.smallCells.boundaryRatios)
  {
    requireInRange(SmallCellSpec::Ratios, own.ratio,
      "Small Cell Ratio of boundary " + std::to_string(own.boundary));
  }
  requireInRange(CellShapeSpec::MergeRatios, options.shaping.mergeRatio, "Merge Ratio");
  requireInRange(
    CellShapeSpec::RefusedCellRatios, options.shaping.refusedCellRatio, "Refused Cell Ratio");
  requireInRange(ShortEdgeSpec::Ratios, options.collapse.ratio, "Collapse Ratio");
}

}

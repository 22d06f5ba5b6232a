// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/WallLayerSpec.h"

#include "Surface/Surface.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Of all layers, as a part of the box beside them: thicker ones end in more places (measured on CAD and scans).
constexpr double ThicknessByBox = 1.0 / 3;

// Of all layers, where the first is 1.
std::vector<double> sumsOfSeries(const WallLayerSpec& spec)
{
  std::vector<double> sums{ 0 };
  double layer = 1;
  for (int i = 0; i < spec.count; ++i)
  {
    sums.push_back(sums.back() + layer);
    layer *= spec.ratio;
  }
  return sums;
}

}

double WallLayerSpec::thicknessAt(std::int32_t boundary, double usual) const
{
  if (boundary == NoBoundary)
  {
    return 0;
  }
  const auto own = std::find_if(boundaries.begin(), boundaries.end(),
    [&](const OfBoundary& one) { return one.boundary == boundary; });
  return own == boundaries.end() ? usual : own->thickness;
}

bool WallLayerSpec::isIn(std::int32_t region) const
{
  return regions.empty() || std::find(regions.begin(), regions.end(), region) != regions.end();
}

void requireValid(const WallLayerSpec& spec)
{
  requireInRange(WallLayerSpec::Counts, spec.count, "Layers");
  requireInRange(WallLayerSpec::Ratios, spec.ratio, "Layer Expansion Ratio");
  requireInRange(WallLayerSpec::Thicknesses, spec.firstThickness, "First Layer Thickness");
  requireInRange(WallLayerSpec::Thicknesses, spec.thickness, "Layers Thickness");
  for (const WallLayerSpec::OfBoundary& one : spec.boundaries)
  {
    requireInRange(WallLayerSpec::Thicknesses, one.thickness, "Boundary Layers Thickness");
  }
}

double totalThickness(const WallLayerSpec& spec, double box)
{
  const std::vector<double> sums = sumsOfSeries(spec);
  if (spec.firstThickness > 0)
  {
    return spec.firstThickness * sums.back();
  }
  if (spec.thickness > 0)
  {
    return spec.thickness;
  }
  return ThicknessByBox * box;
}

std::vector<double> heightsOfLayers(const WallLayerSpec& spec)
{
  std::vector<double> heights = sumsOfSeries(spec);
  const double total = heights.back();
  for (double& height : heights)
  {
    height /= total;
  }
  return heights;
}

}

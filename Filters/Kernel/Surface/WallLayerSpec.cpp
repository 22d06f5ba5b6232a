// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/WallLayerSpec.h"

#include "Surface/Surface.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// Of all layers, as a part of the box beside them: thicker ones end in more places (measured on CAD and scans).
constexpr double ThicknessByBox = 1.0 / 3;

constexpr double FlatByBox = 0.03; // height of a first layer

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

bool hasLayersOn(const WallLayerSpec& spec, const Walls& walls, std::int32_t wall)
{
  return (spec.isIn(walls.behind(wall)) && spec.hasLayers(walls.boundary(wall))) ||
    (walls.isInterface(wall) && spec.isIn(walls.front(wall)) &&
      spec.hasLayers(walls.boundaryInFront(wall)));
}

void requireValid(const WallLayerSpec& spec)
{
  requireInRange(WallLayerSpec::Counts, spec.count, "Layers");
  requireInRange(WallLayerSpec::Ratios, spec.ratio, "Layer Expansion Ratio");
  requireInRange(WallLayerSpec::LastLayers, spec.lastByBox, "Last Layer");
  requireInRange(WallLayerSpec::Thicknesses, spec.firstThickness, "First Layer Thickness");
  requireInRange(WallLayerSpec::Thicknesses, spec.thickness, "Layers Thickness");
  for (const WallLayerSpec::OfBoundary& one : spec.boundaries)
  {
    requireInRange(WallLayerSpec::Thicknesses, one.thickness, "Boundary Layers Thickness");
  }
  requireValid(spec.flow);
  if (spec.count == WallLayerSpec::Automatic &&
    ((spec.firstThickness == 0 && spec.flow.targetYPlus == 0) || spec.ratio == 1))
  {
    throw Error(Fault::BadParameter,
      "An automatic number of Layers leads from First Layer Thickness to Last Layer at the Layer "
      "Expansion Ratio: set "
      "First Layer Thickness or Target Y Plus, and a ratio above 1; or give the number of Layers.");
  }
}

WallLayerSpec forFlow(WallLayerSpec spec, double longestSide)
{
  if (spec.flow.targetYPlus > 0 && spec.firstThickness == 0 && spec.thickness == 0)
  {
    spec.firstThickness = firstThicknessFor(spec.flow, longestSide);
  }
  return spec;
}

int layersTo(const WallLayerSpec& spec, double box)
{
  constexpr double Rounding = 1e-9;
  const double first = spec.firstThickness > 0
    ? spec.firstThickness
    : totalThickness(spec, box) * heightsOfLayers(spec)[1];
  const double times = spec.lastByBox * box / first;
  return spec.ratio <= 1 || times <= 1
    ? 1
    : 1 + static_cast<int>(std::floor(std::log(times) / std::log(spec.ratio) + Rounding));
}

WallLayerSpec withNumber(WallLayerSpec spec, double box)
{
  if (spec.count == WallLayerSpec::Automatic)
  {
    spec.count = std::min(layersTo(spec, box), WallLayerSpec::MostLayers);
  }
  return spec;
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

bool isFlat(double first, double box)
{
  return first < FlatByBox * box;
}

bool isFlat(const WallLayerSpec& spec, double box)
{
  return isFlat(totalThickness(spec, box) * heightsOfLayers(spec)[1], box);
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

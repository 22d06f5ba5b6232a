// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/Slabs.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace cartesian
{

namespace
{

// Distances in layers from a border of the first stage: how far the first stage does not act, the
// second may change cells and sees them, and what the first stage keeps fixed. Enough that slabs
// cause no faults themselves.
constexpr std::uint32_t Acting = 2;
constexpr std::uint32_t Free = 3;
constexpr std::uint32_t Moving = 2; // in the second stage; most nodes there have moved in the first
constexpr std::uint32_t Seen = 4;
constexpr std::uint32_t Fixed = 1;

Layers hullOf(Layers a, Layers b)
{
  if (a.begin == a.end || b.begin == b.end)
  {
    return a.begin == a.end ? b : a;
  }
  return { std::min(a.begin, b.begin), std::max(a.end, b.end) };
}

// A fragment beside a part, what is beyond it, and what that depends on; but none extends across a divide.
constexpr std::uint32_t HaloOfFragments = HaloOfShapedCells + MostLayersOfAFragment + 1;

// The nearest divide at or above a plane.
std::uint32_t divideAbove(std::uint32_t plane)
{
  const std::uint32_t beyond = plane + DivideDistance - FirstDivide;
  return (beyond + DivideDistance - 1) / DivideDistance * DivideDistance -
    (DivideDistance - FirstDivide);
}

bool meet(Layers a, Layers b)
{
  return a.begin < b.end && b.begin < a.end;
}

// Without `by` layers at each end, except where the grid ends.
Layers shrunk(Layers layers, std::uint32_t by, std::uint32_t all)
{
  const std::uint32_t begin = layers.begin == 0 ? 0 : std::min(layers.begin + by, layers.end);
  const std::uint32_t end = layers.end == all ? all : layers.end - std::min(by, layers.end);
  return { begin, std::max(begin, end) };
}

// The i-th slab of the first stage.
Slab firstSlab(std::uint32_t i, std::uint32_t all)
{
  const Layers layers{ i * SlabThickness, std::min((i + 1) * SlabThickness, all) };
  const Layers free = shrunk(layers, Fixed, all);
  return { layers, free, shrunk(layers, Acting, all), free };
}

// The slab of the second stage across the lower border of the i-th one.
Slab secondSlab(std::uint32_t i, std::uint32_t all)
{
  const std::uint32_t border = i * SlabThickness;
  const auto around = [&](std::uint32_t by) {
    return Layers{ border - by, std::min(border + by, all) };
  };
  return { around(Seen), around(Free), around(Free), around(Moving) };
}

}

bool straddlesStages(Layers layers, std::uint32_t all)
{
  for (std::uint32_t plane = layers.begin + 1; all > SlabThickness && plane < layers.end; ++plane)
  {
    const std::uint32_t fromReach = (plane + Free) % SlabThickness;
    if (fromReach == 0 || fromReach == 2 * Free)
    {
      return true;
    }
  }
  return false;
}

bool isBesideDivide(std::uint32_t layer, std::uint32_t allLayers)
{
  return allLayers > SlabThickness &&
    (layer % DivideDistance == FirstDivide || (layer + 1) % DivideDistance == FirstDivide);
}

Layers layersOfShapedCells(Layers core, std::uint32_t allLayers)
{
  if (core.begin == core.end || allLayers <= SlabThickness)
  {
    return core.begin == core.end ? core : Layers{ 0, allLayers };
  }
  const auto less = [](std::uint32_t plane, std::uint32_t by) {
    return plane - std::min(plane, by);
  };
  const std::uint32_t above = divideAbove(core.end);
  const std::uint32_t below =
    core.begin < FirstDivide ? 0 : divideAbove(core.begin + 1) - DivideDistance;
  return { std::max(less(core.begin, HaloOfFragments), less(below, HaloOfShapedCells)),
    std::min({ core.end + HaloOfFragments, above + HaloOfShapedCells, allLayers }) };
}

std::array<std::vector<Slab>, ShapingStages> slabsFor(Layers wanted, std::uint32_t all)
{
  std::array<std::vector<Slab>, ShapingStages> slabs;
  const std::uint32_t count = (all + SlabThickness - 1) / SlabThickness;
  Layers first = wanted;
  for (std::uint32_t i = 1; i < count; ++i)
  {
    if (const Slab slab = secondSlab(i, all); meet(slab.free, wanted))
    {
      slabs[1].push_back(slab);
      first = hullOf(first, slab.layers);
    }
  }
  for (std::uint32_t i = 0; i < count; ++i)
  {
    if (const Slab slab = firstSlab(i, all); meet(slab.layers, first))
    {
      slabs[0].push_back(slab);
    }
  }
  return slabs;
}

double mostAtOnce(const std::vector<double>& ofLayers, Layers layers, int threads)
{
  std::vector<double> ofSlabs(layers.end / SlabThickness + 1);
  for (std::uint32_t k = layers.begin; k < layers.end; ++k)
  {
    ofSlabs[k / SlabThickness] += ofLayers[k];
  }
  std::sort(ofSlabs.begin(), ofSlabs.end(), std::greater<>());
  const auto count = std::min(ofSlabs.size(), static_cast<std::size_t>(threads));
  return std::accumulate(ofSlabs.begin(), ofSlabs.begin() + std::ptrdiff_t(count), 0.0);
}

double shareAtOnce(double layers, int threads)
{
  return std::min(1., double(SlabThickness) * threads / layers);
}

Layers layersForShaping(Layers wanted, std::uint32_t all)
{
  Layers from = wanted;
  for (const std::vector<Slab>& slabs : slabsFor(wanted, all))
  {
    for (const Slab& slab : slabs)
    {
      from = hullOf(from, slab.layers);
    }
  }
  return from;
}

Layers layersForCollapse(Layers wanted, std::uint32_t all)
{
  if (wanted.begin == wanted.end || all <= SlabThickness)
  {
    return wanted.begin == wanted.end ? wanted : Layers{ 0, all };
  }
  // For layers on either side of a seam, the slabs on both sides. Slab 1 begins at the first seam.
  const auto slabOf = [](std::uint32_t layer) {
    return (layer + SeamDistance - FirstSeam) / SeamDistance;
  };
  const auto seamBelow = [](std::uint32_t slab) {
    return slab == 0 ? 0 : slab * SeamDistance - (SeamDistance - FirstSeam);
  };
  const std::uint32_t below = wanted.begin - std::min(wanted.begin, 1u);
  return { seamBelow(slabOf(below)), std::min(seamBelow(slabOf(wanted.end) + 1), all) };
}

Layers layersForCells(Layers core, const LaterSteps& steps, std::uint32_t all)
{
  if (steps.editsInPlace)
  {
    return { 0, all };
  }
  Layers layers = steps.shapes ? layersOfShapedCells(core, all) : core.grown(HaloOfCells, all);
  if (steps.shapes)
  {
    layers = layersForShaping(layers, all).grown(HaloOfCells, all);
  }
  layers = steps.standsOff ? layers.grown(HaloOfStandOff, all) : layers;
  return steps.collapses ? layersForCollapse(layers, all) : layers;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/Decomposition.h"

namespace cartesian
{

namespace
{

// Layers of global boxes around a part on which its cells depend, directly or not. Up to where
// cells are cut, that is layersForCells() (Halos.h). Before that, in three rounds, flawed boxes
// change their neighbours and are flawed by them (BoxRebuilding.h); faces towards the next layer
// depend on its surface, and on how each box there is patched; and where boxes are divided, on the
// split lines of the layer after that.
constexpr std::uint32_t HaloOfRebuilding = 4 * 2;
constexpr std::uint32_t HaloOfUndivided = HaloOfRebuilding + 1;
constexpr std::uint32_t HaloOfDivided = HaloOfUndivided + 1;

// The layers that a part needs of the balanced boxes; balancing takes balanceReach() more.
SlabRange layersFor(
  SlabRange core, bool editsWall, const Refinement& refinement, std::uint32_t allLayers)
{
  return layersForCells(core, editsWall, allLayers)
    .grown(refinement.any() ? HaloOfDivided : HaloOfUndivided, allLayers);
}

// The time for an intersected box relative to one inside (see Testing/Benchmark).
constexpr double WorkOfAnIntersectedBox = 30;

double workOf(const MeshEstimate& estimate)
{
  return estimate.inside + WorkOfAnIntersectedBox * estimate.intersected;
}

}

Decomposition::Decomposition(const Surface& surface, const Meshlines& planes,
  const RefinementSpec& spec, const MemoryLimit& limit, bool editsWall, Execution& execution)
  : surface_(surface)
  , planes_(planes)
  , limit_(limit)
  , editsWall_(editsWall)
  , shoeboxes_(fillShoeboxes(surface, planes, execution))
  , refinement_(spec, surface, shoeboxes_, planes, execution)
  , statuses_(surface, planes, shoeboxes_, execution)
{
}

void Decomposition::relax(double factor, Execution& execution)
{
  if (factor != relaxation_)
  {
    refinement_.relax(factor, surface_, shoeboxes_, planes_, execution);
    relaxation_ = factor;
  }
}

Boxes Decomposition::boxes(SlabRange core, Execution& execution) const
{
  const SlabRange kept = layersFor(core, editsWall_, refinement_, allLayers().end);
  if (refinement_.any())
  {
    checkMemory(together(estimateLayers(execution), kept), limit_);
  }
  return generateBoxes(
    surface_, planes_, shoeboxes_, refinement_, statuses_, core, kept, execution);
}

std::size_t Decomposition::boxesAddedForLayers(std::size_t all, Execution& execution) const
{
  return refinement_.refinesForLayers() ? all -
      generateBoxes(surface_, planes_, shoeboxes_, refinement_.withoutBendsAtLayers(), statuses_,
        allLayers(), allLayers(), execution)
        .packed.size()
                                        : 0;
}

std::vector<MeshEstimate> Decomposition::estimateLayers(Execution& execution) const
{
  const bool any = refinement_.any();
  const std::vector<float> areas =
    any ? areasInBoxes(surface_, planes_, shoeboxes_) : std::vector<float>();
  std::vector<MeshEstimate> layers(allLayers().end);
  execution.forEach(layers.size(), 1, [&](std::size_t begin, std::size_t) {
    const auto k = static_cast<std::uint32_t>(begin);
    MeshEstimate& sum = layers[k];
    const std::size_t firstRow = begin * (planes_[1].size() - 1);
    for (std::uint32_t j = 0; j + 1 < planes_[1].size(); ++j)
    {
      statuses_.forEachBox(j, k, [&](std::uint32_t i, BoxStatus status) {
        const Depths depths = any ? refinement_.at(i, j, k) : Depths();
        const std::vector<TouchedPart> touched =
          depths.touched > 0 ? refinement_.touchedParts(i, j, k) : std::vector<TouchedPart>();
        sum.add(estimateBox(status, depths, touched, refinement_.transitionLayers(),
          shoeboxes_.triangles(firstRow + j, i), areas));
      });
    }
  });
  return layers;
}

MeshEstimate Decomposition::together(
  const std::vector<MeshEstimate>& ofLayers, SlabRange layers) const
{
  MeshEstimate sum;
  for (std::uint32_t k = layers.begin; k < layers.end; ++k)
  {
    sum.add(ofLayers[k]);
  }
  sum.triangles = static_cast<double>(surface_.triangles.size());
  return sum;
}

std::vector<SlabRange> Decomposition::split(
  const std::vector<MeshEstimate>& layers, std::size_t count) const
{
  const auto end = static_cast<std::uint32_t>(layers.size());
  const double all = workOf(together(layers, { 0, end }));
  std::vector<SlabRange> parts(count);
  std::uint32_t k = 0;
  double before = 0;
  for (std::size_t part = 0; part < count; ++part)
  {
    parts[part].begin = part > 0 ? parts[part - 1].end : 0;
    const double wanted = all * static_cast<double>(part + 1) / static_cast<double>(count);
    while (k < end && (part + 1 == count || before + workOf(layers[k]) / 2 < wanted))
    {
      before += workOf(layers[k++]);
    }
    parts[part].end = k;
  }
  return parts;
}

std::size_t Decomposition::partsNeeded(const std::vector<MeshEstimate>& layers) const
{
  const auto all = static_cast<std::uint32_t>(layers.size());
  for (std::size_t count = 1;; ++count)
  {
    MeshEstimate largest;
    for (const SlabRange& core : split(layers, count))
    {
      const MeshEstimate part = together(layers, layersFor(core, editsWall_, refinement_, all));
      largest = part.bytes(limit_) > largest.bytes(limit_) ? part : largest;
    }
    if (largest.bytes(limit_) <= limit_.bytes)
    {
      return count;
    }
    if (count >= all)
    {
      checkMemory(largest, limit_);
    }
  }
}

}

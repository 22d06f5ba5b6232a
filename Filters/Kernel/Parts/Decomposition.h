// SPDX-License-Identifier: BSD-3-Clause
// Decomposition of a grid into parts, and what all parts have in common.
//
// A part is a range of layers of global boxes along z, its core, that is meshed by itself: one part
// after the other if the mesh is larger than memory (7.2), or each on its own rank. All decisions
// of the mesher are local and exact, so with some layers around its core (Halos.h) a part has
// exactly the cells and points of the whole mesh, and the parts together are that mesh, bit for
// bit. Parts are layers because cells and points are numbered along z last: each part's numbers
// follow those of the part before it.
#pragma once

#include "Boxes/BoxGeneration.h"
#include "Boxes/MeshEstimate.h"
#include "Parts/Halos.h"

namespace cartesian
{

class Decomposition
{
public:
  // Borrows `surface` and `planes`. `limit`: of one part; `editsWall`: whether cells will be
  // edited. Throws Error: BadParameter (of the refinement); of a region's
  // surface EmptySurface, BadCoordinate, FlawedSurface.
  Decomposition(const Surface& surface, const Meshlines& planes, const RefinementSpec& spec,
    const MemoryLimit& limit, bool editsWall, Execution& execution);

  Decomposition(const Decomposition&) = delete;
  Decomposition& operator=(const Decomposition&) = delete;

  const Surface& surface() const { return surface_; }
  const Shoeboxes& shoeboxes() const { return shoeboxes_; }

  // Enlarges the sizes required by the surface or a field by a factor; that of the last call counts.
  void relax(double factor, Execution& execution);

  // A message about rows of the specification that extend beyond the grid, or empty.
  const std::string& warnings() const { return refinement_.warnings(); }

  SlabRange allLayers() const { return { 0, static_cast<std::uint32_t>(planes_[2].size() - 1) }; }

  // The boxes of a part and those it depends on. Throws Error: TooManyBoxes.
  Boxes boxes(SlabRange core, Execution& execution) const;

  // How many of all boxes are there because walls with layers bend in them (SizingSpec::halvingsAtLayers).
  std::size_t boxesAddedForLayers(std::size_t all, Execution& execution) const;

  // Of each layer of global boxes.
  std::vector<MeshEstimate> estimateLayers(Execution& execution) const;

  // Of a mesh or a part of one, with these layers.
  MeshEstimate together(const std::vector<MeshEstimate>& ofLayers, SlabRange layers) const;

  // The least number of parts of which none exceeds the memory limit. Throws Error: TooManyBoxes,
  // if a single layer does.
  std::size_t partsNeeded(const std::vector<MeshEstimate>& layers) const;

  // Divides the layers into `count` parts that take about equally long; some may be empty.
  std::vector<SlabRange> split(const std::vector<MeshEstimate>& layers, std::size_t count) const;

private:
  const Surface& surface_;
  const Meshlines& planes_;
  MemoryLimit limit_;
  bool editsWall_;
  Shoeboxes shoeboxes_;
  Refinement refinement_;
  double relaxation_ = 1; // of its sizes
  GlobalStatuses statuses_;
};

}

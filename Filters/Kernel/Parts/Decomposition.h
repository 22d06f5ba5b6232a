// SPDX-License-Identifier: BSD-3-Clause
// How a grid is divided: what all parts of it have in common.
//
// A part is a range of layers of global boxes along z, its core, meshed by itself: one part after the
// other where the mesh is larger than memory (7.2), or each on a rank of its own. All decisions of
// the mesher are local and exact, so with some layers around it (Slabs.h) a part has the
// cells and points of the whole mesh, and together the parts are that mesh, bit for bit. Layers, as
// cells and points are numbered along z last: each part's numbers follow the one's before it.
#pragma once

#include "Boxes/BoxGeneration.h"
#include "Parts/Slabs.h"

namespace cartesian
{

class Decomposition
{
public:
  // Borrows `surface` and `planes`. `mostBytes`: for the boxes and cells of one part; `laterSteps`: what
  // will be done to the cells. Throws Error: BadParameter (of the refinement); of a region's surface EmptySurface, BadCoordinate,
  // FlawedSurface.
  Decomposition(const Surface& surface, const Meshlines& planes, const RefinementSpec& spec,
    double mostBytes, const LaterSteps& laterSteps, Execution& execution);

  Decomposition(const Decomposition&) = delete;
  Decomposition& operator=(const Decomposition&) = delete;

  const Surface& surface() const { return surface_; }
  const Shoeboxes& shoeboxes() const { return shoeboxes_; }
  Shoeboxes takeShoeboxes() { return std::move(shoeboxes_); }

  // Rows of the specification that reach beyond the grid, in words, or nothing.
  const std::string& warnings() const { return refinement_.warnings(); }

  Layers allLayers() const { return { 0, static_cast<std::uint32_t>(planes_[2].size() - 1) }; }

  // The boxes of a part, and those that it depends on. Throws Error: TooManyBoxes.
  Boxes boxes(Layers core, Execution& execution) const;

  // Of each layer of global boxes.
  std::vector<MeshEstimate> estimateLayers(Execution& execution) const;

  // The fewest parts that take no more than the bytes allowed each. Throws Error: TooManyBoxes,
  // where a single layer takes more.
  std::size_t partsNeeded(const std::vector<MeshEstimate>& layers) const;

  // The layers of each of `count` parts that take about equally long; some may be empty. Cells that are
  // shaped divide them where that takes least around them.
  std::vector<Layers> split(const std::vector<MeshEstimate>& layers, std::size_t count) const;

private:
  const Surface& surface_;
  const Meshlines& planes_;
  double mostBytes_;
  LaterSteps laterSteps_;
  Shoeboxes shoeboxes_;
  Refinement refinement_;
  GlobalStatuses statuses_;
};

}

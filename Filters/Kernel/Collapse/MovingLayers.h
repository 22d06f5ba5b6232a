// SPDX-License-Identifier: BSD-3-Clause
// In which layers of boxes nodes may move while short edges collapse, so that what happens between two
// seams (Slabs.h) depends on nothing beyond them.
#pragma once

#include "Collapse/EdgeCollapse.h"

namespace cartesian
{

class MovingLayers
{
public:
  MovingLayers(
    const Boxes& boxes, const Sides& sides, const Nodes& nodes, const EdgeCollapseSpec& spec)
    : boxes_(boxes)
    , sides_(sides)
    , nodes_(nodes)
    , spec_(spec)
  {
  }

  // Whether the n-th polyhedral box keeps its edges.
  bool stays(std::size_t n) const { return spec_.keeps[n] || !isMoving(layerOf(n)); }

  // Whether there may be boxes next to it that do not keep their edges.
  bool isNearMoving(std::size_t n) const;

  // Whether a node lies on the plane at which the layers end that nodes move in, or is a corner of
  // hexahedra beyond it.
  bool isAtEnd(std::uint32_t node) const;

private:
  std::uint32_t layerOf(std::size_t n) const
  {
    return boxes_.globalOf(boxes_.packed[sides_.polyhedral[n]]).index[2];
  }
  bool isMoving(std::uint32_t layer) const
  {
    return !spec_.acrossSeams || isSeamPlane(layer) || isSeamPlane(layer + 1);
  }
  bool isSeamPlane(std::uint32_t plane) const;

  const Boxes& boxes_;
  const Sides& sides_;
  const Nodes& nodes_;
  const EdgeCollapseSpec& spec_;
};

}

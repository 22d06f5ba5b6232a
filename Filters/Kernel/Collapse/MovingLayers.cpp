// SPDX-License-Identifier: BSD-3-Clause
#include "Collapse/MovingLayers.h"

#include "Parts/Slabs.h"

#include <algorithm>

namespace cartesian
{

bool MovingLayers::isNearMoving(std::size_t n) const
{
  const std::uint32_t layer = layerOf(n);
  return isMoving(layer) || isMoving(layer + 1) || (layer > 0 && isMoving(layer - 1));
}

bool MovingLayers::isSeamPlane(std::uint32_t plane) const
{
  return isSeam(plane, boxes_.allLayers().end);
}

bool MovingLayers::isAtEnd(std::uint32_t node) const
{
  const bool isOfGrid = node >= nodes_.patchPoints;
  const Level z = (isOfGrid ? nodes_.grid[node - nodes_.patchPoints] : nodes_.at[node])[2];
  const std::vector<Level>& planes = boxes_.planes[2];
  const auto plane = std::lower_bound(planes.begin(), planes.end(), z);
  if (plane == planes.end() || *plane != z)
  {
    return false;
  }
  const bool onSeam = isSeamPlane(static_cast<std::uint32_t>(plane - planes.begin()));
  return spec_.acrossSeams ? isOfGrid && !onSeam : onSeam;
}

}

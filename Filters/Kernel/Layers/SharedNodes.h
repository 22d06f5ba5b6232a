// SPDX-License-Identifier: BSD-3-Clause
// Where a region with layers meets another one: what was made as if the region were alone becomes a part of the mesh.
#pragma once

#include "Layers/PrismStacks.h"

namespace cartesian
{

// Cells of a region have another point instead of the mesh's: that one stays where it was, for the regions beyond.
struct PointCopy
{
  std::int32_t region;
  Id point;
  Id copy;
};

// On interfaces the tops of stacks become the mesh's points, and the points below the stacks are new. Returns these.
std::vector<PointCopy> shareNodes(
  const OutputMesh& mesh, const LayeredWall& wall, PrismStacks& stacks, LayeredBoundary& boundary);

// Adds the stacks and boundary of another region, whose new points and cells have the same numbers.
void append(const OutputMesh& mesh, PrismStacks& stacks, const PrismStacks& more);
void append(const OutputMesh& mesh, const PrismStacks& before, LayeredBoundary& boundary,
  const LayeredBoundary& more);

}

// SPDX-License-Identifier: BSD-3-Clause
// Connected components of a surface.
#pragma once

#include "Base/DisjointSets.h"
#include "Surface/Surface.h"

namespace cartesian
{

// Sets of vertices that triangles connect.
inline DisjointSets connectedComponents(const Surface& surface)
{
  DisjointSets components(surface.vertices.size());
  for (const auto& t : surface.triangles)
  {
    components.unite(t[0], t[1]);
    components.unite(t[0], t[2]);
  }
  return components;
}

// Of each triangle: the volume that its component encloses, in cubic levels; of a cavity too it is positive.
std::vector<float> enclosedVolumes(const Surface& surface, Execution& execution);

}

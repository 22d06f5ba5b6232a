// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/Components.h"

#include "Lattice/Vector.h"

#include <cmath>

namespace cartesian
{

std::vector<float> enclosedVolumes(const Surface& surface)
{
  DisjointSets components = connectedComponents(surface);
  std::vector<double> six(surface.vertices.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const std::uint32_t first = components.find(surface.triangles[t][0]);
    const Point& base = surface.vertices[first]; // near by: nothing cancels
    const Corners c = surface.corners(t);
    six[first] += dot(minus(c[0], base), cross(minus(c[1], c[0]), minus(c[2], c[0])));
  }
  std::vector<float> volumes;
  volumes.reserve(surface.triangles.size());
  for (const auto& triangle : surface.triangles)
  {
    volumes.push_back(static_cast<float>(std::abs(six[components.find(triangle[0])]) / 6));
  }
  return volumes;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/Components.h"

#include "Base/RawVector.h"
#include "Lattice/Vector.h"

#include <cmath>

namespace cartesian
{

std::vector<float> enclosedVolumes(const Surface& surface, Execution& execution)
{
  constexpr std::size_t TrianglesAChunk = 4096;
  const std::size_t count = surface.triangles.size();
  DisjointSets components = connectedComponents(surface);
  RawVector<std::uint32_t> first(count);
  for (std::size_t t = 0; t < count; ++t)
  {
    first[t] = components.find(surface.triangles[t][0]);
  }
  RawVector<double> own(count);
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      const Point& base = surface.vertices[first[t]]; // near by: nothing cancels
      const Corners c = surface.corners(t);
      own[t] = dot(minus(c[0], base), cross(minus(c[1], c[0]), minus(c[2], c[0])));
    }
  });
  std::vector<double> six(surface.vertices.size());
  for (std::size_t t = 0; t < count; ++t)
  {
    six[first[t]] += own[t];
  }
  std::vector<float> volumes(count);
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      volumes[t] = static_cast<float>(std::abs(six[first[t]]) / 6);
    }
  });
  return volumes;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/PlanePolygons.h"

#include <algorithm>

namespace cartesian
{

std::vector<PlaneEdge> edgesOf(const PlanePolygons& polygons)
{
  std::vector<PlaneEdge> all;
  all.reserve(polygons.corners.size());
  for (std::uint32_t p = 0; p < polygons.count(); ++p)
  {
    for (std::size_t i = 0; i < polygons.size(p); ++i)
    {
      const std::uint32_t a = polygons.corner(p, i);
      const std::uint32_t b = polygons.corner(p, i + 1);
      all.push_back(
        a < b ? PlaneEdge{ a, b, { p, NoPolygon } } : PlaneEdge{ b, a, { NoPolygon, p } });
    }
  }
  std::sort(all.begin(), all.end(), [](const PlaneEdge& a, const PlaneEdge& b) {
    return std::array{ a.from, a.to, a.polygons[0] } < std::array{ b.from, b.to, b.polygons[0] };
  });
  std::size_t count = 0;
  for (const PlaneEdge& edge : all)
  {
    PlaneEdge* const last = count > 0 ? &all[count - 1] : nullptr;
    if (last && last->from == edge.from && last->to == edge.to)
    {
      last->polygons[1] = edge.polygons[1];
    }
    else
    {
      all[count++] = edge;
    }
  }
  all.resize(count);
  return all;
}

}

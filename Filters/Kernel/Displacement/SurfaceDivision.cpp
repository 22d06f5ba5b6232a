// SPDX-License-Identifier: BSD-3-Clause
#include "Displacement/SurfaceDivision.h"

#include "Lattice/Vector.h"

#include <algorithm>

namespace cartesian
{

namespace
{

using Edge = std::array<std::uint32_t, 2>; // lower vertex, higher vertex
using Triangle = std::array<std::uint32_t, 3>;

constexpr std::uint32_t NoVertex = ~0U;

Point middleOf(const Point& a, const Point& b)
{
  Point middle;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    middle[axis] = static_cast<Level>((std::uint64_t(a[axis]) + b[axis]) / 2) | 1;
  }
  return middle;
}

class Divider
{
public:
  Divider(Surface& surface, double longest)
    : surface_(surface)
    , longest_(longest)
  {
  }

  // Once; false: no edge is too long.
  bool divide()
  {
    listLongEdges();
    if (edges_.empty())
    {
      return false;
    }
    first_ = static_cast<std::uint32_t>(surface_.vertices.size());
    for (const Edge& edge : edges_)
    {
      surface_.vertices.push_back(middleOf(surface_.vertices[edge[0]], surface_.vertices[edge[1]]));
    }
    Surface parts;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    {
      const std::size_t before = parts.triangles.size();
      addParts(surface_.triangles[t], parts.triangles);
      const std::size_t count = parts.triangles.size() - before;
      repeat(surface_.boundary, t, count, parts.boundary);
      repeat(surface_.given, t, count, parts.given);
      repeat(surface_.byParity, t, count, parts.byParity);
    }
    surface_.triangles = std::move(parts.triangles);
    surface_.boundary = std::move(parts.boundary);
    surface_.given = std::move(parts.given);
    surface_.byParity = std::move(parts.byParity);
    return true;
  }

private:
  static Edge edgeOf(const Triangle& triangle, std::size_t i)
  {
    const auto [lower, higher] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
    return { lower, higher };
  }

  double lengthOf(std::uint32_t a, std::uint32_t b) const
  {
    return norm(minus(surface_.vertices[a], surface_.vertices[b]));
  }

  void listLongEdges()
  {
    edges_.clear();
    for (const Triangle& triangle : surface_.triangles)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Edge edge = edgeOf(triangle, i);
        if (lengthOf(edge[0], edge[1]) > longest_)
        {
          edges_.push_back(edge);
        }
      }
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  std::uint32_t middleOfEdge(const Triangle& triangle, std::size_t i) const
  {
    const Edge edge = edgeOf(triangle, i);
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), edge);
    return found == edges_.end() || *found != edge
      ? NoVertex
      : first_ + static_cast<std::uint32_t>(found - edges_.begin());
  }

  void addParts(const Triangle& triangle, std::vector<Triangle>& parts) const
  {
    const Triangle middle{ middleOfEdge(triangle, 0), middleOfEdge(triangle, 1),
      middleOfEdge(triangle, 2) };
    const auto divided =
      static_cast<std::size_t>(3 - std::count(middle.begin(), middle.end(), NoVertex));
    // Turned so that the edge that differs from the others is the first.
    std::size_t i = 0;
    while (divided % 3 != 0 && (middle[i] != NoVertex) != (divided == 1))
    {
      ++i;
    }
    const std::uint32_t a = triangle[i];
    const std::uint32_t b = triangle[(i + 1) % 3];
    const std::uint32_t c = triangle[(i + 2) % 3];
    const std::uint32_t ab = middle[i];
    const std::uint32_t bc = middle[(i + 1) % 3];
    const std::uint32_t ca = middle[(i + 2) % 3];
    switch (divided)
    {
      case 0:
        parts.push_back(triangle);
        break;
      case 1:
        parts.insert(parts.end(), { { a, ab, c }, { ab, b, c } });
        break;
      case 2:
        parts.push_back({ c, ca, bc });
        addQuadrangle({ a, b, bc, ca }, parts);
        break;
      default:
        parts.insert(parts.end(), { { a, ab, ca }, { ab, b, bc }, { bc, c, ca }, { ab, bc, ca } });
        break;
    }
  }

  // By its shorter diagonal.
  void addQuadrangle(const std::array<std::uint32_t, 4>& q, std::vector<Triangle>& parts) const
  {
    if (lengthOf(q[0], q[2]) <= lengthOf(q[1], q[3]))
    {
      parts.insert(parts.end(), { { q[0], q[1], q[2] }, { q[0], q[2], q[3] } });
    }
    else
    {
      parts.insert(parts.end(), { { q[0], q[1], q[3] }, { q[1], q[2], q[3] } });
    }
  }

  // What triangles that close holes have no number for, stays without.
  template <class T>
  static void repeat(
    const std::vector<T>& from, std::size_t i, std::size_t count, std::vector<T>& to)
  {
    if (i < from.size())
    {
      to.insert(to.end(), count, from[i]);
    }
  }

  Surface& surface_;
  const double longest_;
  std::vector<Edge> edges_; // too long; their middles are numbered from first_
  std::uint32_t first_ = 0;
};

}

void divideTriangles(Surface& surface, double longest)
{
  constexpr double Shortest = 16;
  Divider divider(surface, std::max(longest, Shortest));
  while (surface.triangles.size() < MostDividedTriangles && divider.divide())
  {
  }
}

}

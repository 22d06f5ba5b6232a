// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/Caps.h"

#include "Surface/Components.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// So many times as large as a cap are the walls at its rim, for an end of any shape as long as wide (the hydraulic
// diameter); a cube's sides just count.
constexpr double LeastWalls = 4 * (1 - 1e-6);

// By so many degrees the walls turn away from a cap at least: a duct may end at a slant, and a facet of a round body is none.
constexpr double LeastTurn = 40;

// Of each component, by its lowest vertex: 1, or -1 if its triangles face inwards.
std::vector<std::int8_t> outwards(const Surface& surface, DisjointSets& components)
{
  std::vector<double> volume(surface.vertices.size());
  for (const auto& t : surface.triangles)
  {
    const std::uint32_t at = components.find(t[0]);
    const Point& from = surface.vertices[at];
    volume[at] += dot(minus(surface.vertices[t[0]], from),
      cross(minus(surface.vertices[t[1]], from), minus(surface.vertices[t[2]], from)));
  }
  std::vector<std::int8_t> sign(volume.size());
  std::transform(volume.begin(), volume.end(), sign.begin(),
    [](double v) { return static_cast<std::int8_t>(v < 0 ? -1 : 1); });
  return sign;
}

// A patch's neighbour across an edge of its rim.
struct RimEdge
{
  std::uint32_t patch;
  std::uint32_t neighbour;

  bool operator<(const RimEdge& other) const
  {
    return patch != other.patch ? patch < other.patch : neighbour < other.neighbour;
  }
  bool operator==(const RimEdge& other) const
  {
    return patch == other.patch && neighbour == other.neighbour;
  }
};

class CapFinder
{
public:
  CapFinder(const Surface& surface, const Features& features,
    const std::vector<std::uint32_t>& patchOf, const std::vector<PatchShape>& shapes)
    : surface_(surface)
    , features_(features)
    , patchOf_(patchOf)
    , shapes_(shapes)
    , isCap_(shapes.size())
    , components_(connectedComponents(surface))
    , outwards_(outwards(surface, components_))
  {
    std::transform(shapes.begin(), shapes.end(), isCap_.begin(),
      [](const PatchShape& shape) { return shape.isFlat; });
  }

  void look(std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end)
  {
    const bool joins = end - begin == 2 && begin->down() != begin[1].down();
    for (const EdgeUse* use = begin; use != end; ++use)
    {
      const std::uint32_t patch = patchOf_[use->triangle()];
      if (!isCap_[patch])
      {
        continue;
      }
      const std::uint32_t other = joins ? begin[use == begin].triangle() : use->triangle();
      if (joins && patchOf_[other] == patch)
      {
        continue;
      }
      isCap_[patch] = joins && turnsInwards(use->triangle(), other, lower, use->upper);
      rims_.push_back({ patch, patchOf_[other] });
    }
  }

  std::vector<std::uint8_t> caps()
  {
    rims_ = sortedUnique(std::move(rims_));
    std::vector<double> walls(shapes_.size());
    for (const RimEdge& edge : rims_)
    {
      walls[edge.patch] += shapes_[edge.neighbour].size;
    }
    for (std::size_t patch = 0; patch < shapes_.size(); ++patch)
    {
      isCap_[patch] = isCap_[patch] && walls[patch] >= LeastWalls * shapes_[patch].size;
    }
    return isCap_;
  }

private:
  // What has no area tells nothing.
  bool turnsInwards(
    std::uint32_t triangle, std::uint32_t other, std::uint32_t lower, std::uint32_t upper)
  {
    const Vector& normal = features_.normal[other];
    if (dot(normal, normal) == 0)
    {
      return true;
    }
    const auto& v = surface_.triangles[other];
    const std::uint32_t far =
      *std::find_if(v.begin(), v.end(), [&](std::uint32_t x) { return x != lower && x != upper; });
    const Vector& cap = shapes_[patchOf_[triangle]].area;
    const Vector out = scaled(cap, outwards_[components_.find(lower)]);
    return dot(normal, cap) <= std::cos(radians(LeastTurn)) * norm(cap) &&
      dot(minus(surface_.vertices[far], surface_.vertices[lower]), out) < 0;
  }

  const Surface& surface_;
  const Features& features_;
  const std::vector<std::uint32_t>& patchOf_;
  const std::vector<PatchShape>& shapes_;
  std::vector<std::uint8_t> isCap_;
  DisjointSets components_;
  std::vector<std::int8_t> outwards_;
  std::vector<RimEdge> rims_;
};

bool areInOnePlane(const PatchShape& a, const PatchShape& b, double size)
{
  const Vector n = unit(a.area);
  return norm(minus(n, unit(b.area))) <= Flatness &&
    std::abs(dot(minus(b.centre, a.centre), n)) <= Flatness * size;
}

}

std::vector<PatchShape> shapesOf(const SurfaceView& view, const Surface& surface,
  const std::vector<std::uint32_t>& patchOf, std::size_t count)
{
  std::vector<PatchShape> shapes(count);
  for (std::size_t t = 0; t < patchOf.size(); ++t)
  {
    PatchShape& shape = shapes[patchOf[t]];
    const auto c = view.corners(surface.given[t]);
    const Vector area = scaled(cross(minus(c[1], c[0]), minus(c[2], c[0])), 0.5);
    const double size = norm(area);
    shape.area = plus(shape.area, area);
    shape.size += size;
    shape.centre = plus(shape.centre, scaled(plus(plus(c[0], c[1]), c[2]), size / 3));
  }
  for (PatchShape& shape : shapes)
  {
    shape.centre = shape.size > 0 ? scaled(shape.centre, 1 / shape.size) : shape.centre;
  }
  for (std::size_t t = 0; t < patchOf.size(); ++t)
  {
    PatchShape& shape = shapes[patchOf[t]];
    const Vector normal = unit(shape.area);
    for (const Vector& corner : view.corners(surface.given[t]))
    {
      const Vector from = minus(corner, shape.centre);
      shape.radius = std::max(shape.radius, norm(from));
      shape.thickness = std::max(shape.thickness, std::abs(dot(from, normal)));
    }
  }
  const double rounding = surface.rounding * surface.lattice.step();
  for (PatchShape& shape : shapes)
  {
    // One that is folded onto itself has a smaller area vector.
    shape.isFlat = shape.size > 0 && shape.thickness <= Flatness * shape.radius + rounding &&
      norm(shape.area) >= (1 - Flatness) * shape.size;
  }
  return shapes;
}

std::vector<std::uint8_t> findCaps(const Surface& surface, const SurfaceEdges& edges,
  const Features& features, const std::vector<std::uint32_t>& patchOf,
  const std::vector<PatchShape>& shapes)
{
  CapFinder finder(surface, features, patchOf, shapes);
  edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
    finder.look(lower, begin, end);
  });
  return finder.caps();
}

std::vector<std::uint32_t> planesOf(const std::vector<PatchShape>& shapes, double size)
{
  std::vector<std::uint32_t> flat;
  for (std::uint32_t patch = 0; patch < shapes.size(); ++patch)
  {
    if (shapes[patch].isFlat)
    {
      flat.push_back(patch);
    }
  }
  // Those of one plane are close in this order.
  const auto x = [&](std::uint32_t patch) { return unit(shapes[patch].area)[0]; };
  std::vector<double> normalX(shapes.size());
  for (const std::uint32_t patch : flat)
  {
    normalX[patch] = x(patch);
  }
  std::sort(flat.begin(), flat.end(), [&](std::uint32_t a, std::uint32_t b) {
    return normalX[a] != normalX[b] ? normalX[a] < normalX[b] : a < b;
  });
  DisjointSets planes(shapes.size());
  for (auto a = flat.begin(); a != flat.end(); ++a)
  {
    for (auto b = a + 1; b != flat.end() && normalX[*b] - normalX[*a] <= Flatness; ++b)
    {
      if (areInOnePlane(shapes[*a], shapes[*b], size))
      {
        planes.unite(*a, *b);
      }
    }
  }
  std::vector<std::uint32_t> plane(shapes.size());
  for (std::uint32_t patch = 0; patch < shapes.size(); ++patch)
  {
    plane[patch] = planes.find(patch);
  }
  return plane;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/Surface.h"

#include "Base/Error.h"
#include "Lattice/PointSortKey.h"
#include "Lattice/Vector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::size_t VerticesAChunk = 1 << 14;

// Volumes must stay finite in double precision; those of small parts of small cells, and squares of the areas
// of their faces, must not vanish.
constexpr double LargestCoordinate = 1e100;
constexpr double ShortestSurface = 1e-70;

std::string place(const double* p)
{
  return "(" + number(p[0]) + ", " + number(p[1]) + ", " + number(p[2]) + ")";
}

// The user's number of a triangle.
long long cellOf(const SurfaceView& view, std::size_t triangle)
{
  return view.cells ? view.cells[triangle] : static_cast<long long>(triangle);
}

void checkTriangle(const SurfaceView& view, std::size_t triangle)
{
  for (int corner = 0; corner < 3; ++corner)
  {
    const std::uint32_t id = view.triangles[3 * triangle + corner];
    if (id >= view.pointCount)
    {
      throw Error(Fault::BadParameter,
        "Cell " + std::to_string(cellOf(view, triangle)) + " of the surface refers to point " +
          std::to_string(id) + ", but the surface has " + std::to_string(view.pointCount) +
          " points. Correct or remove the cell.");
    }
    const double* p = view.points + 3 * std::size_t(id);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!(std::abs(p[axis]) <= LargestCoordinate))
      {
        throw Error(Fault::BadCoordinate,
          "Point " + std::to_string(id) + " of the surface, used by cell " +
            std::to_string(cellOf(view, triangle)) + ", is at " + place(p) +
            ": not a finite number, or too large. Remove or correct it.");
      }
    }
  }
}

// Sorts what may take seconds, and can be stopped in between.
template <class T>
void sortPolling(std::vector<T>& items, Execution& execution)
{
  std::sort(items.begin(), items.end(), [&](const T& a, const T& b) {
    execution.poll();
    return a < b;
  });
}

// Merges points that share all three levels: fills `surface.vertices` and returns the vertex of
// each point.
std::vector<std::uint32_t> mergePoints(
  const std::vector<Point>& points, Surface& surface, Execution& execution)
{
  std::vector<PointSortKey> order;
  order.reserve(points.size());
  for (std::uint32_t id = 0; id < points.size(); ++id)
  {
    order.emplace_back(points[id], id);
  }
  sortPolling(order, execution);
  std::vector<std::uint32_t> vertex(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i == 0 || !order[i].isAt(order[i - 1]))
    {
      surface.vertices.push_back(order[i].point());
    }
    vertex[order[i].number()] = static_cast<std::uint32_t>(surface.vertices.size() - 1);
  }
  return vertex;
}

// A triangle of the view by its vertices in order, then by direction and boundary: those that are equal
// in all that are interchangeable.
struct OrderedTriangle
{
  std::array<std::uint32_t, 3> sorted;
  std::array<std::uint32_t, 3> vertices; // the lowest first
  std::int32_t region;
  std::int32_t boundary;
  std::uint32_t given;

  bool operator<(const OrderedTriangle& other) const
  {
    return std::tie(sorted, vertices, region, boundary) <
      std::tie(other.sorted, other.vertices, other.region, other.boundary);
  }
};

OrderedTriangle orderedTriangle(
  const SurfaceView& view, std::size_t triangle, const std::vector<std::uint32_t>& vertex)
{
  OrderedTriangle t{};
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    t.vertices[corner] = vertex[view.triangles[3 * triangle + corner]];
  }
  const auto [p, q, r] = t.vertices;
  t.vertices = std::min({ t.vertices, { q, r, p }, { r, p, q } }); // also where it names one twice
  t.sorted = t.vertices;
  std::sort(t.sorted.begin(), t.sorted.end());
  t.region = view.region ? view.region[triangle] : FirstRegion;
  t.boundary = view.boundary ? view.boundary[triangle] : 0;
  t.given = static_cast<std::uint32_t>(triangle);
  return t;
}

void addTriangles(const SurfaceView& view, const std::vector<std::uint32_t>& vertex,
  Surface& surface, Execution& execution)
{
  std::vector<OrderedTriangle> order;
  order.reserve(view.triangleCount);
  for (std::size_t t = 0; t < view.triangleCount; ++t)
  {
    order.push_back(orderedTriangle(view, t, vertex));
  }
  sortPolling(order, execution);
  surface.triangles.reserve(order.size());
  surface.boundary.reserve(order.size());
  surface.given.reserve(order.size());
  for (const OrderedTriangle& t : order)
  {
    surface.triangles.push_back(t.vertices);
    surface.boundary.push_back(t.boundary);
    if (view.region)
    {
      surface.region.push_back(t.region);
    }
    surface.given.push_back(t.given);
  }
}

// Half the distance between neighbouring numbers of the file, where all its coordinates are in single precision, as in
// STL; 0 otherwise.
double roundingOf(const SurfaceView& view, const std::vector<bool>& used)
{
  double largest = 0;
  for (std::size_t i = 0; i < 3 * view.pointCount; ++i)
  {
    const double x = view.points[i];
    if (used[i / 3])
    {
      if (static_cast<double>(static_cast<float>(x)) != x)
      {
        return 0;
      }
      largest = std::max(largest, std::abs(x));
    }
  }
  return largest * double(std::numeric_limits<float>::epsilon()) / 2;
}

}

Bounds boundsOf(const SurfaceView& view)
{
  if (view.triangleCount == 0)
  {
    throw Error(
      Fault::EmptySurface, "The surface has no triangles: connect a closed triangulated surface.");
  }
  Bounds bounds = Bounds::none();
  for (std::size_t t = 0; t < view.triangleCount; ++t)
  {
    checkTriangle(view, t);
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        bounds.include(axis, view.points[3 * std::size_t(view.triangles[3 * t + corner]) + axis]);
      }
    }
  }
  if (bounds.longest() == 0)
  {
    throw Error(
      Fault::EmptySurface, "All points of the surface coincide: connect a closed surface.");
  }
  if (bounds.longest() < ShortestSurface)
  {
    throw Error(Fault::BadCoordinate,
      "The surface is only " + number(bounds.longest()) +
        " long: cell volumes would vanish in double precision. Scale it up.");
  }
  return bounds;
}

Surface onLattice(const SurfaceView& view, const Lattice& lattice, Execution& execution)
{
  // Unused points may have any coordinates, even NaN: they stay at the corner of the lattice.
  std::vector<bool> used(view.pointCount);
  for (std::size_t i = 0; i < 3 * view.triangleCount; ++i)
  {
    used[view.triangles[i]] = true;
  }
  std::vector<Point> points(view.pointCount);
  execution.forEach(view.pointCount, VerticesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      for (int axis = 0; used[i] && axis < 3; ++axis)
      {
        points[i][axis] = lattice.vertex(axis, view.points[3 * i + axis]);
      }
    }
  });

  Surface surface;
  surface.lattice = lattice;
  surface.rounding = std::max(1.0, roundingOf(view, used) / lattice.step());
  const std::vector<std::uint32_t> vertex = mergePoints(points, surface, execution);
  addTriangles(view, vertex, surface, execution);
  return surface;
}

double areaOf(const Surface& surface)
{
  double twice = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners c = surface.corners(t);
    const Vector normal = cross(minus(c[1], c[0]), minus(c[2], c[0]));
    twice += std::sqrt(dot(normal, normal));
  }
  return twice / 2 * surface.lattice.step() * surface.lattice.step();
}

double volumeOf(const Surface& surface)
{
  double six = 0;
  const Point base = surface.corners(0)[0];
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners c = surface.corners(t);
    if (!surface.walls.isInterface(surface.boundary[t]))
    {
      six += dot(minus(c[0], base), cross(minus(c[1], c[0]), minus(c[2], c[0])));
    }
  }
  const double step = surface.lattice.step();
  return six / 6 * step * step * step;
}

}

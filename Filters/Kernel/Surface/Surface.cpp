// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/Surface.h"

#include "Base/Error.h"
#include "Base/Sorting.h"
#include "Lattice/PointSortKey.h"
#include "Lattice/Vector.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::size_t VerticesAChunk = 1 << 12;
constexpr std::size_t TrianglesAChunk = 1 << 12;

constexpr std::uint32_t NoVertex = ~std::uint32_t(0);

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

// Merges points that share all three levels: fills `surface.vertices` and returns the vertex of
// each point.
RawVector<std::uint32_t> mergePoints(
  const RawVector<Point>& points, Surface& surface, Execution& execution)
{
  const std::size_t count = points.size();
  RawVector<PointSortKey> order(count);
  execution.forEach(count, VerticesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t id = begin; id < end; ++id)
    {
      order[id] = { points[id], static_cast<std::uint32_t>(id) };
    }
  });
  sortAll(order, execution);
  const auto isNew = [&](std::size_t i) { return i == 0 || !order[i].isAt(order[i - 1]); };
  std::vector<std::uint32_t> first(chunks(count, VerticesAChunk) + 1);
  execution.forEach(count, VerticesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      first[begin / VerticesAChunk] += isNew(i) ? 1 : 0;
    }
  });
  surface.vertices.resize(scan(first));
  RawVector<std::uint32_t> vertex(count);
  execution.forEach(count, VerticesAChunk, [&](std::size_t begin, std::size_t end) {
    std::uint32_t next = first[begin / VerticesAChunk];
    for (std::size_t i = begin; i < end; ++i)
    {
      if (isNew(i))
      {
        surface.vertices[next++] = order[i].point();
      }
      vertex[order[i].number()] = next - 1;
    }
  });
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
  const SurfaceView& view, std::size_t triangle, const RawVector<std::uint32_t>& vertex)
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

void addTriangles(const SurfaceView& view, const RawVector<std::uint32_t>& vertex, Surface& surface,
  Execution& execution)
{
  const std::size_t count = view.triangleCount;
  RawVector<OrderedTriangle> order(count);
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      order[t] = orderedTriangle(view, t, vertex);
    }
  });
  sortAll(order, execution);
  surface.triangles.resize(count);
  surface.boundary.resize(count);
  surface.given.resize(count);
  surface.region.resize(view.region ? count : 0);
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      surface.triangles[t] = order[t].vertices;
      surface.boundary[t] = order[t].boundary;
      if (view.region)
      {
        surface.region[t] = order[t].region;
      }
      surface.given[t] = order[t].given;
    }
  });
}

using Flags = std::vector<std::atomic<std::uint8_t>>;

Flags findUsed(const SurfaceView& view, Execution& execution)
{
  Flags used(view.pointCount);
  execution.forEach(
    3 * view.triangleCount, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        used[view.triangles[i]].store(1, std::memory_order_relaxed);
      }
    });
  return used;
}

// Half the distance between neighbouring numbers of the file, where all its coordinates are in single precision, as in
// STL; 0 otherwise.
double roundingOf(const SurfaceView& view, const Flags& used, Execution& execution)
{
  constexpr double NotSingle = std::numeric_limits<double>::infinity();
  std::vector<double> largest(chunks(view.pointCount, VerticesAChunk));
  execution.forEach(view.pointCount, VerticesAChunk, [&](std::size_t begin, std::size_t end) {
    double most = 0;
    for (std::size_t i = 3 * begin; i < 3 * end; ++i)
    {
      const double x = view.points[i];
      if (used[i / 3] != 0)
      {
        if (static_cast<double>(static_cast<float>(x)) != x)
        {
          most = NotSingle;
        }
        most = std::max(most, std::abs(x));
      }
    }
    largest[begin / VerticesAChunk] = most;
  });
  const double most = largest.empty() ? 0 : *std::max_element(largest.begin(), largest.end());
  return most == NotSingle ? 0 : most * double(std::numeric_limits<float>::epsilon()) / 2;
}

// The vertex at the place of a point that no triangle uses and that need not exist, or NoVertex.
std::uint32_t vertexAt(const SurfaceView& view, std::uint32_t point, const Surface& surface)
{
  Point place{};
  if (point >= view.pointCount)
  {
    return NoVertex;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = view.points[3 * std::size_t(point) + static_cast<std::size_t>(axis)];
    const Lattice& lattice = surface.lattice;
    if (!(x >= lattice.position(axis, 0) &&
          x < lattice.position(axis, std::numeric_limits<Level>::max())))
    {
      return NoVertex;
    }
    place[static_cast<std::size_t>(axis)] = lattice.vertex(axis, x);
  }
  const auto at = std::lower_bound(surface.vertices.begin(), surface.vertices.end(), place);
  return at != surface.vertices.end() && *at == place
    ? static_cast<std::uint32_t>(at - surface.vertices.begin())
    : NoVertex;
}

std::shared_ptr<const FeatureEdgeTags> knownEdgesOf(const SurfaceView& view, const Flags& used,
  const RawVector<std::uint32_t>& vertex, const Surface& surface, Execution& execution)
{
  if (!view.knowsEdges)
  {
    return nullptr;
  }
  std::vector<FeatureEdgeTags::Line> sharp(view.sharpEdgeCount);
  for (std::size_t i = 0; i < 2 * view.sharpEdgeCount; ++i)
  {
    const std::uint32_t point = view.sharpEdges[i];
    sharp[i / 2][i % 2] =
      point < view.pointCount && used[point] != 0 ? vertex[point] : vertexAt(view, point, surface);
  }
  return std::make_shared<FeatureEdgeTags>(view, surface, std::move(sharp), execution);
}

Bounds boundsOf(const SurfaceView& view, std::size_t begin, std::size_t end)
{
  Bounds bounds = Bounds::none();
  for (std::size_t t = begin; t < end; ++t)
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
  return bounds;
}

// Throws the error of the first flawed triangle, whichever thread finds one first.
Bounds boundsOfTriangles(const SurfaceView& view, Execution& execution)
{
  std::vector<Bounds> parts(chunks(view.triangleCount, TrianglesAChunk));
  std::vector<std::exception_ptr> flaws(parts.size());
  execution.forEach(view.triangleCount, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    try
    {
      parts[begin / TrianglesAChunk] = boundsOf(view, begin, end);
    }
    catch (const Error&)
    {
      flaws[begin / TrianglesAChunk] = std::current_exception();
    }
  });
  Bounds bounds = Bounds::none();
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (flaws[i])
    {
      std::rethrow_exception(flaws[i]);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds.include(axis, parts[i].low[axis]);
      bounds.include(axis, parts[i].high[axis]);
    }
  }
  return bounds;
}

}

Bounds boundsOf(const SurfaceView& view)
{
  Execution alone;
  return boundsOf(view, alone);
}

Bounds boundsOf(const SurfaceView& view, Execution& execution)
{
  if (view.triangleCount == 0)
  {
    throw Error(
      Fault::EmptySurface, "The surface has no triangles: connect a closed triangulated surface.");
  }
  const Bounds bounds = boundsOfTriangles(view, execution);
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
  const Flags used = findUsed(view, execution);
  RawVector<Point> points(view.pointCount);
  execution.forEach(view.pointCount, VerticesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      points[i] = {};
      for (int axis = 0; used[i] != 0 && axis < 3; ++axis)
      {
        points[i][axis] = lattice.vertex(axis, view.points[3 * i + axis]);
      }
    }
  });

  Surface surface;
  surface.lattice = lattice;
  surface.rounding = std::max(1.0, roundingOf(view, used, execution) / lattice.step());
  const RawVector<std::uint32_t> vertex = mergePoints(points, surface, execution);
  addTriangles(view, vertex, surface, execution);
  surface.knownEdges = knownEdgesOf(view, used, vertex, surface, execution);
  return surface;
}

Surface partOf(const Surface& surface, const std::vector<std::uint32_t>& triangles)
{
  std::vector<std::uint32_t> used;
  for (const std::uint32_t t : triangles)
  {
    used.insert(used.end(), surface.triangles[t].begin(), surface.triangles[t].end());
  }
  used = sortedUnique(std::move(used));
  Surface part;
  part.lattice = surface.lattice;
  part.rounding = surface.rounding;
  for (const std::uint32_t v : used)
  {
    part.vertices.push_back(surface.vertices[v]);
  }
  for (const std::uint32_t t : triangles)
  {
    part.triangles.push_back(surface.triangles[t]);
    for (std::uint32_t& v : part.triangles.back())
    {
      v = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    }
    part.boundary.push_back(surface.boundary[t]);
    if (!surface.region.empty())
    {
      part.region.push_back(surface.region[t]);
    }
    if (t < surface.given.size())
    {
      part.given.push_back(surface.given[t]);
    }
  }
  return part;
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

#include "Support/Shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cartesian
{

namespace
{

// Adds quadrilaterals whose points are named by integers: the same name means the same point.
class Builder
{
public:
  using Name = std::array<int, 3>;

  explicit Builder(std::function<Vector(const Name&)> place)
    : place_(std::move(place))
  {
  }

  // Counter-clockwise from outside.
  void addQuad(const std::array<Name, 4>& q, std::int32_t boundary)
  {
    const std::array<std::uint32_t, 4> p = { point(q[0]), point(q[1]), point(q[2]), point(q[3]) };
    soup_.triangles.push_back({ p[0], p[1], p[2] });
    soup_.triangles.push_back({ p[0], p[2], p[3] });
    soup_.boundary.insert(soup_.boundary.end(), 2, boundary);
  }

  // The side of the grid box at `low` that looks down or up along `axis`.
  void addSide(Name low, int axis, bool upper, std::int32_t boundary)
  {
    low[axis] += upper;
    std::array<Name, 4> q = { low, low, low, low };
    const int b = (axis + 1) % 3;
    const int c = (axis + 2) % 3;
    ++q[upper ? 1 : 3][b];
    ++q[2][b];
    ++q[2][c];
    ++q[upper ? 3 : 1][c];
    addQuad(q, boundary);
  }

  Soup take() { return std::move(soup_); }

private:
  std::uint32_t point(const Name& name)
  {
    const auto [at, fresh] = ids_.emplace(name, soup_.points.size());
    if (fresh)
    {
      soup_.points.push_back(place_(name));
    }
    return static_cast<std::uint32_t>(at->second);
  }

  std::function<Vector(const Name&)> place_;
  std::map<Name, std::size_t> ids_;
  Soup soup_;
};

// The surface of a cube of n^3 grid boxes around the origin, its points moved by `place`.
Soup gridCube(int n, const std::function<Vector(const Vector&)>& place)
{
  Builder builder([&](const Builder::Name& name) {
    return place({ 2.0 * name[0] / n - 1, 2.0 * name[1] / n - 1, 2.0 * name[2] / n - 1 });
  });
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < n * n; ++i)
    {
      for (const bool upper : { false, true })
      {
        Builder::Name low{};
        low[axis] = upper ? n - 1 : 0;
        low[(axis + 1) % 3] = i % n;
        low[(axis + 2) % 3] = i / n;
        builder.addSide(low, axis, upper, 2 * axis + upper);
      }
    }
  }
  return builder.take();
}

Vector onSphere(const Vector& p, double radius)
{
  const double l = norm(p);
  return { radius * p[0] / l, radius * p[1] / l, radius * p[2] / l };
}

}

SurfaceView Soup::view() const
{
  SurfaceView v;
  v.points = points.empty() ? nullptr : points[0].data();
  v.pointCount = points.size();
  v.triangles = triangles.empty() ? nullptr : triangles[0].data();
  v.triangleCount = triangles.size();
  v.boundary = boundary.empty() ? nullptr : boundary.data();
  v.region = region.empty() ? nullptr : region.data();
  v.sharpEdges = sharpEdges.empty() ? nullptr : sharpEdges[0].data();
  v.sharpEdgeCount = sharpEdges.size();
  v.knowsEdges = knowsEdges.empty() ? nullptr : knowsEdges.data();
  return v;
}

double Soup::volume() const
{
  double six = 0;
  for (const auto& t : triangles)
  {
    const Vector& base = points[triangles[0][0]];
    six +=
      dot(minus(points[t[0]], base), cross(minus(points[t[1]], base), minus(points[t[2]], base)));
  }
  return six / 6;
}

double Soup::area(std::size_t triangle) const
{
  const auto& t = triangles[triangle];
  return norm(cross(minus(points[t[1]], points[t[0]]), minus(points[t[2]], points[t[0]]))) / 2;
}

double Soup::area() const
{
  double sum = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    sum += area(t);
  }
  return sum;
}

double Soup::edgeLength() const
{
  double twice = 0;
  for (const auto& t : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      twice += norm(minus(points[t[i]], points[t[(i + 1) % 3]]));
    }
  }
  return twice / 2;
}

Vector Soup::low() const
{
  return boundsOf(view()).low;
}

Vector Soup::high() const
{
  return boundsOf(view()).high;
}

double Soup::longest() const
{
  return boundsOf(view()).longest();
}

Soup& Soup::addRegion(const Soup& other)
{
  const std::int32_t next = region.empty() ? FirstRegion : region.back() + 1;
  add(other);
  region.resize(triangles.size(), next);
  return *this;
}

Soup& Soup::add(const Soup& other)
{
  if (!boundary.empty() || !other.boundary.empty())
  {
    boundary.resize(triangles.size());
    std::vector<std::int32_t> more = other.boundary;
    more.resize(other.triangles.size());
    boundary.insert(boundary.end(), more.begin(), more.end());
  }
  const auto first = static_cast<std::uint32_t>(points.size());
  if (!knowsEdges.empty() || !other.knowsEdges.empty())
  {
    knowsEdges.resize(triangles.size());
    knowsEdges.insert(knowsEdges.end(), other.knowsEdges.begin(), other.knowsEdges.end());
    knowsEdges.resize(triangles.size() + other.triangles.size());
  }
  for (const auto& edge : other.sharpEdges)
  {
    sharpEdges.push_back({ edge[0] + first, edge[1] + first });
  }
  points.insert(points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles)
  {
    triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
  return *this;
}

Soup Soup::each(const std::function<Vector(const Vector&)>& move) const
{
  Soup result = *this;
  for (Vector& p : result.points)
  {
    p = move(p);
  }
  return result;
}

Soup Soup::moved(const Vector& by) const
{
  return each([&](const Vector& p) { return Vector{ p[0] + by[0], p[1] + by[1], p[2] + by[2] }; });
}

Soup Soup::scaled(double by) const
{
  return scaled(Vector{ by, by, by });
}

Soup Soup::scaled(const Vector& by) const
{
  return each([&](const Vector& p) { return Vector{ p[0] * by[0], p[1] * by[1], p[2] * by[2] }; });
}

Soup Soup::turned(int axis, double degrees) const
{
  const double c = std::cos(degrees * Pi / 180);
  const double s = std::sin(degrees * Pi / 180);
  return each([&](const Vector& p) {
    Vector q = p;
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    q[u] = c * p[u] - s * p[v];
    q[v] = s * p[u] + c * p[v];
    return q;
  });
}

Soup Soup::turned() const
{
  return turned(0, 17.3).turned(1, 41.9).turned(2, 63.7);
}

Soup Soup::permuted(const std::array<int, 3>& axes) const
{
  Soup result = each([&](const Vector& p) { return Vector{ p[axes[0]], p[axes[1]], p[axes[2]] }; });
  const bool even = (axes[0] + 1) % 3 == axes[1];
  return even ? result : result.flipped();
}

Soup Soup::flipped() const
{
  Soup result = *this;
  for (auto& t : result.triangles)
  {
    std::swap(t[1], t[2]);
  }
  return result;
}

Soup box(const Vector& low, const Vector& high)
{
  return gridCube(1, [&](const Vector& p) {
    return Vector{ p[0] < 0 ? low[0] : high[0], p[1] < 0 ? low[1] : high[1],
      p[2] < 0 ? low[2] : high[2] };
  });
}

Soup cube()
{
  return box({ 0, 0, 0 }, { 1, 1, 1 });
}

Soup octahedron(double radius)
{
  Soup soup;
  soup.points = { { -radius, 0, 0 }, { radius, 0, 0 }, { 0, -radius, 0 }, { 0, radius, 0 },
    { 0, 0, -radius }, { 0, 0, radius } };
  for (std::uint32_t corner = 0; corner < 8; ++corner)
  {
    const std::uint32_t x = corner & 1;
    const std::uint32_t y = 2 + (corner >> 1 & 1);
    const std::uint32_t z = 4 + (corner >> 2);
    const bool even = (corner == 0 || corner == 3 || corner == 5 || corner == 6);
    soup.triangles.push_back({ x, even ? z : y, even ? y : z });
  }
  return soup;
}

Soup tetrahedron(const std::array<Vector, 4>& corners)
{
  Soup soup;
  soup.points.assign(corners.begin(), corners.end());
  soup.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  return soup.volume() < 0 ? soup.flipped() : soup;
}

Soup sphere(int n, double radius)
{
  return gridCube(n, [&](const Vector& p) { return onSphere(p, radius); });
}

Soup torus(int n, double radius, double tube)
{
  const auto place = [&](const Builder::Name& name) {
    const double u = 2 * Pi * name[0] / (2 * n);
    const double v = 2 * Pi * name[1] / n;
    const double r = radius + tube * std::cos(v);
    return Vector{ r * std::cos(u), r * std::sin(u), tube * std::sin(v) };
  };
  Builder builder(place);
  for (int i = 0; i < 2 * n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const int i1 = (i + 1) % (2 * n);
      const int j1 = (j + 1) % n;
      builder.addQuad({ { { i, j, 0 }, { i1, j, 0 }, { i1, j1, 0 }, { i, j1, 0 } } }, j < n / 2);
    }
  }
  return builder.take();
}

Soup tubeWithEnds(std::uint32_t lower, std::uint32_t upper, double length)
{
  Soup soup;
  for (const std::uint32_t n : { lower, upper })
  {
    for (std::uint32_t i = 0; i < n; ++i)
    {
      const double angle = 2 * std::acos(-1.0) * i / n;
      soup.points.push_back({ std::cos(angle), std::sin(angle), n == lower ? 0 : length });
    }
  }
  for (std::uint32_t i = 0; i < lower; ++i)
  {
    const std::uint32_t next = (i + 1) % lower;
    const std::uint32_t above = lower + i * upper / lower;
    soup.triangles.push_back({ i, next, above });
    if (next * upper / lower != i * upper / lower)
    {
      soup.triangles.push_back({ next, lower + next * upper / lower, above });
    }
  }
  soup.boundary.assign(soup.triangles.size(), 0);
  for (std::uint32_t i = 1; i + 1 < lower; ++i)
  {
    soup.triangles.push_back({ 0, i + 1, i });
  }
  soup.boundary.resize(soup.triangles.size(), 1);
  for (std::uint32_t i = 1; i + 1 < upper; ++i)
  {
    soup.triangles.push_back({ lower, lower + i, lower + i + 1 });
  }
  soup.boundary.resize(soup.triangles.size(), 2);
  return soup;
}

Soup kleinBottle(int n)
{
  const auto place = [&](const Builder::Name& name) {
    const double half = Pi * name[0] / n;
    const double v = 2 * Pi * (name[1] + 0.5) / n; // no point where it crosses itself
    const double a = std::sin(v);
    const double b = std::sin(2 * v);
    const double r = 3 + std::cos(half) * a - std::sin(half) * b;
    return Vector{ r * std::cos(2 * half), r * std::sin(2 * half),
      std::sin(half) * a + std::cos(half) * b };
  };
  Builder builder(place);
  for (int i = 0; i < n; ++i)
  {
    const auto name = [&](int along, int j) {
      j %= n;
      return along == n ? Builder::Name{ 0, n - 1 - j, 0 } : Builder::Name{ along, j, 0 };
    };
    for (int j = 0; j < n; ++j)
    {
      builder.addQuad({ name(i, j), name(i + 1, j), name(i + 1, j + 1), name(i, j + 1) }, 0);
    }
  }
  return builder.take();
}

Soup needle()
{
  return box({ 0, 0, 0 }, { 1, 1e-4, 1e-4 }).turned();
}

Soup pyramidOnAPlane()
{
  Soup soup = box({ -1, -1, -0.5 }, { 1, 1, 0 });
  Soup pyramid;
  pyramid.points = { { 0.25, 0.125, 0 }, { -0.5, -0.5, 1 }, { 0.75, -0.5, 1 }, { 0.75, 0.75, 1 },
    { -0.5, 0.75, 1 } };
  pyramid.triangles = { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 4, 3 }, { 0, 1, 4 }, { 1, 2, 3 },
    { 1, 3, 4 } };
  return soup.add(pyramid);
}

Soup nestedSpheres()
{
  Soup soup = sphere(6, 1);
  Soup inner = sphere(5, 0.6).moved({ 0.05, 0.1, -0.02 });
  inner.boundary.assign(inner.triangles.size(), 7);
  return soup.add(inner.flipped());
}

Soup voxels(const std::array<std::vector<double>, 3>& lines,
  const std::function<bool(int i, int j, int k)>& inside)
{
  const std::array<int, 3> n = { static_cast<int>(lines[0].size()) - 1,
    static_cast<int>(lines[1].size()) - 1, static_cast<int>(lines[2].size()) - 1 };
  const auto in = [&](const Builder::Name& p) {
    const bool within =
      std::min({ p[0], p[1], p[2] }) >= 0 && p[0] < n[0] && p[1] < n[1] && p[2] < n[2];
    return within && inside(p[0], p[1], p[2]);
  };
  Builder builder([&](const Builder::Name& p) {
    return Vector{ lines[0][p[0]], lines[1][p[1]], lines[2][p[2]] };
  });
  for (int v = 0; v < n[0] * n[1] * n[2]; ++v)
  {
    const Builder::Name p = { v % n[0], v / n[0] % n[1], v / n[0] / n[1] };
    for (int side = 0; in(p) && side < 6; ++side)
    {
      Builder::Name neighbour = p;
      neighbour[side / 2] += side % 2 ? 1 : -1;
      if (!in(neighbour))
      {
        builder.addSide(p, side / 2, side % 2 == 1, side);
      }
    }
  }
  return builder.take();
}

Soup comb(int teeth)
{
  std::array<std::vector<double>, 3> lines = { { { 0 }, { 0, 0.7 }, { 0, 0.1, 1 } } };
  for (int i = 1; i < 2 * teeth; ++i)
  {
    lines[0].push_back(i / (2.0 * teeth - 1) + (i % 2) * 0.001);
  }
  return voxels(lines, [](int i, int, int k) { return k == 0 || i % 2 == 0; });
}

Soup blockWithTubes()
{
  const std::vector<double> lines = { 0, 0.1, 0.25, 0.41, 0.55, 0.71, 0.85, 1 };
  return voxels({ lines, lines, { 0, 1 } }, [](int i, int j, int) { return i * j % 2 == 0; });
}

Soup beadOnAThread(double thickness)
{
  const std::vector<double> across = { 0, 1.6, 2 - thickness / 2, 2 + thickness / 2, 2.4, 4 };
  return voxels({ { { 0, 4, 7, 7.8 }, across, across } }, [&](int i, int j, int k) {
    const bool onThread = j == 2 && k == 2;
    const bool inBead = j > 0 && j < 4 && k > 0 && k < 4;
    return i == 0 || (i == 1 ? onThread : inBead);
  });
}

Soup starPolyhedron(unsigned seed, int n)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.3, 1);
  return gridCube(n, [&](const Vector& p) { return onSphere(p, radius(random)); });
}

Soup bumpySphere(unsigned seed, int n)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  std::array<Vector, 5> waves;
  for (Vector& wave : waves)
  {
    wave = { 7 * value(random), 7 * value(random), 7 * value(random) };
  }
  return gridCube(n, [&](const Vector& p) {
    const Vector q = onSphere(p, 1);
    double radius = 1;
    for (const Vector& wave : waves)
    {
      radius += 0.12 * std::sin(dot(wave, q));
    }
    return onSphere(q, radius);
  });
}

Soup randomTetrahedra(unsigned seed, int count, int width)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> level(0, width);
  Soup soup;
  for (int i = 0; i < count; ++i)
  {
    std::array<Vector, 4> corners;
    for (Vector& corner : corners)
    {
      for (double& x : corner)
      {
        x = 2.0 * level(random) + 1;
      }
    }
    soup.add(tetrahedron(corners));
  }
  return soup;
}

const std::vector<NamedShape>& cleanShapes()
{
  const std::vector<double> thirds = { 0, 1 / 3.0, 2 / 3.0, 1 };
  const Soup plate = box({ 0, 0, 0.4 }, { 1, 0.8, 0.403 });
  static const std::vector<NamedShape> shapes = {
    { "Cube", cube() },
    { "CubeTurnedBy45Degrees", cube().turned(2, 45) },
    { "CubeTurned", cube().turned() },
    { "Octahedron", octahedron(1) },
    { "Tetrahedron", tetrahedron({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } }) },
    { "TetrahedronTurned",
      tetrahedron({ { { 0, 0, 0 }, { 1, 0, 0.2 }, { 0.3, 1, 0 }, { 0, 0.1, 1 } } }).turned() },
    { "Sphere", sphere(8, 1) },
    { "Torus", torus(12, 1, 0.35) },
    { "NestedSpheres", nestedSpheres() },
    { "TwoSpheres", sphere(5, 1).add(sphere(4, 0.5).moved({ 1.7, 0.1, 0.2 })) },
    { "ThinPlate", plate },
    { "ThinPlateTurned", plate.turned() },
    { "Comb", comb(9) },
    { "CombTurned", comb(9).turned() },
    { "LShape", voxels({ thirds, thirds, thirds }, [](int i, int j, int) { return i * j == 0; }) },
    { "BoxesTouchingInAnEdge",
      voxels({ thirds, thirds, thirds }, [](int i, int j, int) { return (i + j) % 2 == 0; }) },
    { "BoxesTouchingInCorners",
      voxels({ thirds, thirds, thirds },
        [](int i, int j, int k) {
          return i % 2 == j % 2 && j % 2 == k % 2 && (i / 2 + j / 2 + k / 2) % 3 != 1;
        }) },
    { "BlockWithTubes", blockWithTubes() },
    { "PyramidOnAPlane", pyramidOnAPlane() },
    { "Needle", needle() },
    { "StarPolyhedron", starPolyhedron(1, 4) },
    { "BumpySphere", bumpySphere(2, 9) },
    { "FarAway", sphere(5, 1).moved({ 1e6, -2e6, 3e6 }) },
    { "Tiny", bumpySphere(3, 5).scaled(1e-6) },
    { "TinyAndFarAway", sphere(4, 1e-6).moved({ 1, 2, 3 }) },
    { "Huge", cube().turned().scaled(1e9) },
    { "Flat", sphere(5, 1).scaled({ 1, 1, 1e-3 }) },
  };
  return shapes;
}

std::vector<NamedShape> thinShapes()
{
  // The lattice of a surface about 1 long has steps of 2^-31.
  const double step = std::ldexp(1.0, -31);
  return {
    { "PlateTwoLevelsThick", box({ 0, 0, 0.5 }, { 1, 0.75, 0.5 + 2 * step }) },
    { "PlateOneLevelThick", box({ 0, 0, 0.5 }, { 1, 0.75, 0.5 + step }) },
    { "SlotTwoLevelsWide",
      voxels({ { { 0, 1 }, { 0, 0.25, 1 }, { 0, 0.5, 0.5 + 2 * step, 1 } } },
        [](int, int j, int k) { return j == 0 || k != 1; }) },
  };
}

std::ostream& operator<<(std::ostream& stream, const NamedShape& shape)
{
  return stream << shape.name;
}

}

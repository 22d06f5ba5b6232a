// Cracks between faces: what is joined, and the mesh of it.
#include "Repair/Cracks.h"

#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace cartesian;

namespace
{

// Each boundary by itself, the i-th moved by gap times the i-th of some directions.
Soup fallenApart(const Soup& soup, double gap)
{
  Soup apart;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    const auto boundary = static_cast<unsigned>(soup.boundaryOf(t));
    Vector by{};
    by[boundary % 3] = boundary % 2 == 0 ? gap : -gap / 2;
    by[(boundary + 1) % 3] = gap / 3;
    std::array<std::uint32_t, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
    {
      corners[i] = static_cast<std::uint32_t>(apart.points.size());
      apart.points.push_back(plus(soup.points[soup.triangles[t][i]], by));
    }
    apart.triangles.push_back(corners);
    apart.boundary.push_back(soup.boundaryOf(t));
  }
  return apart;
}

// A face whose sides are divided into so many parts along each.
Soup dividedFace(
  int n, const Vector& origin, const Vector& u, const Vector& v, std::int32_t boundary)
{
  Soup face;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      face.points.push_back(plus(origin, plus(scaled(u, double(i) / n), scaled(v, double(j) / n))));
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const auto at = [n](int a, int b) { return static_cast<std::uint32_t>(b * (n + 1) + a); };
      face.triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      face.triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  face.boundary.assign(face.triangles.size(), boundary);
  return face;
}

// A unit cube of six faces that are divided by 3 to 8 along each side, so that hardly any corners meet.
Soup patchwork(double gap)
{
  Soup faces;
  int n = 3;
  std::int32_t boundary = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const double side : { 0., 1. })
    {
      Vector origin{};
      Vector u{};
      Vector v{};
      origin[axis] = side + (side > 0 ? gap : -gap);
      u[(axis + (side > 0 ? 1 : 2)) % 3] = 1;
      v[(axis + (side > 0 ? 2 : 1)) % 3] = 1;
      Soup face = dividedFace(n++, origin, u, v, boundary++);
      const auto shift = static_cast<std::uint32_t>(faces.points.size());
      faces.points.insert(faces.points.end(), face.points.begin(), face.points.end());
      for (const auto& t : face.triangles)
      {
        faces.triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
      }
      faces.boundary.insert(faces.boundary.end(), face.boundary.begin(), face.boundary.end());
    }
  }
  return faces;
}

// What the mesh lacks is at most what the cracks may move.
void expectWhole(
  const Soup& soup, double volume, const std::map<std::int32_t, double>& areas, double gap)
{
  const MeshArrays mesh = meshOf(soup, cellsOf(0.17)).mesh;
  EXPECT_TRUE(isValid(mesh));
  EXPECT_NEAR(volumeOf(mesh), volume, 8 * gap);
  const std::map<std::int32_t, double> found = areasByBoundary(mesh);
  ASSERT_EQ(found.size(), areas.size());
  for (const auto& [boundary, area] : areas)
  {
    ASSERT_EQ(found.count(boundary), 1U) << boundary;
    EXPECT_NEAR(found.at(boundary), area, 16 * gap) << boundary;
  }
}

}

TEST(Cracks, FacesOneByOneAreABody)
{
  for (const double gap : { 1e-7, 1e-5, 1e-4 })
  {
    for (const Soup& body : { cube(), cube().turned(), cube().turned(2, 45), cube().turned(0, 30) })
    {
      expectWhole(fallenApart(body, gap), 1, areasByBoundary(body), gap);
    }
    expectWhole(patchwork(gap), 1, areasByBoundary(cube()), gap);
  }
}

// Without a gap: they have corners in common, between which one has more.
TEST(Cracks, FacesThatShareCornersMayBeDividedDifferently)
{
  const Soup faces = patchwork(0);
  for (const Soup& body : { faces, faces.turned(), faces.turned(2, 45), faces.turned(0, 30) })
  {
    const PreparedSurface prepared = prepare(body, cellsOf(0.17));
    EXPECT_TRUE(prepared.repair.check.closed());
    EXPECT_TRUE(prepared.repair.holes.empty());
    EXPECT_NEAR(volumeOf(prepared.surface), 1, 1e-8);
  }
}

// A block with a square hole through it, whose walls are boundary 6.
TEST(Cracks, AHoleThroughABodyStaysOne)
{
  const std::array<std::vector<double>, 3> lines{ { { 0, 0.25, 0.75, 1 }, { 0, 0.25, 0.75, 1 },
    { 0, 1 } } };
  Soup block = voxels(lines, [](int i, int j, int) { return i != 1 || j != 1; });
  block.boundary.clear();
  for (const auto& t : block.triangles)
  {
    const Vector middle =
      scaled(plus(block.points[t[0]], plus(block.points[t[1]], block.points[t[2]])), 1. / 3);
    std::int32_t side = 6;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      side = middle[axis] == 0 ? static_cast<std::int32_t>(2 * axis)
        : middle[axis] == 1    ? static_cast<std::int32_t>(2 * axis) + 1
                               : side;
    }
    block.boundary.push_back(side);
  }
  for (const double gap : { 1e-7, 1e-5, 1e-4 })
  {
    for (const Soup& body : { block, block.turned() })
    {
      expectWhole(fallenApart(body, gap), 0.75, areasByBoundary(body), gap);
    }
  }
}

// A body whose triangles fell into patches: each moved by itself, some of them divided at the middles of edges.
Soup torn(unsigned seed, double gap)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  const Soup body = seed % 2 == 0 ? starPolyhedron(seed, 4) : bumpySphere(seed, 6);
  const auto patches = 2 + seed % 7;
  std::vector<Vector> centres(patches);
  std::vector<Vector> moves(patches);
  for (std::size_t p = 0; p < patches; ++p)
  {
    centres[p] = { any(random), any(random), any(random) };
    moves[p] =
      scaled(unit({ any(random), any(random), any(random) }), gap / 2 * std::abs(any(random)));
  }
  Soup torn;
  const auto add = [&](const Vector& a, const Vector& b, const Vector& c, std::size_t patch) {
    const auto first = static_cast<std::uint32_t>(torn.points.size());
    for (const Vector& corner : { a, b, c })
    {
      torn.points.push_back(plus(corner, moves[patch]));
    }
    torn.triangles.push_back({ first, first + 1, first + 2 });
    torn.boundary.push_back(static_cast<std::int32_t>(patch));
  };
  for (const auto& t : body.triangles)
  {
    const Vector a = body.points[t[0]];
    const Vector b = body.points[t[1]];
    const Vector c = body.points[t[2]];
    const Vector middle = scaled(plus(a, plus(b, c)), 1. / 3);
    const auto nearest =
      std::min_element(centres.begin(), centres.end(), [&](const Vector& one, const Vector& other) {
        return norm(minus(one, middle)) < norm(minus(other, middle));
      });
    const auto patch = static_cast<std::size_t>(nearest - centres.begin());
    if (patch % 2 == 0)
    {
      add(a, b, c, patch);
      continue;
    }
    const Vector ab = scaled(plus(a, b), 0.5);
    const Vector bc = scaled(plus(b, c), 0.5);
    const Vector ca = scaled(plus(c, a), 0.5);
    add(a, ab, ca, patch);
    add(ab, b, bc, patch);
    add(ca, bc, c, patch);
    add(ab, bc, ca, patch);
  }
  return torn;
}

TEST(Cracks, TornBodiesAreWhole)
{
  for (unsigned seed = 0; seed < repeats(40); ++seed)
  {
    const double gap = std::pow(10., -6 + int(seed % 4));
    const Soup soup = torn(seed, gap);
    const PreparedSurface prepared = prepare(soup, cellsOf(soup.longest() / 15));
    const SurfaceCheck& check = prepared.repair.check;
    EXPECT_TRUE(check.closed() && check.oriented()) << seed << ": " << check.openEdges;
    EXPECT_EQ(prepared.repair.leaks(), 0U) << seed;
    const Soup whole = torn(seed, 0);
    EXPECT_NEAR(volumeOf(prepared.surface), std::abs(whole.volume()), 2 * gap * whole.area())
      << seed;
    EXPECT_EQ(prepared.boundariesGiven.size(), areasByBoundary(whole).size());
  }
}

TEST(Cracks, RegionsStayApart)
{
  // The second box is nearer to the first than cracks are wide.
  const double gap = 1e-4;
  Soup both;
  both.addRegion(fallenApart(cube(), gap));
  both.addRegion(fallenApart(box({ 1 + 3 * gap, 0, 0 }, { 2, 1, 1 }), gap));
  const std::map<int, double> volumes = volumesByRegion(meshOf(both, cellsOf(0.17)).mesh);
  ASSERT_EQ(volumes.size(), 2U);
  EXPECT_NEAR(volumes.begin()->second, 1, 8 * gap);
  EXPECT_NEAR(volumes.rbegin()->second, 1, 16 * gap);
}

TEST(Cracks, AWiderOneStaysOpenUnlessAskedFor)
{
  const Soup soup = fallenApart(cube(), 0.01);
  EXPECT_FALSE(prepare(soup, cellsOf(0.17)).repair.check.closed());
  Options options;
  options.grid = cellsOf(0.17);
  options.cracks.width = 0.02;
  Execution execution;
  const PreparedSurface prepared = prepareSurface(soup.view(), options, execution);
  EXPECT_TRUE(prepared.repair.check.closed());
  EXPECT_GT(prepared.cracks.joined.size(), 10U);
  double widest = 0;
  for (const JoinedCracks::Edge& edge : prepared.cracks.joined)
  {
    widest = std::max(widest, edge.width * prepared.surface.lattice.step());
  }
  EXPECT_GT(widest, 0.005);
  EXPECT_LE(widest, 0.02);
}

TEST(Cracks, SmallerBoxesMakeNarrowerOnes)
{
  const Soup soup = fallenApart(cube(), 1e-3);
  Options options;
  options.grid = cellsOf(0.17);
  Execution execution;
  EXPECT_TRUE(prepareSurface(soup.view(), options, execution).repair.check.closed());
  options.depthAtSurface = 3;
  EXPECT_FALSE(prepareSurface(soup.view(), options, execution).repair.check.closed());
}

TEST(Cracks, ANarrowStripIsNone)
{
  Soup strip;
  for (std::uint32_t i = 0; i <= 20; ++i)
  {
    strip.points.insert(strip.points.end(), { { i / 20., 0, 0 }, { i / 20., 2e-4, 1e-4 } });
  }
  for (std::uint32_t i = 0; i < 40; i += 2)
  {
    strip.triangles.push_back({ i, i + 1, i + 2 });
    strip.triangles.push_back({ i + 1, i + 3, i + 2 });
  }
  const PreparedSurface prepared = prepare(strip.add(cube().moved({ 2, 0, 0 })), cellsOf(0.1));
  EXPECT_TRUE(prepared.cracks.joined.empty());
}

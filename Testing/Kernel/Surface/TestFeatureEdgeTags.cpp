// Sharp edges that are known, whatever their angle.
#include "Support/Pipeline.h"
#include "Surface/Features.h"
#include "Surface/SurfaceSplit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

using namespace cartesian;

namespace
{

using Edge = std::set<Point>;
using IsSharp = std::function<bool(const Vector&, const Vector&)>;

// The same triangles, of which all edges are known.
Soup knowing(Soup soup, const IsSharp& isSharp)
{
  soup.knowsEdges.assign(soup.triangles.size(), 1);
  for (const auto& t : soup.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t a = t[i];
      const std::uint32_t b = t[(i + 1) % 3];
      if (a < b && isSharp(soup.points[a], soup.points[b]))
      {
        soup.sharpEdges.push_back({ a, b });
      }
    }
  }
  return soup;
}

std::size_t differences(const Vector& a, const Vector& b)
{
  return static_cast<std::size_t>(a[0] != b[0]) + static_cast<std::size_t>(a[1] != b[1]) +
    static_cast<std::size_t>(a[2] != b[2]);
}

bool isAlongAnAxis(const Vector& a, const Vector& b)
{
  return differences(a, b) == 1;
}

Soup knowingCube()
{
  return knowing(cube(), isAlongAnAxis);
}

// Sides of a prism around the z axis, from 0 to 1, of which `outline` is the ground. The first point of it sees all others.
Soup prism(const std::vector<std::array<double, 2>>& outline)
{
  Soup soup;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const auto& p : outline)
  {
    soup.points.push_back({ p[0], p[1], 0 });
    soup.points.push_back({ p[0], p[1], 1 });
  }
  for (std::uint32_t i = 0; i < n; ++i)
  {
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = 2 * ((i + 1) % n);
    soup.triangles.push_back({ a, b, b + 1 });
    soup.triangles.push_back({ a, b + 1, a + 1 });
    if (i > 0 && i + 1 < n)
    {
      soup.triangles.push_back({ 0, b, a });
      soup.triangles.push_back({ 1, a + 1, b + 1 });
    }
  }
  return soup;
}

// Its sides turn by 30 degrees.
Soup cylinder()
{
  std::vector<std::array<double, 2>> outline;
  for (int i = 0; i < 12; ++i)
  {
    outline.push_back({ std::cos(radians(30 * i)), std::sin(radians(30 * i)) });
  }
  return prism(outline);
}

bool isOfARim(const Vector& a, const Vector& b)
{
  // Neighbours are half a radius apart; the triangles of caps have longer edges, too.
  return a[2] == b[2] && norm(minus(a, b)) < 0.6;
}

// A block whose top is a ridge along z of 5 degrees, which is its last edge.
Soup ridge()
{
  return prism(
    { { 0.5, 0.5 + 0.5 * std::tan(radians(2.5)) }, { 0, 0.5 }, { 0, 0 }, { 1, 0 }, { 1, 0.5 } });
}

bool isOfRidge(const Vector& a, const Vector& b)
{
  return a[0] == 0.5 && b[0] == 0.5 && a[1] == b[1];
}

Surface surfaceOf(const Soup& soup)
{
  return prepare(soup, cellsAlongLongest(soup, 3)).surface;
}

std::multiset<Edge> sharpEdges(const Surface& surface, double featureAngle)
{
  Execution execution;
  const Features features = findFeatures(surface, featureAngle, execution);
  std::multiset<Edge> edges;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners c = surface.corners(t);
    for (unsigned i = 0; i < 3; ++i)
    {
      if (features.isSharp(t, i))
      {
        edges.insert({ c[i], c[(i + 1) % 3] });
      }
    }
  }
  return edges;
}

// From both of their triangles.
std::size_t sharpSides(const Soup& soup, double featureAngle)
{
  return sharpEdges(surfaceOf(soup), featureAngle).size();
}

// The same surface and the same lines, in another order, from other corners and ends.
Soup shuffled(const Soup& soup, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::uint32_t> place(soup.points.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  Soup result = soup;
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    result.points[place[i]] = soup.points[i];
  }
  for (auto& t : result.triangles)
  {
    t = { place[t[0]], place[t[1]], place[t[2]] };
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  }
  for (auto& edge : result.sharpEdges)
  {
    edge = { place[edge[1]], place[edge[0]] };
  }
  std::shuffle(result.triangles.begin(), result.triangles.end(), random); // all know their edges
  std::shuffle(result.sharpEdges.begin(), result.sharpEdges.end(), random);
  return result;
}

void expectSame(const Features& a, const Features& b)
{
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.ofVertex, b.ofVertex);
}

}

TEST(FeatureEdgeTags, OfACubeAreThoseOfItsAngles)
{
  Execution execution;
  expectSame(findFeatures(surfaceOf(knowingCube()), 180, execution),
    findFeatures(surfaceOf(cube()), 30, execution));
  EXPECT_EQ(sharpSides(cube(), 180), 0u);
}

TEST(FeatureEdgeTags, AreNoOthers)
{
  EXPECT_EQ(sharpSides(cylinder(), 20), 2 * 36u);
  const Surface known = surfaceOf(knowing(cylinder(), isOfARim));
  const std::multiset<Edge> sharp = sharpEdges(known, 20);
  EXPECT_EQ(sharp.size(), 2 * 24u);
  EXPECT_EQ(sharp, sharpEdges(known, 180));
  EXPECT_EQ(sharp, sharpEdges(known, 0));
  for (const Edge& edge : sharp)
  {
    EXPECT_EQ((*edge.begin())[2], (*edge.rbegin())[2]);
  }
}

TEST(FeatureEdgeTags, MayBeShallow)
{
  const Soup known =
    knowing(ridge(), [](const Vector& a, const Vector& b) { return isOfRidge(a, b); });
  EXPECT_EQ(sharpSides(known, 30), 2u);
  EXPECT_EQ(sharpSides(ridge(), 30), 2 * 14u); // all others
}

TEST(FeatureEdgeTags, DependOnNoOrder)
{
  const Soup soup = knowing(cylinder(), isOfARim);
  const std::multiset<Edge> expected = sharpEdges(surfaceOf(soup), 20);
  Execution execution;
  const Features features = findFeatures(surfaceOf(soup), 20, execution);
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    expectSame(findFeatures(surfaceOf(shuffled(soup, seed)), 20, execution), features);
    EXPECT_EQ(sharpEdges(surfaceOf(shuffled(soup, seed).flipped()), 20), expected);
  }
}

TEST(FeatureEdgeTags, AreFoundByTheirPlaces)
{
  // Lines with points of their own, as other readers make them, between others that are no edges.
  Soup soup = knowingCube();
  const auto count = static_cast<std::uint32_t>(soup.points.size());
  const std::vector<Vector> own = soup.points;
  soup.points.insert(soup.points.end(), own.begin(), own.end());
  for (auto& edge : soup.sharpEdges)
  {
    edge = { edge[0] + count, edge[1] + count };
  }
  const auto more = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back({ 0.5, 0.5, 0 });
  soup.points.push_back({ std::nan(""), 1e300, -1e300 });
  soup.sharpEdges.push_back({ 0, more });
  soup.sharpEdges.push_back({ more, more + 1 });
  soup.sharpEdges.push_back({ more + 1, more + 1000 });
  const auto corner = [&](double x) {
    const Vector place{ x, x, x };
    return static_cast<std::uint32_t>(
      std::find(soup.points.begin(), soup.points.end(), place) - soup.points.begin());
  };
  soup.sharpEdges.push_back({ corner(0), corner(1) }); // through the cube
  EXPECT_EQ(sharpEdges(surfaceOf(soup), 180), sharpEdges(surfaceOf(knowingCube()), 180));
}

TEST(FeatureEdgeTags, LeaveOpenEdgesSharp)
{
  Soup soup = knowing(cube(), [](const Vector&, const Vector&) { return false; });
  soup.triangles.pop_back();
  soup.boundary.pop_back();
  soup.knowsEdges.pop_back();
  Execution execution;
  const Surface surface = onLattice(soup.view(), Lattice(boundsOf(soup.view())), execution);
  EXPECT_EQ(sharpEdges(surface, 0).size(), 3u);
}

TEST(FeatureEdgeTags, OfOneSideAloneDoNotSmooth)
{
  // The lid knows its edges, the rest does not: between them, and there only, either is enough.
  Soup soup = cube();
  soup.knowsEdges.assign(soup.triangles.size(), 0);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    soup.knowsEdges[t] = soup.boundaryOf(t) == 5 ? 1 : 0;
  }
  EXPECT_EQ(sharpSides(soup, 30), 24u);
  EXPECT_EQ(sharpSides(soup, 180), 0u);
  soup.sharpEdges = knowingCube().sharpEdges;
  EXPECT_EQ(sharpSides(soup, 30), 24u);
  EXPECT_EQ(sharpSides(soup, 180), 2 * 4u);
}

TEST(FeatureEdgeTags, OfRegionsHoldWhereTheyTouch)
{
  // Two cylinders share a cap. Without knowledge, 20 degrees would also find their 24 sides.
  const Soup low = knowing(cylinder(), isOfARim);
  const Soup high = low.moved({ 0, 0, 1 });
  const Surface surface = surfaceOf(Soup().addRegion(low).addRegion(high));
  ASSERT_TRUE(surface.walls.any());
  const std::multiset<Edge> sharp = sharpEdges(surface, 20);
  EXPECT_EQ(sharp.size(), 2 * 24u + 3 * 12u); // three walls meet in the rim between them
  EXPECT_EQ(sharp, sharpEdges(surfaceOf(Soup().addRegion(high).addRegion(low)), 20));
}

TEST(FeatureEdgeTags, OfOneRegionAreThoseOfTheWallsThatItShares)
{
  // A ridge fits into the other region's block, whose edges nobody knows: its wall there, too, is sharp.
  const Soup known =
    knowing(ridge(), [](const Vector& a, const Vector& b) { return isOfRidge(a, b); });
  Soup plain = ridge().flipped();
  plain.add(box({ -1, -1, -1 }, { 2, 2, 2 }));
  plain.boundary.clear();
  for (const bool isFirst : { true, false })
  {
    Soup both;
    both.addRegion(isFirst ? known : plain).addRegion(isFirst ? plain : known);
    const Surface surface = surfaceOf(both);
    ASSERT_TRUE(surface.walls.any());
    // Of the known region, both walls alike: only the ridge. Around the block, nothing at 180 degrees.
    EXPECT_EQ(sharpEdges(surface, 180).size(), 2u) << isFirst;
    EXPECT_EQ(sharpEdges(surface, 30).size(), 2u + 24u) << isFirst;
  }
}

TEST(FeatureEdgeTags, HoldWhereBodiesDivideTriangles)
{
  // A bar through the cylinder: what it leaves of the sides stays smooth, and they are sharp against each other.
  Soup soup = knowing(cylinder(), isOfARim);
  Soup bar = box({ -2, -0.3, 0.3 }, { 2, 0.3, 0.7 });
  bar.boundary.clear();
  soup.add(bar);
  const Surface surface = surfaceOf(soup);
  ASSERT_GT(surface.triangles.size(), soup.triangles.size());
  const auto onSides = [&](const Edge& edge) {
    return std::all_of(edge.begin(), edge.end(), [&](const Point& p) {
      const double x = surface.lattice.position(0, p[0]);
      const double y = surface.lattice.position(1, p[1]);
      return std::hypot(x, y) > 0.999 && std::hypot(x, y) < 1.001;
    });
  };
  std::size_t upright = 0;
  for (const Edge& edge : sharpEdges(surface, 20))
  {
    upright += onSides(edge) && (*edge.begin())[2] != (*edge.rbegin())[2] ? 1 : 0;
  }
  EXPECT_EQ(upright, 0u);
}

TEST(FeatureEdgeTags, DivideSurfacesIntoPatchesButNotByAnAngle)
{
  Execution execution;
  const auto patches = [&](const Soup& soup, SplitBy by) {
    return splitSurface(soup.view(), { by, 20 }, execution).patches.size();
  };
  const Soup known = knowing(cylinder(), isOfARim);
  EXPECT_EQ(patches(cylinder(), SplitBy::FeatureAngle), 14u);
  EXPECT_EQ(patches(known, SplitBy::FeatureAngle), 14u);
  const Vector asADuct{ 1, 1, 6 };
  EXPECT_EQ(patches(known.scaled(asADuct), SplitBy::FlatCaps), 3u);
}

TEST(FeatureEdgeTags, StayInTheMesh)
{
  // Where the ridge passes from box to box it has a node; if it is not known, most of it is merged with what is beside it.
  const auto nodesOnRidge = [](const Soup& soup) {
    const MeshArrays mesh = meshOf(soup, cellsOf(0.15), TestOptions()).mesh;
    const double top = soup.high()[1];
    std::size_t nodes = 0;
    for (std::size_t i = 0; i < mesh.points.size(); i += 3)
    {
      nodes += std::hypot(mesh.points[i] - 0.5, mesh.points[i + 1] - top) < 1e-6 ? 1 : 0;
    }
    return nodes;
  };
  const Soup known = knowing(ridge(), [](const Vector& a, const Vector& b) {
    return isAlongAnAxis(a, b) || (a[2] == b[2] && std::min(a[1], b[1]) >= 0.5);
  });
  EXPECT_EQ(nodesOnRidge(known), 8u);
  EXPECT_LT(nodesOnRidge(ridge()), 4u);
}

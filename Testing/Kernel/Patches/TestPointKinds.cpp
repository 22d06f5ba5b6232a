// Points of patches know whether they are on a corner, on a sharp edge or border, or merely on the surface.
#include "Support/Effort.h"
#include "Support/Pipeline.h"

#include "Boxes/PlaneClearance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace cartesian;

namespace
{

using Line = std::array<Vector, 2>;

// Around the z axis: the angle from one side to the next is less than the feature angle.
Soup cylinder()
{
  constexpr std::uint32_t Sides = 24;
  Soup soup;
  for (std::uint32_t i = 0; i < Sides; ++i)
  {
    const double angle = 2 * Pi * i / Sides;
    soup.points.push_back({ std::cos(angle), std::sin(angle), 0 });
    soup.points.push_back({ std::cos(angle), std::sin(angle), 3 });
    const std::uint32_t p = 2 * i;
    const std::uint32_t q = 2 * ((i + 1) % Sides);
    soup.triangles.push_back({ p, q, q + 1 });
    soup.triangles.push_back({ p, q + 1, p + 1 });
    soup.triangles.push_back({ 2 * Sides, q, p });
    soup.triangles.push_back({ 2 * Sides + 1, p + 1, q + 1 });
  }
  soup.points.push_back({ 0, 0, 0 });
  soup.points.push_back({ 0, 0, 3 });
  return soup;
}

// A smooth sphere of three boundaries, which meet in two points: one half, and two quarters.
Soup thirds()
{
  Soup soup = sphere(8, 1);
  soup.boundary.clear();
  for (const auto& t : soup.triangles)
  {
    const auto sum = [&](std::size_t axis) {
      return soup.points[t[0]][axis] + soup.points[t[1]][axis] + soup.points[t[2]][axis];
    };
    soup.boundary.push_back(sum(2) < 0 ? 0 : (sum(0) < 0 ? 1 : 2));
  }
  return soup;
}

// Two boundaries, whose border does not bend sharply anywhere.
Soup halves()
{
  Soup soup = thirds();
  std::replace(soup.boundary.begin(), soup.boundary.end(), 2, 1);
  return soup;
}

// A cube with a thin triangle along one of its edges, beside a node in the middle of that edge.
Soup cubeWithASliver()
{
  Soup soup;
  soup.points = cube().points;
  const auto middle = static_cast<std::uint32_t>(soup.points.size());
  std::array<std::uint32_t, 2> edge{};
  for (std::uint32_t p = 0; p < middle; ++p)
  {
    if (soup.points[p][0] == 0 && soup.points[p][1] == 0)
    {
      edge[soup.points[p][2] == 0 ? 0 : 1] = p;
    }
  }
  soup.points.push_back({ 0, 0, 0.5 });
  for (const auto& t : cube().triangles)
  {
    const auto at = std::find(t.begin(), t.end(), edge[0]) - t.begin();
    const std::uint32_t next = t[std::size_t(at + 1) % 3];
    const std::uint32_t last = t[std::size_t(at + 2) % 3];
    if (at < 3 && next == edge[1]) // of one of the two faces there
    {
      soup.triangles.push_back({ edge[0], middle, last });
      soup.triangles.push_back({ middle, edge[1], last });
      soup.triangles.push_back({ edge[0], edge[1], middle });
    }
    else
    {
      soup.triangles.push_back(t);
    }
  }
  return soup;
}

// Edges where boundaries meet or normals differ by more than 30 degrees.
std::vector<Line> featuresOf(const Surface& surface)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> edges;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      edges[std::minmax(surface.triangles[t][i], surface.triangles[t][(i + 1) % 3])].push_back(t);
    }
  }
  const auto normal = [&](std::size_t t) {
    const Corners c = surface.corners(t);
    return unit(cross(minus(c[1], c[0]), minus(c[2], c[0])));
  };
  std::vector<Line> result;
  for (const auto& [edge, of] : edges)
  {
    if (surface.boundary[of[0]] != surface.boundary[of[1]] ||
      dot(normal(of[0]), normal(of[1])) < std::cos(radians(30)))
    {
      result.push_back(
        { toVector(surface.vertices[edge.first]), toVector(surface.vertices[edge.second]) });
    }
  }
  return result;
}

double distance(const Vector& p, const Line& line)
{
  const Vector along = minus(line[1], line[0]);
  const Vector from = minus(p, line[0]);
  const double part = std::clamp(dot(from, along) / dot(along, along), 0.0, 1.0);
  return norm(minus(from, scaled(along, part)));
}

double distance(const Vector& p, const std::vector<Line>& lines)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Line& line : lines)
  {
    least = std::min(least, distance(p, line));
  }
  return least;
}

struct Case
{
  std::string name;
  Soup soup;
  std::size_t corners;
};

std::vector<Case> shapes()
{
  Soup plainCube = cube();
  Soup plainSphere = sphere(8, 1);
  plainCube.boundary.clear();
  plainSphere.boundary.clear();
  return { { "Cube", plainCube, 8 }, { "CubeOfSixBoundaries", cube(), 8 },
    { "Cylinder", cylinder(), 0 }, { "Sphere", plainSphere, 0 },
    { "SphereOfSixBoundaries", sphere(8, 1), 8 }, { "Halves", halves(), 0 },
    { "Thirds", thirds(), 2 } };
}

std::vector<Soup> turns(const Soup& soup)
{
  return { soup.turned(), soup.turned(0, 33).turned(1, 14), soup.turned(2, 71).turned(0, 22),
    soup.turned(1, 45).turned(2, 8) };
}

Patches patchesOf(
  const Surface& surface, const BoxedSurface& boxed, PatchMethod method, int threads)
{
  Execution execution(threads);
  PatchSpec spec;
  spec.method = method;
  return generatePatches(surface, boxed.boxes, boxed.shoeboxes, spec, execution);
}

// `moved`: by how many levels points may be off where the surface is cut.
void expectKinds(const Surface& surface, const Patches& patches, std::size_t corners, double moved)
{
  constexpr double Rounding = 2; // levels
  const std::vector<Line> features = featuresOf(surface);
  const std::set<Point> vertices(surface.vertices.begin(), surface.vertices.end());
  std::set<Point> found;
  ASSERT_EQ(patches.kinds.size(), patches.points.size());
  for (std::size_t i = 0; i < patches.points.size(); ++i)
  {
    const PointKind kind = patches.kinds[i];
    const double off = distance(toVector(patches.points[i]), features);
    ASSERT_TRUE(kind >= PointKind::OnSurface);
    ASSERT_TRUE(off > Rounding || kind >= PointKind::OnEdge);
    ASSERT_TRUE(off <= Rounding + moved || kind == PointKind::OnSurface) << off;
    if (kind == PointKind::Corner)
    {
      found.insert(patches.points[i]);
      EXPECT_TRUE(moved > 0 || vertices.count(patches.points[i]) == 1);
    }
  }
  EXPECT_EQ(found.size(), corners);
}

// Points move away from planes in each direction, and onto others as close.
double mostMoved(const Surface& surface, const Boxes& boxes)
{
  const PlaneClearance clearance(surface, boxes.planes);
  double most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::uint32_t i = 0; i + 1 < boxes.planes[axis].size(); ++i)
    {
      most = std::max(most, double(clearance.of(axis, i)));
    }
  }
  return 4 * most;
}

}

TEST(PointKinds, AreThoseOfTheSurface)
{
  for (const Case& shape : shapes())
  {
    for (const Soup& soup : turns(shape.soup))
    {
      for (const double cells : cases({ 2.3, 5.1, 9.7 }))
      {
        SCOPED_TRACE(shape.name + ", " + std::to_string(cells) + " cells");
        Execution execution;
        const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, cells));
        const BoxedSurface boxed = boxSurface(prepared, depth(1), execution);
        const Surface& surface = prepared.surface;
        expectKinds(surface, patchesOf(surface, boxed, PatchMethod::ExactFit, 1), shape.corners, 0);
        expectKinds(surface, patchesOf(surface, boxed, PatchMethod::Automatic, 1), shape.corners,
          mostMoved(surface, boxed.boxes));
      }
    }
  }
}

TEST(PointKinds, DependOnNeitherThreadsNorOrder)
{
  for (const Case& shape : shapes())
  {
    Soup soup = shape.soup.turned();
    const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, 12));
    Execution execution;
    const BoxedSurface boxed = boxSurface(prepared, {}, execution);
    const Patches one = patchesOf(prepared.surface, boxed, PatchMethod::Automatic, 1);
    const Patches three = patchesOf(prepared.surface, boxed, PatchMethod::Automatic, 3);
    EXPECT_EQ(one.points, three.points);
    EXPECT_EQ(one.kinds, three.kinds);

    std::reverse(soup.triangles.begin(), soup.triangles.end());
    std::reverse(soup.boundary.begin(), soup.boundary.end());
    const PreparedSurface reversed = prepare(soup, cellsAlongLongest(soup, 12));
    const BoxedSurface again = boxSurface(reversed, {}, execution);
    const Patches last = patchesOf(reversed.surface, again, PatchMethod::Automatic, 1);
    EXPECT_EQ(one.points, last.points);
    EXPECT_EQ(one.kinds, last.kinds);
  }
}

// Where both of its long sides are sharp, they are one line; where one is, the other is a step of the lattice off it.
TEST(PointKinds, OfAnEdgeAreTheSameBesideASliver)
{
  std::vector<Soup> soups = turns(cubeWithASliver());
  soups.push_back(cubeWithASliver()); // without area
  Execution execution;
  for (const Soup& soup : soups)
  {
    const Surface surface = prepare(soup, cellsAlongLongest(soup, 3)).surface;
    const Features features = findFeatures(surface, 30, execution);
    EXPECT_EQ(surface.vertices.size(), 9u);
    EXPECT_EQ(std::count(features.ofVertex.begin(), features.ofVertex.end(), PointKind::Corner), 8);
  }
  const Surface flat = prepare(soups.back(), cellsAlongLongest(soups.back(), 3)).surface;
  const Features features = findFeatures(flat, 30, execution);
  EXPECT_EQ(std::count(features.ofVertex.begin(), features.ofVertex.end(), PointKind::OnEdge), 1);
}

// Of the nodes at the wall, those that are corners; all are on the surface.
std::size_t cornersAtTheWall(const Assembly& assembly)
{
  const Nodes& nodes = assembly.nodes;
  EXPECT_EQ(nodes.kinds.size(), nodes.at.size());
  const WallFaces& faces = assembly.wall.faces;
  std::set<std::uint32_t> corners;
  for (std::size_t c = 0; c < faces.start[assembly.patches.size()]; ++c)
  {
    const PointKind kind = nodes.kinds[faces.corners[c]];
    EXPECT_NE(kind, PointKind::OffSurface);
    if (kind == PointKind::Corner)
    {
      corners.insert(faces.corners[c]);
    }
  }
  return corners.size();
}

// Cells as they are cut.
TestOptions unshaped()
{
  TestOptions options = asTheyAre();
  options.patches = {};
  return options;
}

TEST(PointKinds, AreKnownOfNodesAtTheWall)
{
  for (const Case& shape : shapes())
  {
    for (const Soup& soup : turns(shape.soup))
    {
      for (const double cells : cases({ 2.3, 5.1, 9.7 }))
      {
        SCOPED_TRACE(shape.name + ", " + std::to_string(cells) + " cells");
        Execution execution;
        const auto assembly =
          cutCellsOf(soup, cellsAlongLongest(soup, cells), unshaped(), execution);
        EXPECT_EQ(cornersAtTheWall(*assembly), shape.corners);
      }
    }
  }
}

TEST(PointKinds, OfNodesStayWhereOtherPartsAreLeftOut)
{
  Soup soup = cube().turned();
  soup.add(cube().turned().moved({ 3, 0.1, 0 }));
  TestOptions options = unshaped();
  Execution execution;
  EXPECT_EQ(
    cornersAtTheWall(*cutCellsOf(soup, cellsAlongLongest(soup, 20), options, execution)), 16u);
  for (const double middle : { 0.0, 3.0 })
  {
    Vector inside{ 0, 0, 0 };
    for (const Vector& p : cube().turned().points)
    {
      inside = plus(inside, scaled(p, 1.0 / 8));
    }
    options.domain.keepPoints = { plus(inside, { middle, middle / 30, 0 }) };
    EXPECT_EQ(
      cornersAtTheWall(*cutCellsOf(soup, cellsAlongLongest(soup, 20), options, execution)), 8u);
  }
}

// Rebuilding adds points.
TEST(PointKinds, OfNodesAreKnownInRebuiltBoxes)
{
  const Soup soup = kleinBottle(16);
  Execution execution;
  const auto assembly = cutCellsOf(soup, cellsAlongLongest(soup, 9.7), unshaped(), execution);
  EXPECT_FALSE(assembly->rebuilt.empty());
  cornersAtTheWall(*assembly);
}

// However the input's triangles were oriented, their normals point out of the domain afterwards.
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace cartesian;

namespace
{

Soup turnedAtRandom(Soup soup, unsigned seed)
{
  std::mt19937 random(seed);
  for (auto& triangle : soup.triangles)
  {
    if (random() % 2)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return soup;
}

Soup shuffled(Soup soup, unsigned seed)
{
  soup.boundary.clear();
  std::shuffle(soup.triangles.begin(), soup.triangles.end(), std::mt19937(seed));
  return soup;
}

using Triangle = std::array<std::uint32_t, 3>;

// The triangles by direction: each from its lowest vertex on, in order.
std::vector<Triangle> directed(const Surface& surface)
{
  std::vector<Triangle> triangles = surface.triangles;
  for (Triangle& t : triangles)
  {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

Surface surfaceOf(const Soup& soup)
{
  return prepare(soup, cellsAlongLongest(soup, 2)).inspected();
}

}

class Oriented : public ::testing::TestWithParam<NamedShape>
{
};

TEST_P(Oriented, AlreadyStaysAsItIs)
{
  const Soup& soup = GetParam().soup;
  const Surface surface = surfaceOf(soup);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    Corners given;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        given[corner][axis] =
          surface.lattice.vertex(axis, soup.points[soup.triangles[surface.given[t]][corner]][axis]);
      }
    }
    std::rotate(given.begin(), std::min_element(given.begin(), given.end()), given.end());
    ASSERT_EQ(surface.corners(t), given);
  }
}

TEST_P(Oriented, AtRandomAndInAnyOrder)
{
  const std::vector<Triangle> wanted = directed(surfaceOf(GetParam().soup));
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    EXPECT_EQ(directed(surfaceOf(turnedAtRandom(GetParam().soup, seed))), wanted);
    EXPECT_EQ(directed(surfaceOf(shuffled(turnedAtRandom(GetParam().soup, seed), seed))), wanted);
  }
}

INSTANTIATE_TEST_SUITE_P(Clean, Oriented, ::testing::ValuesIn(cleanShapes()), nameOf);
INSTANTIATE_TEST_SUITE_P(Thin, Oriented, ::testing::ValuesIn(thinShapes()), nameOf);

TEST(Orientation, RandomTrianglesGiveTheSameMesh)
{
  const Soup soup = nestedSpheres();
  const GridSpec grid = cellsAlongLongest(soup, 9.3);
  const Meshed meshed = meshOf(turnedAtRandom(soup, 1), grid);
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_TRUE(fills(meshed.mesh, soup));
  EXPECT_EQ(volumesByBox(meshed.mesh), volumesByBox(meshOf(soup, grid).mesh));
}

// Shells inside shells inside shells, all oriented outward: alternately bodies and cavities.
TEST(Orientation, ShellsAlternate)
{
  const Soup outer = sphere(4, 4);
  Soup soup = outer;
  double volume = outer.volume();
  double sign = 1;
  for (const double radius : { 3.0, 2.0, 1.0 })
  {
    const Soup shell = sphere(4, radius).moved({ 0.1, 0.2, 0.05 });
    soup.add(shell);
    sign = -sign;
    volume += sign * shell.volume();
  }
  const Meshed meshed = meshOf(soup, cellsOf(0.35));
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_TRUE(meshed.flawedBoxes.empty());
  EXPECT_NEAR(volumeOf(meshed.mesh) / volume, 1, 1e-9);
}

// Cavities too small for any vertex of the grid to lie in.
TEST(Orientation, ManySmallCavities)
{
  Soup soup = cube();
  soup.boundary.clear();
  double volume = 1;
  std::mt19937 random(7);
  for (int i = 0; i < 500; ++i)
  {
    const Vector at{ 0.05 + i % 10 * 0.1, 0.05 + i / 10 % 10 * 0.1, 0.1 + i / 100 * 0.2 };
    const Soup cavity = octahedron(0.01).turned().moved(at);
    soup.add(random() % 2 ? cavity : cavity.flipped());
    volume -= cavity.volume();
  }
  EXPECT_NEAR(volumeOf(surfaceOf(soup)), volume, 1e-9);
}

// Edges of four triangles: directions do not propagate across them, each sheet finds its own.
TEST(Orientation, SheetsBetweenNonManifoldEdges)
{
  const std::vector<double> lines{ 0, 1, 2, 3 };
  const Soup chequered =
    voxels({ lines, lines, lines }, [](int i, int j, int k) { return (i + j + k) % 2 == 0; });
  const PreparedSurface prepared = prepare(turnedAtRandom(chequered, 3), cellsOf(0.7));
  EXPECT_GT(prepared.repair.check.nonManifoldEdges, 0U);
  EXPECT_TRUE(prepared.repair.check.oriented());
  EXPECT_NEAR(volumeOf(prepared.surface), 14, 1e-7);
}

// Holes do not affect the direction elsewhere.
TEST(Orientation, AnOpenSurfaceFacesOneWay)
{
  Soup soup = sphere(8, 1);
  soup.boundary.clear();
  soup.triangles.erase(soup.triangles.begin(), soup.triangles.begin() + 100);
  const std::vector<Triangle> wanted = directed(surfaceOf(soup));
  EXPECT_EQ(directed(surfaceOf(turnedAtRandom(soup, 2))), wanted);
  EXPECT_EQ(directed(surfaceOf(turnedAtRandom(soup, 2).flipped())), wanted);
}

TEST(Orientation, OfTwoBodiesThatOverlapBothFaceOutward)
{
  const Soup left = sphere(6, 1);
  const Soup right = sphere(5, 1).moved({ 1.5, 0.1, 0.2 });
  Soup soup = left;
  const double volume = volumeOf(surfaceOf(turnedAtRandom(soup.add(right), 4)));
  EXPECT_NEAR(volume, left.volume() + right.volume(), 1e-6);
}

TEST(Orientation, DoesNotDependOnThreads)
{
  const Soup soup = turnedAtRandom(bumpySphere(1, 30), 5);
  const GridSpec grid = cellsAlongLongest(soup, 2);
  std::vector<std::vector<Triangle>> triangles;
  for (const int threads : { 1, 4 })
  {
    Execution execution(threads);
    triangles.push_back(prepare(soup, grid, execution).surface.triangles);
  }
  EXPECT_EQ(triangles[0], triangles[1]);
}

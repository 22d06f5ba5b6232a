// Depths that the surface asks for: each box is checked against the surface itself.
#include "Base/DisjointSets.h"
#include "Base/Error.h"
#include "Lattice/ExactFit.h"
#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <random>
#include <set>

namespace cartesian
{
namespace
{

int leastLevel(const PackedBox& box)
{
  return std::min({ box.level[0], box.level[1], box.level[2] });
}

Vector normalOf(const Corners& c)
{
  return unit(cross(minus(c[1], c[0]), minus(c[2], c[0])));
}

// The largest angle between normals of triangles in a box, in degrees, found pair by pair; but not of triangles
// that no others in the box connect.
double turnIn(const Surface& surface, const Box& box)
{
  std::vector<std::uint32_t> in;
  DisjointSets connected(surface.vertices.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (clip(surface.corners(t), box.low, box.high).size > 0)
    {
      const auto& [a, b, c] = surface.triangles[t];
      connected.unite(connected.unite(a, b), c);
      in.push_back(t);
    }
  }
  double most = 0;
  for (const std::uint32_t s : in)
  {
    for (const std::uint32_t t : in)
    {
      if (connected.find(surface.triangles[s][0]) == connected.find(surface.triangles[t][0]))
      {
        const Vector a = normalOf(surface.corners(s));
        const Vector b = normalOf(surface.corners(t));
        most = std::max(most, std::atan2(norm(cross(a, b)), dot(a, b)) * 180 / Pi);
      }
    }
  }
  return most;
}

Meshed boxed(const Soup& soup, double cellSize, const SizingSpec& sizing, int threads = 1)
{
  TestOptions options = asTheyAre();
  options.threads = threads;
  options.refinement.sizing = sizing;
  return meshOf(soup, cellsOf(cellSize), options);
}

TEST(Sizing, NoBoxSeesTheSurfaceTurnFurther)
{
  SizingSpec sizing;
  sizing.curvatureAngle = 25;
  sizing.largestDepth = 3;
  for (const Soup& soup : { sphere(10, 1).turned(), torus(24, 1, 0.45).turned() })
  {
    const Meshed meshed = boxed(soup, 0.5, sizing);
    const Boxes& boxes = meshed.boxed.boxes;
    std::array<int, DeepestLevel + 1> count{};
    for (std::size_t b = 0; b < boxes.packed.size(); ++b)
    {
      const Box box = boxes.box(b);
      ++count[static_cast<std::size_t>(leastLevel(box))];
      if (box.status == BoxStatus::Intersected && leastLevel(box) < sizing.largestDepth)
      {
        ASSERT_LE(turnIn(meshed.prepared.surface, box), sizing.curvatureAngle + 1e-9);
      }
    }
    EXPECT_GT(count[1] + count[2], 0) << "all boxes are of the largest depth or undivided";
    EXPECT_TRUE(isValid(meshed.mesh));
    EXPECT_TRUE(fills(meshed.mesh, soup));
  }
}

// Boxes are no smaller than that takes: what they were divided from does turn further.
TEST(Sizing, BoxesAreDividedOnlyWhereTheSurfaceTurns)
{
  const Soup soup = sphere(10, 1).turned();
  SizingSpec sizing;
  sizing.curvatureAngle = 60;
  const Meshed meshed = boxed(soup, 0.25, sizing); // a box spans 25 degrees at most
  const Meshed without = boxed(soup, 0.25, {});
  EXPECT_TRUE(meshed.mesh == without.mesh);
}

TEST(Sizing, SharpEdgesAreNoBends)
{
  SizingSpec sizing;
  sizing.curvatureAngle = 5;
  EXPECT_TRUE(boxed(cube().turned(), 0.2, sizing).mesh == boxed(cube().turned(), 0.2, {}).mesh);
}

SizingSpec forLayers()
{
  SizingSpec sizing;
  sizing.halvingsAtLayers = 2;
  sizing.layers.count = 1;
  sizing.layers.firstThickness = 1e-3;
  return sizing;
}

Meshed boxedOnce(const Soup& soup, double cellSize, const SizingSpec& sizing)
{
  TestOptions options = asTheyAre();
  options.refinement.depth = 1;
  options.refinement.sizing = sizing;
  return meshOf(soup, cellsOf(cellSize), options);
}

// But by no more than is allowed beyond the depth that is there anyway.
TEST(Sizing, WallsWithLayersTurnByNoMoreThanThese)
{
  const SizingSpec sizing = forLayers();
  for (const Soup& soup : { sphere(10, 1).turned(), torus(24, 1, 0.35).turned() })
  {
    const Meshed meshed = boxedOnce(soup, 0.9, sizing);
    const Boxes& boxes = meshed.boxed.boxes;
    int deepest = 0;
    for (std::size_t b = 0; b < boxes.packed.size(); ++b)
    {
      const Box box = boxes.box(b);
      deepest = std::max(deepest, leastLevel(box));
      if (box.status == BoxStatus::Intersected && leastLevel(box) < 3)
      {
        ASSERT_LE(turnIn(meshed.prepared.surface, box), sizing.angleAtLayers + 1e-9);
      }
    }
    EXPECT_GE(deepest, 2);
    EXPECT_LE(deepest, 3);
    EXPECT_TRUE(fills(meshed.mesh, soup));
  }
}

TEST(Sizing, WallsWithoutLayersOrWithThickOnesMayTurn)
{
  const Soup soup = torus(24, 1, 0.35).turned();
  const std::size_t boxes = boxedOnce(soup, 0.9, {}).boxed.boxes.packed.size();
  SizingSpec sizing = forLayers();
  EXPECT_GT(boxedOnce(soup, 0.9, sizing).boxed.boxes.packed.size(), boxes);
  sizing.layers.firstThickness = 0.05;
  EXPECT_EQ(boxedOnce(soup, 0.9, sizing).boxed.boxes.packed.size(), boxes);
  sizing = forLayers();
  for (std::size_t t = 0; t < soup.view().triangleCount; ++t)
  {
    sizing.layers.boundaries.push_back({ soup.boundaryOf(t), 0 });
  }
  EXPECT_EQ(boxedOnce(soup, 0.9, sizing).boxed.boxes.packed.size(), boxes);
}

TEST(Sizing, BoxesAtSharpEdgesAreOfTheFeatureDepth)
{
  SizingSpec sizing;
  sizing.featureDepth = 2;
  const Meshed meshed = boxed(cube(), 0.15, sizing);
  const Lattice& lattice = meshed.prepared.surface.lattice;
  int atEdges = 0;
  int undivided = 0;
  for (std::size_t b = 0; b < meshed.boxed.boxes.packed.size(); ++b)
  {
    const Box box = meshed.boxed.boxes.box(b);
    int faces = 0; // of the cube that pass through the box
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      const double low = lattice.position(axis, box.low[a]);
      const double high = lattice.position(axis, box.high[a]);
      faces += (low < 0 && high > 0) || (low < 1 && high > 1) ? 1 : 0;
    }
    atEdges += faces > 1 ? 1 : 0;
    undivided += faces == 1 && leastLevel(box) == 0 ? 1 : 0;
    ASSERT_GE(leastLevel(box), faces > 1 ? 2 : 0);
  }
  EXPECT_GT(atEdges, 12 * 4 * 6);
  EXPECT_GT(undivided, 6);
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_TRUE(fills(meshed.mesh, cube()));
}

// How many boxes a line passes through.
std::size_t boxesAlong(const Boxes& boxes, const Vector& from, const Vector& to)
{
  constexpr int Steps = 2000;
  std::set<std::uint32_t> met;
  for (int i = 0; i <= Steps; ++i)
  {
    FinePoint fine;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      const double place = from[a] + (to[a] - from[a]) * i / Steps;
      const auto& planes = boxes.planes[a];
      std::size_t g = 0;
      while (g + 2 < planes.size() && boxes.lattice.position(axis, planes[g + 1]) <= place)
      {
        ++g;
      }
      const double low = boxes.lattice.position(axis, planes[g]);
      const double high = boxes.lattice.position(axis, planes[g + 1]);
      fine[a] = static_cast<std::int64_t>(g) * FinePerBox +
        std::clamp(static_cast<std::int64_t>((place - low) / (high - low) * FinePerBox),
          std::int64_t(0), FinePerBox - 1);
    }
    std::int64_t step = 0;
    const std::uint32_t box = boxes.boxAt(fine, 0, step);
    if (box != None)
    {
      met.insert(box);
    }
  }
  return met.size();
}

// Between two plates, however they lie in the grid.
TEST(Sizing, AsManyBoxesFitBetweenWallsThatFaceEachOther)
{
  constexpr double Gap = 0.07;
  for (const int cells : { 2, 4, 6 })
  {
    for (const bool turned : { false, true })
    {
      SizingSpec sizing;
      sizing.cellsAcrossGaps = cells;
      sizing.largestDepth = 4;
      const auto place = [&](const Soup& soup) { return turned ? soup.turned() : soup; };
      const Soup slab = place(box({ 0, 0, 0 }, { 0.6, 0.5, Gap }));
      RefinementSpec spec;
      spec.sizing = sizing;
      Execution execution;
      const Boxes boxes = boxSurface(prepare(slab, cellsOf(0.11)), spec, execution).boxes;
      for (unsigned n = 0; n < repeats(20); ++n)
      {
        // Corners of a tiny shape tell where two points are.
        const double x = 0.05 + 0.5 * (n % 5) / 4;
        const double y = 0.05 + 0.4 * (n / 5) / 3; // NOLINT(bugprone-integer-division)
        Soup ends;
        ends.points = { { x, y, 0 }, { x, y, Gap } };
        ends = place(ends);
        ASSERT_GE(
          boxesAlong(boxes, ends.points[0], ends.points[1]), static_cast<std::size_t>(cells))
          << cells << (turned ? " turned" : "");
      }
    }
  }
}

// Nothing is divided where enough boxes fit.
TEST(Sizing, WideGapsChangeNothing)
{
  SizingSpec sizing;
  sizing.cellsAcrossGaps = 4;
  EXPECT_TRUE(boxed(cube(), 0.2, sizing).mesh == boxed(cube(), 0.2, {}).mesh);
}

TEST(Sizing, SameBoxesForAnyNumberOfThreads)
{
  SizingSpec sizing;
  sizing.curvatureAngle = 20;
  sizing.cellsAcrossGaps = 3;
  sizing.featureDepth = 2;
  const Soup soup = comb(4);
  const double size = soup.longest() / 8;
  const Meshed one = boxed(soup, size, sizing);
  EXPECT_TRUE(boxed(soup, size, sizing, 3).mesh == one.mesh);
  EXPECT_TRUE(isValid(one.mesh));
}

TEST(Sizing, ErrorsNameTheOption)
{
  const auto expectFault = [](const SizingSpec& sizing, const std::string& words) {
    try
    {
      boxed(cube(), 0.5, sizing);
      ADD_FAILURE() << "no error with \"" << words << "\"";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.fault, Fault::BadParameter);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  SizingSpec sizing;
  sizing.curvatureAngle = 181;
  expectFault(sizing, "Curvature Angle is 181");
  sizing = {};
  sizing.cellsAcrossGaps = -1;
  expectFault(sizing, "Cells Across Gaps is -1");
  sizing = {};
  sizing.featureDepth = DeepestLevel + 1;
  expectFault(sizing, "Feature Depth is 13");
  sizing = {};
  sizing.largestDepth = -2;
  expectFault(sizing, "Largest Depth is -2");
}

// In user units.
struct Range3
{
  Vector low;
  Vector high;
};

Range3 placeOf(const Boxes& boxes, const Box& box)
{
  Range3 place{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    place.low[a] = boxes.lattice.position(axis, box.low[a]);
    place.high[a] = boxes.lattice.position(axis, box.high[a]);
  }
  return place;
}

double longestEdge(const Range3& place)
{
  const Vector size = minus(place.high, place.low);
  return std::max({ size[0], size[1], size[2] });
}

// The least size that a field asks for in a box.
double wantedIn(const std::vector<WantedSize>& field, const Range3& place)
{
  double least = 1e9;
  for (const WantedSize& wanted : field)
  {
    bool overlaps = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      overlaps = overlaps && wanted.low[axis] < place.high[axis] - 1e-8 &&
        wanted.high[axis] > place.low[axis] + 1e-8;
    }
    least = overlaps ? std::min(least, wanted.size) : least;
  }
  return least;
}

// In every box: none is larger than wanted, and none as small as half of that but for balance.
TEST(Sizing, BoxesAreAsSmallAsAFieldAsks)
{
  SizingSpec sizing;
  sizing.largestDepth = 4;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 1);
  for (int i = 0; i < 60; ++i)
  {
    WantedSize wanted{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      wanted.low[axis] = place(random);
      wanted.high[axis] = wanted.low[axis] + 0.1 * place(random);
    }
    wanted.size = 0.02 + 0.3 * place(random);
    sizing.sizes.push_back(wanted);
  }
  constexpr double CellSize = 0.24;
  const Soup soup = cube();
  const Meshed meshed = boxed(soup, CellSize, sizing);
  const Boxes& boxes = meshed.boxed.boxes;
  std::array<int, DeepestLevel + 1> count{};
  for (std::size_t b = 0; b < boxes.packed.size(); ++b)
  {
    const Box box = boxes.box(b);
    const Range3 at = placeOf(boxes, box);
    ++count[static_cast<std::size_t>(leastLevel(box))];
    ASSERT_LE(longestEdge(at), wantedIn(sizing.sizes, at) * (1 + 1e-6));
  }
  EXPECT_GT(count[0] * count[1] * count[2] * count[3], 0);
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_TRUE(fills(meshed.mesh, soup));
  EXPECT_TRUE(boxed(soup, CellSize, sizing, 3).mesh == meshed.mesh);
}

// A field on the boxes of a grid that asks for one size everywhere: all are of it, within one halving.
TEST(Sizing, AFieldOfOneSizeMakesBoxesOfIt)
{
  for (const double size : { 0.2, 0.1, 0.06 })
  {
    SizingSpec sizing;
    sizing.largestDepth = 4;
    for (int i = 0; i < 10; ++i)
    {
      sizing.sizes.push_back({ { 0.1 * i, 0, 0 }, { 0.1 * (i + 1), 1, 1 }, size });
    }
    const Meshed meshed = boxed(cube(), 0.2, sizing);
    for (std::size_t b = 0; b < meshed.boxed.boxes.packed.size(); ++b)
    {
      const double edge = longestEdge(placeOf(meshed.boxed.boxes, meshed.boxed.boxes.box(b)));
      ASSERT_LE(edge, size * (1 + 1e-6));
      ASSERT_GT(edge, size / 2);
    }
  }
}

TEST(Sizing, BoxesAreAsSmallAsTrianglesAsk)
{
  const Soup soup = sphere(6, 1).turned();
  SizingSpec sizing;
  sizing.largestDepth = 3;
  for (const auto& triangle : soup.triangles)
  {
    const double x = soup.points[triangle[0]][0];
    sizing.sizeOfTriangle.push_back(x > 0.5 ? 0.06 : x > 0 ? 0.2 : 0);
  }
  const Meshed meshed = boxed(soup, 0.4, sizing);
  const Surface& surface = meshed.prepared.surface;
  int undivided = 0;
  for (std::size_t b = 0; b < meshed.boxed.boxes.packed.size(); ++b)
  {
    const Box box = meshed.boxed.boxes.box(b);
    double least = 1e9;
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    {
      const double wanted = sizing.sizeOfTriangle[surface.given[t]];
      if (wanted > 0 && clip(surface.corners(t), box.low, box.high).size > 0)
      {
        least = std::min(least, wanted);
      }
    }
    ASSERT_LE(longestEdge(placeOf(meshed.boxed.boxes, box)), least * (1 + 1e-6));
    undivided += leastLevel(box) == 0 ? 1 : 0;
  }
  EXPECT_GT(undivided, 10);
  EXPECT_TRUE(isValid(meshed.mesh));
}

}
}

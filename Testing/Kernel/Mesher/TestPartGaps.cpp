// Gaps between closed parts: rows of houses, doors in frames, whose volumes and areas are known by construction.
#include "Mesher/ClosedGaps.h"

#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace cartesian;

namespace
{

using Random = std::mt19937;

constexpr std::int32_t FirstGap = 100;
constexpr double CellSize = 0.11;

double between(Random& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Parts, and what is between them.
struct Scene
{
  Soup parts;
  double volume = 0;                             // of parts and what is closed
  double wall = 0;                               // area of parts that is left
  std::vector<std::pair<double, double>> gaps{}; // width and area of strips
};

struct Rectangle
{
  std::array<double, 2> low;
  std::array<double, 2> high;

  double side(std::size_t axis) const { return std::max(0., high[axis] - low[axis]); }
  double area() const { return side(0) * side(1); }
  double around() const { return 2 * (side(0) + side(1)); }
};

Rectangle common(const Rectangle& a, const Rectangle& b)
{
  return { { std::max(a.low[0], b.low[0]), std::max(a.low[1], b.low[1]) },
    { std::min(a.high[0], b.high[0]), std::min(a.high[1], b.high[1]) } };
}

// What ends nearly together is drawn to each other a little, so that areas would not be known.
Rectangle houseBeside(const Rectangle& before, double width, Random& random)
{
  Rectangle house;
  const auto differ = [&](double a, double b) { return a == b || std::abs(a - b) > 0.06 * width; };
  do
  {
    const bool isFlush = random() % 2 == 0;
    house = { { isFlush ? 0 : between(random, 0, 0.4), 0 },
      { isFlush ? 1 : between(random, 0.6, 1), random() % 3 == 0 ? 1 : between(random, 0.5, 1) } };
  } while (!differ(house.low[0], before.low[0]) || !differ(house.high[0], before.high[0]) ||
    !differ(house.high[1], before.high[1]));
  return house;
}

// Boxes along x, each as high and as deep as it likes; gaps up to `width` are closed.
Scene row(Random& random, double width)
{
  Scene scene;
  double x = 0;
  Rectangle before{};
  const auto houses = 2 + static_cast<int>(random() % 4);
  for (int i = 0; i < houses; ++i)
  {
    const Rectangle house = houseBeside(before, width, random);
    const double length = between(random, 0.3, 1);
    const double gap =
      width * (random() % 3 == 0 ? between(random, 1.1, 2) : between(random, 0.05, 0.95));
    if (i > 0)
    {
      x += gap;
      const Rectangle facing = common(before, house);
      if (gap < width)
      {
        scene.volume += gap * facing.area();
        scene.wall -= 2 * facing.area();
        scene.gaps.push_back({ gap, gap * facing.around() });
      }
    }
    const Soup one =
      box({ x, house.low[0], house.low[1] }, { x + length, house.high[0], house.high[1] });
    scene.parts.add(one);
    scene.volume += one.volume();
    scene.wall += one.area();
    x += length;
    before = house;
  }
  return scene;
}

// A slab with a hole, and a door in it that is as thick.
Scene doorInFrame(double slot, double thickness)
{
  const std::vector<double> lines{ 0, 0.3, 0.7, 1 };
  Scene scene;
  scene.parts =
    voxels({ lines, lines, { 0, thickness } }, [](int i, int j, int) { return i != 1 || j != 1; });
  const Soup door = box({ 0.3 + slot, 0.3 + slot, 0 }, { 0.7 - slot, 0.7 - slot, thickness });
  scene.wall = scene.parts.area() + door.area() - 4 * thickness * (0.4 + 0.4 - 2 * slot);
  scene.parts.add(door);
  scene.volume = thickness;
  const double ring = 0.16 - std::pow(0.4 - 2 * slot, 2);
  scene.gaps = { { slot, ring }, { slot, ring } };
  return scene;
}

ClosedGaps closed(const Soup& soup, double width)
{
  Options options;
  options.grid = cellsOf(CellSize * soup.longest());
  options.closeGaps = width;
  Execution execution;
  return closedGaps(soup.view(), options, execution);
}

Soup with(const Soup& open, const ClosedGaps& found)
{
  Soup soup;
  soup.points = open.points;
  for (std::size_t i = 0; i < found.added.size(); i += 3)
  {
    soup.points.push_back({ found.added[i], found.added[i + 1], found.added[i + 2] });
  }
  const auto add = [&](const std::array<std::uint32_t, 3>& triangle, std::int32_t boundary) {
    soup.triangles.push_back(triangle);
    soup.boundary.push_back(boundary);
  };
  for (std::uint32_t t = 0; t < open.triangles.size(); ++t)
  {
    if (!std::binary_search(found.replaced.begin(), found.replaced.end(), t))
    {
      add(open.triangles[t], open.boundaryOf(t));
    }
  }
  for (const ClosedGaps::Piece& piece : found.pieces)
  {
    add(piece.points, open.boundaryOf(piece.given));
  }
  for (std::size_t i = 0; i < found.gaps.size(); ++i)
  {
    for (const auto& triangle : found.gaps[i].triangles)
    {
      add(triangle, FirstGap + static_cast<std::int32_t>(i));
    }
  }
  return soup;
}

void expectClosed(const Scene& scene, const Soup& parts, double width, double scale)
{
  const ClosedGaps found = closed(parts, width * scale);
  EXPECT_TRUE(found.refused.empty());
  ASSERT_EQ(found.gaps.size(), scene.gaps.size());
  const Soup whole = with(parts, found);
  std::vector<std::pair<double, double>> gaps;
  for (std::size_t i = 0; i < found.gaps.size(); ++i)
  {
    double area = 0;
    for (std::size_t t = 0; t < whole.triangles.size(); ++t)
    {
      area += whole.boundaryOf(t) == FirstGap + static_cast<std::int32_t>(i) ? whole.area(t) : 0;
    }
    gaps.emplace_back(found.gaps[i].width / scale, area / scale / scale);
  }
  std::vector<std::pair<double, double>> expected = scene.gaps;
  std::sort(expected.begin(), expected.end());
  std::sort(gaps.begin(), gaps.end());
  double strips = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i)
  {
    EXPECT_NEAR(gaps[i].first, expected[i].first, 1e-8);
    EXPECT_NEAR(gaps[i].second, expected[i].second, 1e-8);
    strips += expected[i].second;
  }
  const PreparedSurface prepared = prepare(whole, cellsOf(CellSize * whole.longest()));
  EXPECT_TRUE(prepared.repair.check.closed());
  EXPECT_TRUE(prepared.repair.refused.empty());
  EXPECT_NEAR(volumeOf(prepared.surface) / std::pow(scale, 3), scene.volume, 1e-8);
  EXPECT_NEAR(areaOf(prepared.surface) / scale / scale, scene.wall + strips, 1e-7);
}

}

TEST(PartGaps, RowsOfHouses)
{
  for (unsigned seed = 0; seed < repeats(40); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double width = between(random, 0.02, 0.2);
    const Scene scene = row(random, width);
    const double scale = std::array{ 0.001, 1., 1000. }[seed % 3];
    const Soup parts = scene.parts.scaled(scale);
    expectClosed(scene, parts, width, scale);
    expectClosed(scene, parts.turned(int(seed % 3), 45), width, scale);
    expectClosed(scene, parts.turned(int(seed % 3), 30), width, scale);
    expectClosed(scene, parts.turned(), width, scale);
  }
}

TEST(PartGaps, DoorInItsFrame)
{
  for (const double slot : { 0.005, 0.02, 0.05 })
  {
    const Scene scene = doorInFrame(slot, 0.2);
    expectClosed(scene, scene.parts, 1.1 * slot, 1);
    expectClosed(scene, scene.parts.turned(2, 45), 1.1 * slot, 1);
    expectClosed(scene, scene.parts.turned(), 1.1 * slot, 1);
    EXPECT_TRUE(closed(scene.parts, 0.9 * slot).gaps.empty());
  }
}

TEST(PartGaps, TheMeshFillsThem)
{
  for (const unsigned seed : cases({ 1U, 2U, 3U }))
  {
    Random random(seed);
    const Scene scene = row(random, 0.1);
    const Soup parts = seed % 2 == 0 ? scene.parts : scene.parts.turned();
    const Soup whole = with(parts, closed(parts, 0.1));
    const MeshArrays mesh = meshOf(whole, cellsOf(0.11)).mesh;
    EXPECT_TRUE(isValid(mesh));
    EXPECT_TRUE(fills(mesh, whole)) << seed;
  }
}

// Two open halves of a box beside another box: strips between parts cut those between rims, too.
TEST(PartGaps, BesideStripsBetweenRims)
{
  Options options;
  options.grid = cellsOf(0.06);
  options.closeGaps = 0.2;
  Execution execution;
  for (const double height : { 1.0, 0.8, 0.4 })
  {
    Soup parts;
    for (const bool isUpper : { false, true })
    {
      Soup half = box({ 0, 0, isUpper ? 0.55 : 0 }, { 1, 1, isUpper ? 1 : 0.45 });
      const std::size_t rim = isUpper ? 4 : 5; // its boundary, two triangles
      half.triangles.erase(half.triangles.begin() + std::ptrdiff_t(2 * rim),
        half.triangles.begin() + std::ptrdiff_t(2 * rim + 2));
      half.boundary.clear();
      parts.add(half);
    }
    Soup other = box({ 1.07, 0, 0 }, { 2.07, height, height });
    other.boundary.clear();
    parts.add(other);
    for (const Soup& turned : { parts, parts.turned(2, 45), parts.turned() })
    {
      const ClosedGaps found = closedGaps(turned.view(), options, execution);
      ASSERT_EQ(found.gaps.size(), 2U);
      EXPECT_NEAR(found.gaps[0].width, 0.1, 1e-6);
      EXPECT_NEAR(found.gaps[1].width, 0.07, 1e-6);
      const PreparedSurface prepared = prepare(with(turned, found), options.grid);
      EXPECT_TRUE(prepared.repair.check.closed());
      EXPECT_NEAR(volumeOf(prepared.surface), 1 + 1.07 * height * height, 1e-6);
    }
  }
}

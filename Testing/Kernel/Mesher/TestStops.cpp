// Whatever takes longer than a second reports and can be stopped within one, in every stage: where a surface has
// many more triangles than the grid has boxes, where most of them are in one box, and where they meet in one point.
#include "Support/Effort.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <random>

using namespace cartesian;

namespace
{

constexpr double LongestSilence = 1; // second

// Two cones on one rim.
Soup fan(std::uint32_t count)
{
  const double angle = 2 * Pi / count;
  Soup soup;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    soup.points.push_back({ std::cos(angle * i), std::sin(angle * i), 0 });
    const std::uint32_t next = (i + 1) % count;
    soup.triangles.push_back({ i, next, count });
    soup.triangles.push_back({ next, i, count + 1 });
  }
  soup.points.push_back({ 0, 0, 0.5 });
  soup.points.push_back({ 0, 0, -0.5 });
  return soup;
}

// A cube with a dense ball in it: 12 * n * n triangles in one box of the grid, or in a few. Rough, as a part of its
// radius: most of them are of a shape that solvers refuse.
Soup denseSpot(int n, double roughness = 0)
{
  Soup soup = box({ -1, -1, -1 }, { 1, 1, 1 });
  soup.boundary.clear();
  Soup spot = sphere(n, 0.05);
  std::mt19937 random(1);
  for (Vector& point : spot.points)
  {
    point = scaled(point, 1 + roughness * static_cast<double>(random()) / 4294967296.0);
  }
  spot = spot.moved({ 0.02, 0.03, 0.05 }).flipped();
  spot.boundary.clear();
  return soup.add(spot);
}

// Of processor time: what else runs on the machine does not count.
double now()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Silence
{
  double seconds = 0;
  std::string stage;
};

Silence longestSilence(const Soup& soup, double cells, PatchMethod method)
{
  Silence longest;
  double last = now();
  std::string before;
  const auto hear = [&](double, const char* stage) {
    if (now() - last > longest.seconds)
    {
      longest = { now() - last, before };
    }
    last = now();
    before = stage;
    return true;
  };
  TestOptions options;
  options.patches.method = method;
  options.grid = cellsAlongLongest(soup, cells);
  options.memoryLimit = PlentyOfMemory;
  Execution execution(1, hear);
  EXPECT_GT(mesh(soup.view(), options, execution)->mesh->cellCount(), 0);
  return longest;
}

}

TEST(Stops, NoStageIsSilentForASecond)
{
  constexpr std::uint32_t Most = RepeatedLess == 1 ? 1 : 20;
  struct Case
  {
    std::string name;
    Soup soup;
    double cells;
  };
  const std::vector<Case> all{ { "Sphere", sphere(RepeatedLess == 1 ? 150 : 40, 1), 12 },
    { "Fan", fan(20000 / Most), 16 }, { "DenseSpot", denseSpot(RepeatedLess == 1 ? 91 : 20), 15 },
    { "RoughSpot", denseSpot(RepeatedLess == 1 ? 75 : 15, 0.01), 15 } };
  for (const Case& c : all)
  {
    for (const PatchMethod method : { PatchMethod::Automatic, PatchMethod::ExactFit })
    {
      const Silence silence = longestSilence(c.soup, c.cells, method);
      EXPECT_LT(silence.seconds, LongestSilence) << c.name << ", " << silence.stage;
    }
  }
}

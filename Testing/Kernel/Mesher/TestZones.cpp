// Zones of a flow domain: volumes and areas by construction, whatever passes through their borders.
#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

constexpr std::int32_t Body = 0;
constexpr std::int32_t FirstZone = 10;

// Of one boundary.
void add(Soup part, std::int32_t boundary, Soup& soup)
{
  part.boundary.assign(part.triangles.size(), boundary);
  soup.add(part);
}

TestOptions around(double cellSize, std::int32_t zones)
{
  TestOptions options;
  options.grid = cellsOf(cellSize);
  options.domain.domain = Domain::Outside;
  options.domain.boxFrom = BoxSource::Bounds;
  options.domain.bounds = { { -3, -3, -3 }, { 3, 3, 3 } };
  options.domain.boxesAlong = 0;
  options.patches.method = PatchMethod::ExactFit;
  for (std::int32_t zone = 0; zone < zones; ++zone)
  {
    options.zones.push_back(FirstZone + zone);
  }
  return options;
}

MeshArrays meshed(const Soup& soup, const TestOptions& options)
{
  return meshOf(soup, options.grid, options).mesh;
}

// A bar from -2 to 2 along x through a zone from -1 to 1.
Soup barThroughAZone()
{
  Soup soup;
  add(box({ -2, -0.25, -0.25 }, { 2, 0.25, 0.25 }), Body, soup);
  add(box({ -1, -1, -1 }, { 1, 1, 1 }), FirstZone, soup);
  return soup;
}

}

TEST(Zones, ABodyPassesThrough)
{
  for (const double size : { 0.7, 0.45, 0.31 })
  {
    for (const Soup& soup : { barThroughAZone(), barThroughAZone().turned(2, 45),
           barThroughAZone().turned(0, 30), barThroughAZone().turned() })
    {
      const MeshArrays mesh = meshed(soup, around(size, 1));
      EXPECT_TRUE(isValid(mesh, true));
      const std::map<int, double> volumes = volumesByRegion(mesh);
      ASSERT_EQ(volumes.size(), 2U);
      EXPECT_NEAR(volumes.at(1), 216 - 8 - 0.5, 1e-6);
      EXPECT_NEAR(volumes.at(2), 8 - 0.5, 1e-6);
      const auto areas = areasBetweenRegions(mesh);
      EXPECT_NEAR(areas.at({ 1, 2 }), 24 - 2 * 0.25, 1e-6);
      EXPECT_NEAR(areasByBoundary(mesh).at(Body), 4 * 4 * 0.5 + 2 * 0.25, 1e-6);
    }
  }
}

TEST(Zones, AloneAndSeveral)
{
  Soup soup;
  add(box({ -1, -1, -1 }, { 0, 1, 1 }), FirstZone, soup);
  std::map<int, double> volumes = volumesByRegion(meshed(soup.turned(), around(0.4, 1)));
  EXPECT_NEAR(volumes.at(1), 216 - 4, 1e-6);
  EXPECT_NEAR(volumes.at(2), 4, 1e-6);
  // Where they overlap, the first wins; they may touch.
  add(box({ -0.5, -1, -1 }, { 1, 1, 1 }), FirstZone + 1, soup);
  volumes = volumesByRegion(meshed(soup.turned(), around(0.4, 2)));
  EXPECT_NEAR(volumes.at(1), 216 - 8, 1e-6);
  EXPECT_NEAR(volumes.at(2), 4, 1e-6);
  EXPECT_NEAR(volumes.at(3), 4, 1e-6);
}

TEST(Zones, ABodyThatDividesThemLeavesBothParts)
{
  Soup soup;
  add(box({ -2, -2, -0.1 }, { 2, 2, 0.1 }), Body, soup);
  add(box({ -1, -1, -1 }, { 1, 1, 1 }), FirstZone, soup);
  const std::map<int, double> volumes =
    volumesByRegion(meshed(soup.turned(1, 20), around(0.45, 1)));
  EXPECT_NEAR(volumes.at(2), 8 * 0.9, 1e-6);
  EXPECT_NEAR(volumes.at(1), 216 - 8 * 0.9 - 16 * 0.2, 1e-6);
}

TEST(Zones, WhatDoesNotFitIsTold)
{
  TestOptions inside = around(0.7, 1);
  inside.domain.domain = Domain::Inside;
  EXPECT_THROW(meshed(barThroughAZone(), inside), Error);
  TestOptions keeping = around(0.7, 1);
  keeping.domain.keepPoints.push_back({ 2.5, 2.5, 2.5 });
  EXPECT_THROW(meshed(barThroughAZone(), keeping), Error);
  TestOptions closing = around(0.7, 1);
  closing.closeGaps = 0.1;
  EXPECT_THROW(meshed(barThroughAZone(), closing), Error);
}

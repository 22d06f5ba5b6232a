// Nodes along the rim of a sheet in a box: those near to the chord go, and what is left is closed.
#include "Patches/RimNodeRemoval.h"

#include <gtest/gtest.h>

#include <map>

using namespace cartesian;

namespace
{

constexpr Level Size = 10000;      // of the box
constexpr std::uint32_t Front = 5; // apexes
constexpr std::uint32_t Back = 6;

// A sheet with an apex for each of its sides on the box's lower side, and a rim of five nodes, `off` the straight line.
class Sheet
{
public:
  explicit Sheet(const std::array<Level, 3>& off)
  {
    BoxSurface piece;
    std::vector<Point>& points = piece.points;
    for (Level i = 0; i < 5; ++i)
    {
      const Level x = i == 0 ? 0 : (i == 4 ? Size : i * Size / 4 + 1);
      points.push_back({ x, 5001 + (i == 0 || i == 4 ? 0 : off[i - 1]), 5001 });
    }
    points.push_back({ 4001, 0, 5003 });
    points.push_back({ 4001, 0, 4999 });
    Box box{};
    box.high = { Size, Size, Size };
    polygons_.begin(box, piece, 1);
    for (std::uint32_t i = 0; i < 4; ++i)
    {
      add({ i + 1, i, Front }, { 0, 0, 1 });
      add({ i, i + 1, Back }, { 0, 0, -1 });
      rims_.push_back({ i, i + 1, 0, false });
    }
  }

  void removeNodes() { RimNodeRemoval(polygons_).run(rims_, 0.1); }

  std::vector<std::uint32_t> nodesLeft() const
  {
    std::vector<std::uint32_t> nodes;
    forEach([&](const Polygon& polygon) {
      const std::uint32_t* const c = polygons_.cornersOf(polygon);
      nodes.insert(nodes.end(), c, c + polygon.size);
    });
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  // Each edge inside the box as often in one direction as in the other.
  bool isClosed() const
  {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    forEach([&](const Polygon& polygon) {
      const std::uint32_t* const c = polygons_.cornersOf(polygon);
      for (std::uint32_t i = 0; i < polygon.size; ++i)
      {
        const std::uint32_t a = c[i];
        const std::uint32_t b = c[(i + 1) % polygon.size];
        if (std::max(a, b) < Front || (std::min(a, b) > 0 && std::min(a, b) < 4))
        {
          uses[std::minmax(a, b)] += a < b ? 1 : -1;
        }
      }
    });
    return std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 0; });
  }

private:
  void add(const std::array<std::uint32_t, 3>& corners, const Vector& normal)
  {
    polygons_.append(corners.data(), corners.data() + 3, {}, { normal, 0 });
  }

  template <class Visitor>
  void forEach(Visitor&& visit) const
  {
    for (const Polygon& polygon : polygons_.polygons)
    {
      if (polygon.alive)
      {
        visit(polygon);
      }
    }
  }

  BoxPolygons polygons_;
  std::vector<PolygonEdge> rims_;
};

std::vector<std::uint32_t> leftOf(const std::array<Level, 3>& off)
{
  Sheet sheet(off);
  sheet.removeNodes();
  EXPECT_TRUE(sheet.isClosed());
  return sheet.nodesLeft();
}

}

using Nodes = std::vector<std::uint32_t>;

TEST(RimNodeRemoval, StraightRimsHaveNoNodesInside)
{
  EXPECT_EQ(leftOf({ 0, 0, 0 }), (Nodes{ 0, 4, Front, Back }));
}

// A hundredth of the box's side is too near to the chord to be seen.
TEST(RimNodeRemoval, WhatCanBeSeenStays)
{
  EXPECT_EQ(leftOf({ 0, 40, 0 }), (Nodes{ 0, 4, Front, Back }));
  EXPECT_EQ(leftOf({ 0, 150, 0 }), (Nodes{ 0, 2, 4, Front, Back }));
  EXPECT_EQ(leftOf({ 400, 0, 400 }), (Nodes{ 0, 1, 2, 3, 4, Front, Back }));
}

// Each step is small, all of them are not.
TEST(RimNodeRemoval, WhatIsRemovedAddsUp)
{
  const Nodes left = leftOf({ 120, 160, 120 });
  EXPECT_EQ(left.size(), 5U);
}

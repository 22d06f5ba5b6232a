// The pieces of a triangle lie in the rows that they are said to, and share their cut edges.
#include "Lattice/TriangleSlicing.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace cartesian;

namespace
{

Corners randomTriangle(std::mt19937& random, Level width)
{
  Corners t;
  for (Point& p : t)
  {
    for (Level& level : p)
    {
      level = 1 + 2 * static_cast<Level>(random() % width);
    }
  }
  return t;
}

// Whether levels lie in an interval of the planes, which is half open or reaches to infinity.
bool liesIn(
  const std::pair<Level, Level>& range, std::int64_t interval, const std::vector<Level>& planes)
{
  const auto last = static_cast<std::int64_t>(planes.size()) - 1;
  return (interval < 0 || range.first >= planes[static_cast<std::size_t>(interval)]) &&
    (interval >= last || range.second <= planes[static_cast<std::size_t>(interval + 1)]);
}

}

TEST(TriangleSlicing, PiecesLieInTheirRows)
{
  std::mt19937 random(2);
  constexpr Level Width = 50;
  for (unsigned i = 0; i < 500; ++i)
  {
    const Corners t = randomTriangle(random, Width);
    Meshlines planes;
    for (auto& lines : planes)
    {
      std::set<Level> levels;
      while (levels.size() < 2 + i % 7)
      {
        levels.insert(2 * static_cast<Level>(random() % Width));
      }
      lines.assign(levels.begin(), levels.end());
    }
    for (const RowAxes& axes : RowsAlong)
    {
      std::set<std::pair<std::int64_t, std::int64_t>> rows;
      std::set<Point> corners;
      forEachRowPiece(
        t, axes, planes, [&](std::int64_t middle, std::int64_t outer, const Fragment& piece) {
          ASSERT_GE(piece.size, 3);
          EXPECT_TRUE(liesIn(rangeOf(piece, axes.outer), outer, planes[axes.outer]));
          EXPECT_TRUE(liesIn(rangeOf(piece, axes.middle), middle, planes[axes.middle]));
          EXPECT_TRUE(rows.emplace(middle, outer).second);
          corners.insert(piece.corner.begin(), piece.corner.begin() + piece.size);
        });
      for (const Point& corner : t) // none is lost
      {
        EXPECT_EQ(corners.count(corner), 1u);
      }
    }
  }
}

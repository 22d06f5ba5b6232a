// Each kind of defect is found where it is, and no other.
#include "Repair/SurfaceDefects.h"

#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

using namespace cartesian;

namespace
{

SurfaceDefects defectsOf(const Soup& soup, const GridSpec& grid, int threads = 1)
{
  const PreparedSurface prepared = prepare(soup, grid);
  Execution execution(threads);
  SurfaceDefects defects = findDefects(prepared.inspected(), prepared.trianglesGiven(),
    prepared.repair, prepared.cracks, prepared.planes, execution);
  for (Defect& defect : defects.defects) // as the soup numbers them
  {
    for (std::uint32_t* const triangle : { &defect.triangle, &defect.other })
    {
      *triangle =
        *triangle == SurfaceDefects::None ? *triangle : prepared.inspected().given[*triangle];
    }
  }
  return defects;
}

SurfaceDefects defectsOf(const Soup& soup)
{
  return defectsOf(soup, cellsAlongLongest(soup, 10));
}

using Counts = std::map<DefectKind, std::size_t>;

Counts countsOf(const SurfaceDefects& defects)
{
  Counts counts;
  for (std::size_t k = 0; k < DefectKinds; ++k)
  {
    if (defects.counts[k] > 0)
    {
      counts[static_cast<DefectKind>(k)] = defects.counts[k];
    }
  }
  return counts;
}

Soup unmarked(Soup soup)
{
  soup.boundary.clear();
  return soup;
}

}

class NoDefects : public ::testing::TestWithParam<NamedShape>
{
};

TEST_P(NoDefects, InACleanSurface)
{
  const SurfaceDefects defects = defectsOf(GetParam().soup);
  Counts counts = countsOf(defects);
  counts.erase(DefectKind::NonManifoldEdge); // of bodies that touch
  counts.erase(DefectKind::SmallComponent);
  EXPECT_TRUE(counts.empty()) << static_cast<int>(counts.begin()->first);
  EXPECT_EQ(describe(defects, {}), "");
}

INSTANTIATE_TEST_SUITE_P(Clean, NoDefects, ::testing::ValuesIn(cleanShapes()), nameOf);

TEST(SurfaceDefects, OpenEdgesAndTheHole)
{
  Soup soup = unmarked(sphere(5, 1));
  const auto lost = soup.triangles[30];
  soup.triangles.erase(soup.triangles.begin() + 30);
  const SurfaceDefects defects = defectsOf(soup, cellsOf(0.5));
  EXPECT_EQ(countsOf(defects), (Counts{ { DefectKind::OpenEdge, 3 }, { DefectKind::Hole, 1 } }));
  ASSERT_EQ(defects.defects.size(), 4U);
  const Defect& hole = defects.defects[3];
  EXPECT_EQ(hole.triangle, SurfaceDefects::None);
  ASSERT_EQ(hole.size, 4U);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector& p = defects.points[6 + i];
    EXPECT_TRUE(std::any_of(lost.begin(), lost.end(), [&](std::uint32_t corner) {
      const Vector& q = soup.points[corner];
      return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < 1e-8;
    }));
  }
  EXPECT_EQ(countsOf(defectsOf(soup, cellsOf(0.05))),
    (Counts{ { DefectKind::OpenEdge, 3 }, { DefectKind::Leak, 1 } }));
}

TEST(SurfaceDefects, NonManifoldEdges)
{
  const Soup soup = unmarked(cube().add(cube().moved({ 1, 1, 0 })));
  const SurfaceDefects defects = defectsOf(soup);
  EXPECT_EQ(countsOf(defects), (Counts{ { DefectKind::NonManifoldEdge, 1 } }));
  EXPECT_EQ(defects.components, 1U);
}

TEST(SurfaceDefects, InconsistentEdges)
{
  const SurfaceDefects defects = defectsOf(kleinBottle(24));
  EXPECT_GT(countsOf(defects)[DefectKind::InconsistentEdge], 0U);
  EXPECT_EQ(countsOf(defects)[DefectKind::OpenEdge], 0U);
}

TEST(SurfaceDefects, DegenerateAndDuplicateTriangles)
{
  Soup soup = unmarked(sphere(5, 1));
  const auto count = static_cast<std::uint32_t>(soup.triangles.size());
  soup.triangles.push_back({ 3, 3, 4 });
  soup.triangles.push_back({ 7, 7, 7 });
  soup.triangles.push_back({ soup.triangles[9][1], soup.triangles[9][0], soup.triangles[9][2] });
  const SurfaceDefects defects = defectsOf(soup);
  EXPECT_EQ(countsOf(defects),
    (Counts{ { DefectKind::DegenerateTriangle, 2 }, { DefectKind::DuplicateTriangle, 1 } }));
  EXPECT_EQ((std::set{ defects.defects[0].triangle, defects.defects[1].triangle }),
    (std::set{ count, count + 1 }));
  EXPECT_TRUE(defects.defects[2].triangle == 9 || defects.defects[2].triangle == count + 2);
}

// A flap at an edge: three triangles meet there, two of which lie on each other.
TEST(SurfaceDefects, AFoldAndAnOverlap)
{
  Soup soup = unmarked(cube());
  soup.points.push_back({ 0.5, 0.25, 0 });
  const auto flap = static_cast<std::uint32_t>(soup.points.size() - 1);
  const auto at = [&](const Vector& p) {
    return static_cast<std::uint32_t>(
      std::find(soup.points.begin(), soup.points.end(), p) - soup.points.begin());
  };
  soup.triangles.push_back({ at({ 0, 0, 0 }), at({ 1, 0, 0 }), flap });
  const SurfaceDefects defects = defectsOf(soup);
  std::vector<long long> numbers(100);
  std::iota(numbers.begin(), numbers.end(), 1000);
  Counts counts = countsOf(defects);
  EXPECT_EQ(counts[DefectKind::FoldedTriangle], 2U);
  // One of the two triangles of that wall has the flap's edge; the flap may reach the other.
  EXPECT_LE(counts[DefectKind::OverlappedTriangle], 2U);
  EXPECT_EQ(counts[DefectKind::Intersection], 0U);
  EXPECT_NE(describe(defects, numbers).find("2 triangles are folded"), std::string::npos);

  const Soup walls = unmarked(cube().add(cube().moved({ 1, 0.5, 0.25 })));
  const SurfaceDefects overlapping = defectsOf(walls);
  EXPECT_GE(countsOf(overlapping)[DefectKind::OverlappedTriangle], 3U);
  // The first 20 are named, by the user's numbers.
  const std::string text = describe(overlapping, numbers);
  EXPECT_NE(text.find(" triangles overlap others in the same plane.\n  cell 1"), std::string::npos)
    << text;
  std::size_t named = 0;
  for (std::size_t i = 0; (i = text.find("\n  cell ", i)) != std::string::npos; ++i)
  {
    ++named;
  }
  EXPECT_EQ(
    named, std::min<std::size_t>(20, countsOf(overlapping)[DefectKind::OverlappedTriangle]));
}

TEST(SurfaceDefects, Intersections)
{
  const Soup bar = box({ 0.25, 0.25, -1 }, { 0.75, 0.75, 2 });
  const Soup soup = unmarked(cube().add(bar));
  const SurfaceDefects defects = defectsOf(soup, cellsOf(0.2));
  const Counts counts = countsOf(defects);
  ASSERT_EQ(counts.size(), 1U);
  double length = 0;
  std::size_t point = 0;
  for (const Defect& defect : defects.defects)
  {
    EXPECT_EQ(defect.kind, DefectKind::Intersection);
    EXPECT_NE(defect.triangle < 12, defect.other < 12);
    const Vector& p = defects.points[point];
    const Vector& q = defects.points[point + 1];
    length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    point += defect.size;
  }
  EXPECT_NEAR(length, 2 * 4 * 0.5, 1e-6); // around the bar, twice
  EXPECT_EQ(defects.components, 2U);

  // The message names the first, in the middle of the line that the two share.
  std::vector<long long> numbers(24);
  std::iota(numbers.begin(), numbers.end(), 1000);
  const Defect& first = defects.defects.front();
  const Vector& p = defects.points[0];
  const Vector& q = defects.points[1];
  const std::string place = " pairs of triangles intersect.\n  cells " +
    std::to_string(1000 + first.triangle) + " and " + std::to_string(1000 + first.other) + " at (" +
    number((p[0] + q[0]) / 2) + ", ";
  const std::string text = describe(defects, numbers);
  EXPECT_NE(text.find(place), std::string::npos) << text << " has no " << place;
  EXPECT_EQ(std::count(text.begin(), text.end(), '('), 5);
}

Soup inSinglePrecision(const Soup& soup)
{
  return soup.each([](const Vector& p) {
    return Vector{ double(float(p[0])), double(float(p[1])), double(float(p[2])) };
  });
}

// Two bodies on either side of the plane z = 0: with an edge of one on a face of the other, with two corners nearly in
// one place, and with faces that lie on each other in part.
std::array<Soup, 2> touchingBodies(int kind)
{
  if (kind == 0)
  {
    const double half = 0.35;
    return { box({ -1, -1, -0.5 }, { 1, 1, 0 }),
      box({ -half, -0.7, -half }, { half, 0.7, half })
        .turned(1, 45)
        .moved({ 0.1, 0, half * std::sqrt(2) }) };
  }
  if (kind == 1)
  {
    const Soup below =
      tetrahedron({ Vector{ 0.0766524, 0.8413099, 0 }, Vector{ 0.0152397, -0.1574662, 0 },
        Vector{ 0.3162846, -0.069862, 0 }, Vector{ -0.8098497, -0.2421195, -0.3950971 } });
    const Soup above =
      tetrahedron({ Vector{ 0.0766584, 0.8413478, 0 }, Vector{ -0.121379, -0.8584462, 0 },
        Vector{ -0.773944, -0.4751688, 0.3756258 }, Vector{ 0.0485714, -0.7876475, 0.1974652 } });
    return { below, above };
  }
  return { box({ -1, -1, -0.5 }, { 1, 1, 0 }),
    box({ -0.3, -0.4, 0 }, { 0.5, 1.3, 0.7 }).turned(2, 20) };
}

// However they are turned and rounded, so that in truth they cross by less than that, or are apart.
TEST(SurfaceDefects, BodiesThatOnlyTouchDoNotIntersect)
{
  for (int kind = 0; kind < 3; ++kind)
  {
    for (const double size : { 1.0, 0.01, 300.0 })
    {
      for (int way = 0; way < 8; ++way)
      {
        SCOPED_TRACE(testing::Message() << kind << " of " << size << " way " << way);
        const auto prepared = [&](double sunk) {
          const std::array<Soup, 2> bodies = touchingBodies(kind);
          Soup soup = unmarked(Soup(bodies[0]).add(bodies[1].moved({ 0, 0, -sunk })));
          soup = (way % 4 == 0 ? soup
              : way % 4 == 1   ? soup.turned(2, 17)
              : way % 4 == 2   ? soup.turned(0, 30).turned(1, 45)
                               : soup.turned())
                   .scaled(size);
          return defectsOf(way < 4 ? soup : inSinglePrecision(soup), cellsAlongLongest(soup, 10));
        };
        EXPECT_EQ(countsOf(prepared(0))[DefectKind::Intersection], 0U);
        EXPECT_GE(countsOf(prepared(0.01))[DefectKind::Intersection], 4U); // now they cross
      }
    }
  }
}

TEST(SurfaceDefects, SmallComponents)
{
  const Soup soup = unmarked(
    cube().add(octahedron(0.04).moved({ 0.5, 0.5, 0.5 })).add(octahedron(0.2).moved({ 3, 0, 0 })));
  const SurfaceDefects defects = defectsOf(soup, cellsOf(0.1));
  EXPECT_EQ(countsOf(defects), (Counts{ { DefectKind::SmallComponent, 8 } }));
  EXPECT_EQ(defects.components, 3U);
  for (const Defect& defect : defects.defects)
  {
    EXPECT_GE(defect.triangle, 12U);
    EXPECT_LT(defect.triangle, 20U);
  }
}

TEST(SurfaceDefects, DoNotDependOnThreads)
{
  Soup soup = unmarked(bumpySphere(1, 20));
  soup.add(unmarked(bumpySphere(2, 17)).moved({ 0.3, 0.2, 0.1 }));
  soup.boundary.clear();
  soup.triangles.resize(soup.triangles.size() - 30);
  const SurfaceDefects one = defectsOf(soup, cellsOf(0.2), 1);
  const SurfaceDefects many = defectsOf(soup, cellsOf(0.2), 4);
  EXPECT_GT(countsOf(one)[DefectKind::Intersection], 100U);
  EXPECT_EQ(one.points, many.points);
  EXPECT_EQ(countsOf(one), countsOf(many));
}

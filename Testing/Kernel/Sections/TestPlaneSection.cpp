// Sections of cells whose areas are known, or are those of their parts.
#include "Sections/CellDivision.h"
#include "Sections/PlaneSection.h"
#include "Sections/PolygonBridges.h"
#include "Support/CellFacesOf.h"

#include <random>

using namespace cartesian;

namespace
{

PlaneSection cut(const FacedCells& mesh, const SectionPlane& plane, int threads = 1)
{
  std::vector<double> heights;
  for (std::uint32_t i = 0; i < mesh.points.size() / 3; ++i)
  {
    heights.push_back(plane.height(mesh.at(i)));
  }
  Execution execution(threads);
  return planeSection(mesh.cells, mesh.points.data(), heights, plane, execution);
}

double areaOf(const PlaneSection& section, std::size_t polygon, const Vector& normal)
{
  Vector twice{};
  const std::size_t first = section.firstCorner[polygon];
  const Vector& origin = section.points[section.corners[first]];
  for (std::size_t i = first + 1; i + 1 < section.firstCorner[polygon + 1]; ++i)
  {
    twice = plus(twice,
      cross(minus(section.points[section.corners[i]], origin),
        minus(section.points[section.corners[i + 1]], origin)));
  }
  return dot(twice, normal) / 2;
}

std::vector<double> areasOf(const PlaneSection& section, const Vector& normal, std::size_t cells)
{
  std::vector<double> areas(cells);
  for (std::size_t i = 0; i < section.count(); ++i)
  {
    areas[section.cell[i]] += areaOf(section, i, normal);
  }
  return areas;
}

double sumOf(const std::vector<double>& values)
{
  double sum = 0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum;
}

Polyhedron cubeAt(double x, double y, double z)
{
  const auto at = [&](double i, double j, double k) { return Vector{ x + i, y + j, z + k }; };
  return { { at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0) },
    { at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1) },
    { at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1) },
    { at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0) },
    { at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0) },
    { at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1) } };
}

FacedCells block(int n)
{
  std::vector<Polyhedron> cells;
  for (int i = 0; i < n * n * n; ++i)
  {
    cells.push_back(cubeAt(i % n, i / n % n, i / (n * n)));
  }
  return facedCells(cells);
}

// The parts of the cells as cells, and the cell of each.
FacedCells partsOf(
  const FacedCells& mesh, const CellDivision& division, std::vector<std::uint32_t>& cellOf)
{
  const FaceCorners corners(mesh.cells, mesh.points.data());
  std::vector<Polyhedron> parts;
  for (std::uint32_t cell = 0; cell < mesh.cells.cellCount(); ++cell)
  {
    const Vector& top = division.centres[cell];
    for (std::size_t face = mesh.cells.firstFace[cell]; face < mesh.cells.firstFace[cell + 1];
         ++face)
    {
      const std::uint32_t fan = division.fans.fanOf[face];
      const std::size_t size = corners.size(face);
      const std::size_t count = fan == NoPoint ? size - 2 : size;
      for (std::size_t i = 0; i < count; ++i)
      {
        const Vector a = fan == NoPoint ? corners.corner(face, 0) : division.fans.centres[fan];
        const Vector b = corners.corner(face, fan == NoPoint ? i + 1 : i);
        const Vector c = corners.corner(face, fan == NoPoint ? i + 2 : (i + 1) % size);
        parts.push_back({ { a, b, c }, { b, a, top }, { c, b, top }, { a, c, top } });
        cellOf.push_back(cell);
      }
    }
  }
  return facedCells(parts);
}

}

TEST(PlaneSection, AFaceInThePlaneBelongsToTheCellBelow)
{
  const FacedCells mesh = block(3);
  for (const auto& [offset, area] : std::vector<std::pair<double, double>>{
         { 0, 0 }, { 0.5, 9 }, { 1, 9 }, { 2, 9 }, { 3, 9 }, { 4, 0 } })
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      Vector normal{};
      normal[axis] = 1;
      const PlaneSection section = cut(mesh, { { 0, 0, 0 }, normal, offset });
      EXPECT_EQ(section.count(), static_cast<std::size_t>(area));
      EXPECT_EQ(section.points.size(), area > 0 ? 16u : 0u);
      EXPECT_DOUBLE_EQ(sumOf(areasOf(section, normal, 27)), area);
    }
  }
}

TEST(PlaneSection, ThroughEdgesAndCornersHasTheExactArea)
{
  const FacedCells mesh = block(3);
  // Through an edge of each cell on the diagonal.
  const Vector normal = unit({ 1, -1, 0 });
  EXPECT_NEAR(
    sumOf(areasOf(cut(mesh, { { 0, 0, 0 }, normal, 0 }), normal, 27)), 9 * std::sqrt(2), 1e-12);
  // A regular hexagon through corners.
  const Vector diagonal = unit({ 1, 1, 1 });
  const double side = 3 / std::sqrt(2);
  EXPECT_NEAR(sumOf(areasOf(cut(mesh, { { 1.5, 1.5, 1.5 }, diagonal, 0 }), diagonal, 27)),
    1.5 * std::sqrt(3) * side * side, 1e-12);
}

TEST(PlaneSection, OfACellInTwoPartsHasTwoPolygons)
{
  // A U.
  const std::vector<std::array<double, 2>> base{ { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 },
    { 1, 1 }, { 1, 3 }, { 0, 3 } };
  Polygon front;
  Polygon back;
  Polyhedron cell;
  for (std::size_t i = 0; i < base.size(); ++i)
  {
    const auto& [x, z] = base[i];
    const auto& [u, w] = base[(i + 1) % base.size()];
    front.push_back({ x, 0, z });
    back.insert(back.begin(), { x, 1, z });
    cell.push_back({ { x, 0, z }, { x, 1, z }, { u, 1, w }, { u, 0, w } });
  }
  cell.push_back(front);
  cell.push_back(back);
  const FacedCells mesh = facedCells({ cell });
  const Vector up{ 0, 0, 1 };
  const PlaneSection section = cut(mesh, { { 0, 0, 0 }, up, 2 });
  ASSERT_EQ(section.count(), 2u);
  EXPECT_DOUBLE_EQ(areaOf(section, 0, up), 1);
  EXPECT_DOUBLE_EQ(areaOf(section, 1, up), 1);
  EXPECT_EQ(cut(mesh, { { 0, 0, 0 }, up, 0.5 }).count(), 1u);
}

TEST(PlaneSection, OfARingIsOnePolygonWithABridge)
{
  Polyhedron cell;
  const auto wall = [&](double x, double y, double u, double w) {
    cell.push_back({ { x, y, 0 }, { u, w, 0 }, { u, w, 1 }, { x, y, 1 } });
  };
  const std::array<std::array<double, 2>, 4> outer{ { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 } } };
  const std::array<std::array<double, 2>, 4> inner{ { { 1, 1 }, { 1, 2 }, { 2, 2 }, { 2, 1 } } };
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t j = (i + 1) % 4;
    wall(outer[i][0], outer[i][1], outer[j][0], outer[j][1]);
    wall(inner[i][0], inner[i][1], inner[j][0], inner[j][1]);
  }
  // Top and bottom in four quadrilaterals each; the inner ring runs the other way.
  constexpr std::array<std::size_t, 4> Opposite{ 0, 3, 2, 1 };
  for (std::size_t i = 0; i < 4; ++i)
  {
    const auto& a = outer[i];
    const auto& b = outer[(i + 1) % 4];
    const auto& c = inner[Opposite[(i + 1) % 4]];
    const auto& d = inner[Opposite[i]];
    cell.push_back({ { a[0], a[1], 1 }, { b[0], b[1], 1 }, { c[0], c[1], 1 }, { d[0], d[1], 1 } });
    cell.push_back({ { d[0], d[1], 0 }, { c[0], c[1], 0 }, { b[0], b[1], 0 }, { a[0], a[1], 0 } });
  }
  const Vector up{ 0, 0, 1 };
  const PlaneSection section = cut(facedCells({ cell }), { { 0, 0, 0 }, up, 0.5 });
  ASSERT_EQ(section.count(), 1u);
  EXPECT_EQ(section.firstCorner[1], 10u);
  EXPECT_DOUBLE_EQ(areaOf(section, 0, up), 8);
}

class SectionOf : public ::testing::TestWithParam<NamedShape>
{
};

TEST_P(SectionOf, HasTheAreasOfThePartsOfItsCells)
{
  const Soup& soup = GetParam().soup;
  const FacedCells mesh = facedCells(meshOf(soup, cellsAlongLongest(soup, 7), TestOptions()).mesh);
  Execution execution;
  const CellDivision division = divideCells(mesh.cells, mesh.points.data(), execution);
  std::vector<std::uint32_t> cellOf;
  const FacedCells parts = partsOf(mesh, division, cellOf);
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<std::uint32_t> any(
    0, static_cast<std::uint32_t>(mesh.points.size() / 3 - 1));
  const double size = soup.longest();
  for (int i = 0; i < 12; ++i)
  {
    // Through a point of the mesh; every third along an axis.
    Vector direction{ normal(random), normal(random), normal(random) };
    if (i % 3 == 0)
    {
      direction = { i % 2 == 0 ? 1.0 : 0.0, i % 2 == 0 ? 0.0 : -1.0, 0 };
    }
    const SectionPlane plane{ mesh.at(any(random)), unit(direction), 0 };
    const PlaneSection section = cut(mesh, plane);
    const PlaneSection ofParts = cut(parts, plane);
    const std::vector<double> areas = areasOf(section, plane.normal, mesh.cells.cellCount());
    std::vector<double> known(areas.size());
    for (std::size_t polygon = 0; polygon < ofParts.count(); ++polygon)
    {
      known[cellOf[ofParts.cell[polygon]]] += areaOf(ofParts, polygon, plane.normal);
    }
    for (std::size_t cell = 0; cell < areas.size(); ++cell)
    {
      if (division.inverts[cell] == 0)
      {
        EXPECT_NEAR(areas[cell], known[cell], 1e-12 * size * size + mesh.rounding() * size);
      }
    }
    for (std::size_t point = 0; point < section.points.size(); ++point)
    {
      EXPECT_LT(std::abs(plane.height(section.points[point])), 1e-12 * size + mesh.rounding());
    }
    EXPECT_EQ(section.corners, cut(mesh, plane, 3).corners);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, SectionOf, ::testing::ValuesIn(cleanShapes()), nameOf);

TEST(PolygonBridges, HolesGoToTheSmallestRingAroundThem)
{
  const auto square = [](double x, double y, double half, bool isHole) {
    std::vector<Vector> ring{ { x - half, y - half, 0 }, { x + half, y - half, 0 },
      { x + half, y + half, 0 }, { x - half, y + half, 0 } };
    if (isHole)
    {
      std::reverse(ring.begin(), ring.end());
    }
    return ring;
  };
  // An island in a lake, with a pond; and a second lake.
  const auto polygons =
    bridgeHoles({ square(0, 0, 10, false), square(0, 0, 6, true), square(0, 0, 4, false),
                  square(1, 0, 1, true), square(8, 0, 1, true) },
      { 0, 0, 1 });
  ASSERT_EQ(polygons.size(), 2u);
  EXPECT_EQ(polygons[0].size(), 4u + 6 + 6);
  EXPECT_EQ(polygons[1].size(), 4u + 6);
}

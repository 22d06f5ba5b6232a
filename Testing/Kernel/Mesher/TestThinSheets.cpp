// Sheets whose triangles are there twice: each side is a wall with the sheet's area, wherever it ends, and nothing else
// changes.
#include "Base/DisjointSets.h"
#include "Repair/SurfaceDefects.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

constexpr std::int32_t Front = 20; // boundaries
constexpr std::int32_t Back = 21;

// How thick sheets become is seen in areas and volumes no more than so, in a box of 3 x 1 x 1.
constexpr double Thin = 1e-6;

// What single precision and the thickness leave, and what patches that are simplified do.
constexpr double Rounded = 5e-6;
constexpr double Simplified = 1e-2;

using Place = std::function<Vector(double u, double v)>;

// n x n squares, each of two triangles, there twice. `wanted`: which squares; all: null.
void addSheet(
  Soup& soup, int n, const Place& place, const std::function<bool(int i, int j)>& wanted = {})
{
  soup.boundary.resize(soup.triangles.size(), 0);
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  const auto row = static_cast<std::uint32_t>(n + 1);
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      soup.points.push_back(place(double(i) / n, double(j) / n));
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    soup.triangles.push_back({ a, b, c });
    soup.boundary.push_back(Front);
    soup.triangles.push_back({ a, c, b });
    soup.boundary.push_back(Back);
  };
  for (std::uint32_t j = 0; j + 1 < row; ++j)
  {
    for (std::uint32_t i = 0; i + 1 < row; ++i)
    {
      if (!wanted || wanted(int(i), int(j)))
      {
        const std::uint32_t corner = first + j * row + i;
        add(corner, corner + 1, corner + row + 1);
        add(corner, corner + row + 1, corner + row);
      }
    }
  }
}

Place plane(const Vector& corner, const Vector& along, const Vector& up)
{
  return [=](double u, double v) { return plus(corner, plus(scaled(along, u), scaled(up, v))); };
}

Soup duct()
{
  return box({ 0, 0, 0 }, { 3, 1, 1 });
}

using Sizes = std::vector<double>; // cells along the longest dimension

void expectSheets(const Soup& soup, double volume, double area, const TestOptions& options,
  const Sizes& sizes = { 1, 4.3, 11.3 })
{
  for (const double cells : sizes)
  {
    SCOPED_TRACE(std::to_string(cells) + " cells along the longest dimension");
    const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, cells), options);
    EXPECT_TRUE(isValid(meshed.mesh, true));
    EXPECT_NEAR(volumeOf(meshed.mesh), volume, Thin);
    std::map<std::int32_t, double> areas = areasByBoundary(meshed.mesh);
    EXPECT_NEAR(areas[Front], area, Thin);
    EXPECT_NEAR(areas[Back], area, Thin);
  }
}

// Of cells that faces connect, ascending.
std::vector<double> volumesOfParts(MeshArrays mesh)
{
  std::map<std::vector<Id>, std::size_t> cellOf; // by a face's points
  DisjointSets parts(mesh.cells());
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
  {
    for (std::vector<Id> face : facesOf(mesh, cell))
    {
      std::sort(face.begin(), face.end());
      const auto [other, isNew] = cellOf.emplace(face, cell);
      if (!isNew)
      {
        parts.unite(static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>(other->second));
      }
    }
  }
  for (std::uint32_t cell = 0; cell < mesh.cells(); ++cell)
  {
    mesh.region[cell] = static_cast<int>(parts.find(cell));
  }
  std::vector<double> volumes;
  for (const auto& [part, volume] : volumesByRegion(mesh))
  {
    volumes.push_back(volume);
  }
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

// What a file in single precision has.
Soup rounded(const Soup& soup)
{
  return soup.each([](const Vector& p) {
    const volatile float q[] = { float(p[0]), float(p[1]), float(p[2]) };
    return Vector{ q[0], q[1], q[2] };
  });
}

// Turned, in three sizes. `tolerance`: of volumes and areas, relative.
void expectParts(const Soup& soup, const std::vector<double>& volumes, double area,
  const TestOptions& options, double tolerance)
{
  int turn = 0;
  for (const Soup& turned :
    { soup, soup.turned(2, 17), soup.turned(), soup.turned(0, 45).turned(1, 30) })
  {
    ++turn;
    for (const double size : { 0.001, 1., 1000. })
    {
      SCOPED_TRACE("turn " + std::to_string(turn) + ", size " + std::to_string(size));
      const Soup scaled = rounded(turned.scaled(size));
      const Meshed meshed = meshOf(scaled, cellsAlongLongest(scaled, 4.3), options);
      EXPECT_TRUE(isValid(meshed.mesh, true));
      const std::vector<double> parts = volumesOfParts(meshed.mesh);
      EXPECT_EQ(parts.size(), volumes.size());
      for (std::size_t i = 0; i < std::min(parts.size(), volumes.size()); ++i)
      {
        EXPECT_NEAR(parts[i] / (size * size * size), volumes[i], tolerance);
      }
      std::map<std::int32_t, double> areas = areasByBoundary(meshed.mesh);
      EXPECT_NEAR(areas[Front] / (size * size), area, tolerance);
      EXPECT_NEAR(areas[Back] / (size * size), area, tolerance);
    }
  }
}

void expectSheets(const Soup& soup, double volume, double area)
{
  TestOptions options;
  options.patches = exactFit();
  expectSheets(soup, volume, area, asTheyAre());
  expectSheets(soup, volume, area, options);
}

}

TEST(ThinSheets, EndAnywhere)
{
  for (const int n : { 1, 2, 5 })
  {
    SCOPED_TRACE(n);
    Soup soup = duct();
    addSheet(soup, n, plane({ 0.4, 0.2, 0.3 }, { 1.7, 0.3, 0.1 }, { 0.1, 0.2, 0.5 }));
    const double area = norm(cross({ 1.7, 0.3, 0.1 }, { 0.1, 0.2, 0.5 }));
    expectSheets(soup, 3, area);
    expectSheets(soup.turned(), 3, area);
  }
}

// Its rims have corners between which a triangle, or an edge, has nothing but rims.
TEST(ThinSheets, HaveAnyOutline)
{
  Soup soup = duct();
  addSheet(soup, 4, plane({ 0.4, 0.2, 0.3 }, { 1.6, 0, 0 }, { 0, 0.4, 0.3 }),
    [](int i, int j) { return (i + j) % 2 == 0 || i == 1; });
  expectSheets(soup, 3, 10 * 0.4 * 0.125);
}

// They bend, by 1/8 of a radian between strips.
TEST(ThinSheets, Bend)
{
  constexpr int Strips = 8;
  Soup soup = duct();
  addSheet(soup, Strips, [](double u, double v) {
    return Vector{ 1 + 0.4 * std::sin(u), 0.2 + 0.6 * v, 0.1 + 0.4 * std::cos(u) };
  });
  expectSheets(soup, 3, 0.6 * Strips * 0.8 * std::sin(0.5 / Strips));
}

// Three along one line; and one whose rim is an edge of the walls.
TEST(ThinSheets, Meet)
{
  Soup soup = duct();
  for (const double angle : { 0.2, 2.0, 4.5 })
  {
    addSheet(soup, 2,
      plane({ 1.5, 0.1, 0.5 }, { 0, 0.8, 0 }, { 0.4 * std::cos(angle), 0, 0.4 * std::sin(angle) }));
  }
  expectSheets(soup, 3, 3 * 0.32);
  Soup fin = duct();
  addSheet(fin, 1, plane({ 0, 0, 0 }, { 3, 0, 0 }, { 0, 0.3, 0.3 }));
  expectSheets(fin, 3, 0.9 * std::sqrt(2.0), asTheyAre(), { 4.3, 11.3 });
}

// Through the walls, and through each other.
TEST(ThinSheets, Cross)
{
  Soup through = duct();
  addSheet(through, 2, plane({ 1.2, 0.3, -0.4 }, { 0.3, 0, 0.9 }, { 0.1, 0.5, 0 }));
  const Vector part = scaled({ 0.3, 0, 0.9 }, 0.5 / 0.9);
  expectSheets(through, 3, norm(cross(part, { 0.1, 0.5, 0 })));
  Soup crossing = duct();
  addSheet(crossing, 2, plane({ 1, 0.2, 0.2 }, { 1, 0, 0.6 }, { 0, 0.5, 0 }));
  addSheet(crossing, 2, plane({ 1, 0.3, 0.8 }, { 1, 0, -0.6 }, { 0, 0.5, 0 }));
  expectSheets(crossing, 3, std::sqrt(1.36));
}

TEST(ThinSheets, AreInRegions)
{
  Soup soup;
  soup.addRegion(box({ 0, 0, 0 }, { 1, 1, 1 }));
  soup.addRegion(box({ 1, 0, 0 }, { 3, 1, 1 }));
  addSheet(soup, 2, plane({ 1.5, 0.2, 0.2 }, { 1, 0, 0.1 }, { 0, 0.5, 0.1 }));
  soup.region.resize(soup.triangles.size(), FirstRegion + 1);
  const double area = norm(cross({ 1, 0, 0.1 }, { 0, 0.5, 0.1 }));
  expectSheets(soup, 3, area);
  const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, 11.3), asTheyAre());
  EXPECT_NEAR(volumesByRegion(meshed.mesh).at(1), 1, Thin);
  EXPECT_NEAR(areasBetweenRegions(meshed.mesh).at({ 1, 2 }), 1, Thin);
}

TEST(ThinSheets, AreOutside)
{
  Soup soup = box({ 0, 0, 0 }, { 0.4, 1, 1 });
  addSheet(soup, 3, plane({ 0.8, 0.2, 0.2 }, { 0.7, 0.1, 0.3 }, { -0.1, 0.6, 0.1 }));
  TestOptions options;
  options.domain.domain = Domain::Outside;
  options.domain.boxFrom = BoxSource::Bounds;
  options.domain.bounds = { { -1, -1, -1 }, { 2, 2, 2 } };
  options.domain.sides = { 10, 11, 12, 13, 14, 15 };
  options.patches = exactFit();
  const double area = norm(cross({ 0.7, 0.1, 0.3 }, { -0.1, 0.6, 0.1 }));
  expectSheets(soup, 27 - 0.4, area, options, { 6.3, 15.7 });
}

TEST(ThinSheets, AreLeftOut)
{
  const Soup alone = duct();
  Soup soup = alone;
  addSheet(soup, 2, plane({ 1, 0.2, 0.2 }, { 1, 0, 0.6 }, { 0, 0.5, 0 }));
  TestOptions options = asTheyAre();
  options.sheets = SheetHandling::LeaveOut;
  const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, 11.3), options);
  EXPECT_TRUE(isValid(meshed.mesh, true));
  EXPECT_TRUE(fills(meshed.mesh, alone));
  EXPECT_EQ(meshed.prepared.repair.duplicates.size(), 16U);
}

TEST(ThinSheets, DoNotDependOnThreadsOrTheOrderOfTriangles)
{
  Soup soup = duct();
  addSheet(soup, 3, plane({ 0.4, 0.2, 0.3 }, { 1.7, 0.3, 0.1 }, { 0.1, 0.2, 0.5 }));
  TestOptions options;
  const Meshed one = meshOf(soup, cellsAlongLongest(soup, 11.3), options);
  std::reverse(soup.triangles.begin(), soup.triangles.end());
  std::reverse(soup.boundary.begin(), soup.boundary.end());
  options.threads = 3;
  EXPECT_TRUE(meshOf(soup, cellsAlongLongest(soup, 11.3), options).mesh == one.mesh);
}

// What is no defect is not told.
TEST(ThinSheets, AreNoDefects)
{
  Soup soup = duct();
  addSheet(soup, 3, plane({ 0.4, 0.2, 0.3 }, { 1.7, 0.3, 0.1 }, { 0.1, 0.2, 0.5 }));
  Execution execution;
  const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, 5));
  const SurfaceDefects defects = findDefects(prepared.inspected(), prepared.trianglesGiven(),
    prepared.repair, prepared.cracks, prepared.planes, execution);
  EXPECT_TRUE(defects.defects.empty());
  const std::vector<std::uint8_t>& ofSheet = prepared.inspected().ofSheet;
  EXPECT_EQ(std::count(ofSheet.begin(), ofSheet.end(), 0), 12);
}

// From wall to wall, with rims that the file rounds: each part is on one side.
TEST(ThinSheets, DivideTheirRegion)
{
  Soup fine = cube();
  addSheet(fine, 3, plane({ 0.43, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }));
  expectParts(fine, { 0.43, 0.57 }, 1, asTheyAre(), Rounded);
  Soup coarse = cube();
  addSheet(coarse, 1, plane({ 0.43, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }));
  expectParts(coarse, { 0.43, 0.57 }, 1, {}, Simplified);
  Soup diagonal = cube();
  addSheet(diagonal, 1, plane({ 0, 1, 0 }, { 1, -1, 0 }, { 0, 0, 1 }));
  expectParts(diagonal, { 0.5, 0.5 }, std::sqrt(2.0), asTheyAre(), Rounded);
}

TEST(ThinSheets, DivideNothingThatTheyOnlyStandIn)
{
  Soup soup = cube();
  addSheet(soup, 2, plane({ 0.43, 0, 0 }, { 0.1, 1, 0 }, { 0, 0, 0.8 }));
  expectParts(soup, { 1 }, 0.8 * std::sqrt(1.01), asTheyAre(), Rounded);
}

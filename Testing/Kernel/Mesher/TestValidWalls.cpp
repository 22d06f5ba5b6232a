// Around the rims of thin things, where a cell has walls back to back, solvers refuse nothing, and little is lost.
#include "Polyhedra/CellGeometry.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr double Size = 0.25; // of boxes

// Both sides of a parallelogram around a place, as triangles that are there twice.
Soup sheet(const Vector& u, const Vector& v, const Vector& at = {})
{
  Soup soup;
  for (const auto& [a, b] : { std::pair{ -0.5, -0.5 }, { 0.5, -0.5 }, { 0.5, 0.5 }, { -0.5, 0.5 } })
  {
    soup.points.push_back(plus(at, plus(scaled(u, a), scaled(v, b))));
  }
  soup.triangles = { { 0, 1, 2 }, { 0, 2, 1 }, { 0, 2, 3 }, { 0, 3, 2 } };
  return soup;
}

Soup disc(double radius)
{
  constexpr std::uint32_t Corners = 64;
  Soup soup;
  for (std::uint32_t i = 0; i < Corners; ++i)
  {
    const double angle = 2 * std::acos(-1.0) * i / Corners;
    soup.points.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0 });
    if (i >= 2)
    {
      soup.triangles.push_back({ 0, i - 1, i });
      soup.triangles.push_back({ 0, i, i - 1 });
    }
  }
  return soup;
}

Soup plate(const Vector& size, const Vector& at = {})
{
  return box(minus(at, scaled(size, 0.5)), plus(at, scaled(size, 0.5)));
}

std::vector<NamedShape> shapesWithRims()
{
  const Soup flat = sheet({ 3, 0, 0 }, { 0, 2, 0 });
  return { { "Sheet", flat }, { "Disc", disc(1.2) },
    { "Tee", Soup(flat).add(sheet({ 3, 0, 0 }, { 0, 0, 1 }, { 0, 0, 0.5 + 0.3 * Size })) },
    { "Parallel", Soup(flat).add(sheet({ 3, 0, 0 }, { 0, 2, 0 }, { 0, 0, 0.3 * Size })) },
    { "Crossing", Soup(flat).add(sheet({ 2, 0.3, 0.4 }, { 0, 0.2, 1.5 })) },
    { "Wedge", Soup(flat).add(sheet({ 3, 0, 0 }, { 0, 1.7, 0.8 }, { 0, 0, 0.1 * Size })) },
    { "Strip", sheet({ 3, 0, 0 }, { 0, 0.3 * Size, 0 }) }, { "Plate", plate({ 3, 2, 0.1 * Size }) },
    { "Fins",
      plate({ 3, 2, 0.4 * Size })
        .add(plate({ 0.3 * Size, 1.5, 1 }, { -1, 0, 0.5 }))
        .add(plate({ 0.9 * Size, 1.1, 1 }, { 0.4, 0, 0.5 })) } };
}

// Of a cell as checkMesh measures it.
struct Refused
{
  std::size_t inverted = 0;
  std::size_t withoutVolume = 0;
};

Refused refusedOf(const MeshArrays& mesh)
{
  Refused refused;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
  {
    std::vector<FaceGeometry> faces;
    for (const Face& face : facesOf(mesh, cell))
    {
      faces.push_back(measureFace(face.size(), [&](std::size_t i) {
        const double* const p = &mesh.points[3 * static_cast<std::size_t>(face[i])];
        return Vector{ p[0], p[1], p[2] };
      }));
    }
    const CellGeometry geometry =
      measureCell(faces.size(), [&](std::size_t f) -> const FaceGeometry& { return faces[f]; });
    refused.withoutVolume += geometry.volume > 0 ? 0 : 1;
    for (const FaceGeometry& face : faces)
    {
      refused.inverted += dot(face.area, minus(face.centre, geometry.centre)) > 0 ? 0 : 1;
    }
  }
  return refused;
}

TestOptions outside(int threads = 1)
{
  TestOptions options;
  options.threads = threads;
  options.domain.domain = Domain::Outside;
  options.domain.boxFrom = BoxSource::Bounds;
  options.domain.bounds = { { -3, -3, -3 }, { 3, 3, 3 } };
  options.sheets = SheetHandling::Keep;
  return options;
}

class ValidWalls : public ::testing::TestWithParam<NamedShape>
{
};

}

TEST_P(ValidWalls, SolversRefuseNothing)
{
  for (const double angle : { 0.0, 25.0 })
  {
    SCOPED_TRACE(std::to_string(angle) + " degrees");
    const Soup soup = GetParam().soup.turned(0, angle).turned(2, 1.6 * angle);
    const Meshed meshed = meshOf(soup, cellsOf(Size), outside());
    EXPECT_TRUE(isValid(meshed.mesh, true));
    const Refused refused = refusedOf(meshed.mesh);
    EXPECT_EQ(refused.inverted, 0);
    EXPECT_EQ(refused.withoutVolume, 0);
    // Little goes; walls always miss a little. Where a sheet lies in a plane of boxes that others cross, these are
    // rebuilt (and told): that may take what is between them.
    constexpr double BoxesOfWalls = 0.5;
    const double box = Size * Size * Size;
    const double boxes = 4 + BoxesOfWalls + meshed.statistics.at("BoxesRebuilt");
    EXPECT_NEAR(volumeOf(meshed.mesh), 216 - soup.volume(), boxes * box);
  }
}

TEST_P(ValidWalls, AreTheSameOnAnyThreads)
{
  const Soup soup = GetParam().soup.turned(0, 25).turned(2, 40);
  const Meshed one = meshOf(soup, cellsOf(Size), outside(1));
  const Meshed three = meshOf(soup, cellsOf(Size), outside(3));
  EXPECT_EQ(one.mesh.points, three.mesh.points);
  EXPECT_EQ(one.mesh.faceStream, three.mesh.faceStream);
  EXPECT_EQ(one.mesh.connectivity, three.mesh.connectivity);
}

INSTANTIATE_TEST_SUITE_P(Of, ValidWalls, ::testing::ValuesIn(shapesWithRims()), nameOf);

}

// Faces whose corners lie on a line are taken out: cells stay closed, and as large.
#include "Editing/FlatFaces.h"
#include "Support/EditMeshes.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

std::size_t countFlat(const MeshEditor& mesh)
{
  std::size_t count = 0;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    count += !mesh.face(f).gone && isFlat(mesh, f) ? 1 : 0;
  }
  return count;
}

void removeFrom(MeshEditor& mesh)
{
  Execution execution;
  removeFlatFaces(mesh.mesh(), EditRules(), execution);
}

// Between u and v, a node becomes a corner of f; a flat face closes the gap to what is beyond that edge of the cell.
void addFlatFace(
  MeshEditor& mesh, std::uint32_t f, std::uint32_t u, std::uint32_t v, std::uint32_t above)
{
  const Items old = mesh.cornersOf(f);
  std::vector<std::uint32_t> ring(old.begin(), old.end());
  const auto at = std::find(ring.begin(), ring.end(), u);
  const bool isForward = ring[std::size_t(at - ring.begin() + 1) % ring.size()] == v;
  EditNode node = mesh.node(u);
  node.at = scaled(plus(mesh.node(u).at, mesh.node(v).at), 0.5);
  const std::uint32_t middle = mesh.makeNode(node);
  ring.insert(isForward ? at + 1 : at, middle);
  mesh.setCorners(f, ring.data(), ring.size());
  EditFace flat = mesh.face(f);
  flat.above = above;
  const std::array<std::uint32_t, 3> corners = isForward
    ? std::array<std::uint32_t, 3>{ u, v, middle }
    : std::array<std::uint32_t, 3>{ v, u, middle };
  mesh.makeFace(flat, corners.data(), corners.size());
}

}

TEST(FlatFaces, OnlyWhatIsOnALineIsFlat)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(2, 1, 1));
  EXPECT_EQ(countFlat(mesh), 0U);
  const std::uint32_t wall = wallOf(mesh, 0, 5);
  const std::uint32_t n = mesh.cornersOf(wall)[0];
  const std::uint32_t opposite = mesh.cornersOf(wall)[2];
  mesh.rawNode(n).at = plus(mesh.node(opposite).at, { 0, mesh.level(), 0 }); // one step is enough
  mesh.rawNode(mesh.cornersOf(wall)[1]).at = mesh.node(opposite).at;
  mesh.rawNode(mesh.cornersOf(wall)[1]).at[0] += mesh.level();
  EXPECT_FALSE(isFlat(mesh, wall));
}

TEST(FlatFaces, AWallGoes)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(1, 1, 1));
  const std::uint32_t top = wallOf(mesh, 0, 5);
  addFlatFace(mesh, top, mesh.cornersOf(top)[0], mesh.cornersOf(top)[1], None);
  mesh.commit();
  ASSERT_EQ(countFlat(mesh), 1U);
  removeFrom(mesh);
  EXPECT_EQ(countFlat(mesh), 0U);
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_EQ(countFaces(mesh), 6U);
  EXPECT_DOUBLE_EQ(volumeOf(mesh), 1);
}

// Along the edge of four boxes, inside: all faces there get the corner.
TEST(FlatFaces, OneBetweenCellsGoes)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(2, 2, 1));
  const std::uint32_t f = faceBetween(mesh, 0, 1);
  ASSERT_NE(f, None);
  std::uint32_t u = None;
  std::uint32_t v = None;
  const Items ring = mesh.cornersOf(f);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Vector& p = mesh.node(ring[i]).at;
    const Vector& q = mesh.node(ring[(i + 1) % ring.size()]).at;
    if (p[0] == q[0] && p[1] == q[1] && mesh.facesAround(ring[i]).size() == 8)
    {
      u = ring[i];
      v = ring[(i + 1) % ring.size()];
    }
  }
  ASSERT_NE(u, None);
  addFlatFace(mesh, f, u, v, mesh.face(f).above);
  mesh.commit();
  ASSERT_EQ(countFlat(mesh), 1U);
  removeFrom(mesh);
  EXPECT_EQ(countFlat(mesh), 0U);
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_EQ(countFaces(mesh), 20U);
  EXPECT_DOUBLE_EQ(volumeOf(mesh), 4);
}

TEST(FlatFaces, OtherMeshesStay)
{
  MeshEditor mesh = meshOfBoxes(hangingBoxes());
  const MeshEditor before = copyOf(mesh);
  removeFrom(mesh);
  EXPECT_EQ(differenceOf(mesh, before), "");
}

namespace
{

std::size_t flatFacesOf(const MeshArrays& mesh)
{
  std::size_t count = 0;
  for (std::size_t c = 0; c < mesh.cells(); ++c)
  {
    for (const Face& face : facesOf(mesh, c))
    {
      const auto at = [&](std::size_t i) {
        const double* p = mesh.points.data() + 3 * static_cast<std::size_t>(face[i % face.size()]);
        return Vector{ p[0], p[1], p[2] };
      };
      Vector area{};
      for (std::size_t i = 1; i + 1 < face.size(); ++i)
      {
        area = plus(area, cross(minus(at(i), at(0)), minus(at(i + 1), at(0))));
      }
      count += norm(area) == 0 ? 1 : 0;
    }
  }
  return count;
}

// From `near` to `far` along x, upright.
Soup sheet(double near, double far)
{
  Soup soup;
  for (const double x : { near, far })
  {
    soup.points.push_back({ x, 0, 0 });
    soup.points.push_back({ x, 0, 1 });
  }
  soup.triangles = { { 0, 2, 1 }, { 1, 2, 3 } };
  return soup;
}

// Four around the axis, from `near` on.
Soup sheets(double near, double degrees)
{
  Soup soup;
  for (int i = 0; i < 4; ++i)
  {
    soup.add(sheet(near, near + 1).turned(2, degrees + 90 * i));
  }
  return soup;
}

double removedFrom(const Assembly& assembly, double step)
{
  double volume = 0;
  for (const RemovedCell& cell : assembly.edits.removed)
  {
    volume += cell.volume * step * step * step;
  }
  return volume;
}

// A third of its length around it on all sides.
DomainSpec around(const Soup& soup)
{
  const double third = soup.longest() / 3;
  const Vector margin{ third, third, third };
  DomainSpec domain;
  domain.domain = Domain::Outside;
  domain.boxFrom = BoxSource::Bounds;
  domain.bounds = { minus(soup.low(), margin), plus(soup.high(), margin) };
  return domain;
}
}

// Of sheets closed by lids, both walls lie in one plane; nothing of the box is lost but what edits say that they removed.
TEST(FlatFaces, SheetsHaveNone)
{
  for (const double near : { 0.0, 0.5, 2.0 })
  {
    for (const double degrees : { 0.0, 30.0, 45.0 })
    {
      for (const double cells : { 5.0, 9.0, 12.0 })
      {
        SCOPED_TRACE(std::to_string(near) + ", " + std::to_string(degrees) + " degrees, " +
          std::to_string(cells) + " boxes");
        const Soup soup = sheets(near, degrees);
        TestOptions asCut = asTheyAre();
        for (TestOptions options : { asCut, TestOptions() })
        {
          options.domain = around(soup);
          options.sheets = SheetHandling::LeaveOut; // closed by lids
          options.grid = cellsAlongLongest(soup, cells);
          Execution execution(1);
          const auto assembly = mesh(soup.view(), options, execution);
          const MeshArrays arrays = arraysOf(*assembly->mesh, assembly->boxes, execution);
          EXPECT_EQ(flatFacesOf(arrays), 0U);
          const Vector size = minus(options.domain.bounds.high, options.domain.bounds.low);
          const double sides = 2 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
          EXPECT_NEAR(volumeOf(arrays), size[0] * size[1] * size[2],
            2 * arrays.step * (sides + soup.area()) + removedFrom(*assembly, arrays.step));
        }
      }
    }
  }
}

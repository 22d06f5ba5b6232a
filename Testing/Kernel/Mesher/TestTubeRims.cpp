// The rims of long tubes are edges of the mesh, though their walls are thin triangles.
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace cartesian;

namespace
{

Vector areaOf(const MeshArrays& mesh, const Face& face)
{
  const auto at = [&](std::size_t i) {
    const double* const p = &mesh.points[3 * static_cast<std::size_t>(face[i])];
    return Vector{ p[0], p[1], p[2] };
  };
  Vector twice{};
  for (std::size_t i = 2; i < face.size(); ++i)
  {
    twice = plus(twice, cross(minus(at(i - 1), at(0)), minus(at(i), at(0))));
  }
  return scaled(twice, 0.5);
}

// Of the faces of one cell alone.
std::vector<Vector> wallsOf(const MeshArrays& mesh)
{
  std::map<Face, std::vector<Vector>> byPoints;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
  {
    for (Face face : facesOf(mesh, cell))
    {
      const Vector area = areaOf(mesh, face);
      std::sort(face.begin(), face.end());
      byPoints[face].push_back(area);
    }
  }
  std::vector<Vector> walls;
  for (const auto& [points, areas] : byPoints)
  {
    if (areas.size() == 1)
    {
      walls.push_back(areas[0]);
    }
  }
  return walls;
}

// Of walls that face along a tube, and of those that are neither its ends nor its walls.
struct Areas
{
  double ends = 0;
  double slanted = 0;
};

Areas areasOf(const MeshArrays& mesh, const Vector& axis)
{
  Areas areas;
  for (const Vector& wall : wallsOf(mesh))
  {
    const double cosine = std::abs(dot(unit(wall), axis));
    areas.ends += cosine > 0.999 ? norm(wall) : 0;
    areas.slanted += cosine > 0.1 && cosine <= 0.999 ? norm(wall) : 0;
  }
  return areas;
}

}

TEST(TubeRims, AreEdges)
{
  Soup tube = tubeWithEnds(12, 6, 30);
  tube.boundary.assign(tube.triangles.size(), 0);
  const double ends = 3 + 1.5 * std::sqrt(3.0);
  for (const Soup& soup : { tube, tube.turned(0, 20), tube.turned(), tube.permuted({ 2, 0, 1 }) })
  {
    const auto& last = soup.triangles.back(); // of an end
    const Vector axis = unit(cross(minus(soup.points[last[1]], soup.points[last[0]]),
      minus(soup.points[last[2]], soup.points[last[0]])));
    for (const int boxes : { 40, 60, 100 })
    {
      SCOPED_TRACE(boxes);
      const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, boxes), {});
      EXPECT_TRUE(isValid(meshed.mesh, true));
      const Areas areas = areasOf(meshed.mesh, axis);
      EXPECT_NEAR(areas.ends, ends, 1e-5 * ends);
      EXPECT_LT(areas.slanted, 0.01 * soup.area());
    }
  }
}

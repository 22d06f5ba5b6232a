// Regions whose borders do not match: volumes and areas are known by construction.
#include "Repair/Contacts.h"

#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace cartesian;

namespace
{

using Random = std::mt19937;

double between(Random& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Heights over the lines of a grid of the unit square, linear in two triangles of each field.
struct Land
{
  std::array<std::vector<double>, 2> lines;
  std::vector<double> heights;
  std::vector<std::array<std::uint32_t, 3>> triangles; // seen from above

  std::uint32_t at(std::size_t i, std::size_t j) const
  {
    return static_cast<std::uint32_t>(j * lines[0].size() + i);
  }
  Vector place(std::uint32_t k) const
  {
    return { lines[0][k % lines[0].size()], lines[1][k / lines[0].size()], heights[k] };
  }

  // Up to the height 0, and its own.
  double volume() const
  {
    double sum = 0;
    for (const auto& [a, b, c] : triangles)
    {
      const Vector normal = cross(minus(place(b), place(a)), minus(place(c), place(a)));
      sum += normal[2] / 6 * (heights[a] + heights[b] + heights[c]);
    }
    return sum;
  }
  double area() const
  {
    double sum = 0;
    for (const auto& [a, b, c] : triangles)
    {
      sum += norm(cross(minus(place(b), place(a)), minus(place(c), place(a)))) / 2;
    }
    return sum;
  }
};

// Heights at most half of `rough` from `height`.
Land landOf(double height, double rough, Random& random)
{
  Land land;
  for (std::vector<double>& lines : land.lines)
  {
    const auto fields = 2 + static_cast<int>(random() % 3);
    for (int i = 0; i <= fields; ++i)
    {
      const double aside = i == 0 || i == fields ? 0 : between(random, -0.3, 0.3);
      lines.push_back((i + aside) / fields);
    }
  }
  for (std::size_t k = 0; k < land.lines[0].size() * land.lines[1].size(); ++k)
  {
    land.heights.push_back(height + rough * between(random, -0.5, 0.5));
  }
  for (std::size_t j = 0; j + 1 < land.lines[1].size(); ++j)
  {
    for (std::size_t i = 0; i + 1 < land.lines[0].size(); ++i)
    {
      const std::array<std::uint32_t, 4> c{ land.at(i, j), land.at(i + 1, j), land.at(i + 1, j + 1),
        land.at(i, j + 1) };
      const std::size_t first = random() % 2;
      for (const std::size_t k : { first, first + 2 })
      {
        land.triangles.push_back({ c[k], c[k + 1 - 4 * (k / 3)], c[(k + 2) % 4] });
      }
    }
  }
  return land;
}

// The vertices along one of four sides, counter-clockwise.
std::vector<std::uint32_t> sideOf(const Land& land, std::size_t side)
{
  const std::size_t last[2] = { land.lines[0].size() - 1, land.lines[1].size() - 1 };
  const std::size_t along = side % 2;
  std::vector<std::uint32_t> all;
  for (std::size_t k = 0; k <= last[along]; ++k)
  {
    const std::size_t at = side < 2 ? k : last[along] - k;
    const std::size_t across = side == 0 || side == 3 ? 0 : last[1 - along];
    all.push_back(along == 0 ? land.at(at, across) : land.at(across, at));
  }
  return all;
}

// From one land up to another.
Soup layerOf(const Land& low, const Land& high)
{
  Soup soup;
  const auto first = static_cast<std::uint32_t>(low.heights.size());
  for (const Land* land : { &low, &high })
  {
    for (std::uint32_t k = 0; k < land->heights.size(); ++k)
    {
      soup.points.push_back(land->place(k));
    }
  }
  for (const auto& [a, b, c] : low.triangles)
  {
    soup.triangles.push_back({ a, c, b });
  }
  for (const auto& [a, b, c] : high.triangles)
  {
    soup.triangles.push_back({ first + a, first + b, first + c });
  }
  for (std::size_t side = 0; side < 4; ++side)
  {
    std::vector<std::uint32_t> below = sideOf(low, side);
    std::vector<std::uint32_t> above = sideOf(high, side);
    for (std::uint32_t& v : above)
    {
      v += first;
    }
    const auto along = [&](std::uint32_t v) {
      return (side < 2 ? 1 : -1) * soup.points[v][side % 2];
    };
    for (std::size_t i = 0, j = 0; i + 1 < below.size() || j + 1 < above.size();)
    {
      const bool isBelow = j + 1 == above.size() ||
        (i + 1 < below.size() && along(below[i + 1]) <= along(above[j + 1]));
      soup.triangles.push_back({ below[i], isBelow ? below[i + 1] : above[j + 1], above[j] });
      ++(isBelow ? i : j);
    }
  }
  return soup;
}

struct Scene
{
  Soup soup;
  double tolerance = 0;
  std::map<int, double> volumes;
  std::map<std::pair<int, int>, double> areas; // between regions
};

// Strata in random order, the rough interfaces of which are divided differently on both sides, with gaps and overlaps up to
// the tolerance.
Scene strata(unsigned seed, int count)
{
  Random random(seed);
  Scene scene;
  scene.tolerance = between(random, 0.02, 0.2);
  std::vector<int> number(static_cast<std::size_t>(count));
  std::iota(number.begin(), number.end(), 1);
  std::shuffle(number.begin(), number.end(), random);
  std::vector<std::array<Land, 2>> walls; // of the stratum below each, and of the one above
  double height = 0;
  for (int k = 0; k <= count; ++k)
  {
    const double rough = k == 0 || k == count ? 0 : 0.99 * scene.tolerance;
    const Land below = landOf(height, rough, random);
    walls.push_back({ below, landOf(height, rough, random) });
    height += scene.tolerance * between(random, 2, 4);
  }
  const auto left = [&](std::size_t k) -> const Land& {
    const bool isBelow = k == number.size() || (k > 0 && number[k - 1] < number[k]);
    return walls[k][isBelow ? 0 : 1];
  };
  for (int region = 1; region <= count; ++region)
  {
    const auto k =
      static_cast<std::size_t>(std::find(number.begin(), number.end(), region) - number.begin());
    scene.soup.addRegion(layerOf(walls[k][1], walls[k + 1][0]));
    scene.volumes[region] = left(k + 1).volume() - left(k).volume();
    if (k > 0)
    {
      scene.areas[std::minmax(number[k - 1], region)] = left(k).area();
    }
  }
  return scene;
}

// Two that face each other in part, across a gap.
Scene bricks(double gap)
{
  Scene scene;
  scene.soup.addRegion(box({ 0, 0, 0 }, { 1, 1, 1 }));
  scene.soup.addRegion(box({ 1 + gap, 0.3, 0.3 }, { 2, 1.5, 1.5 }));
  scene.tolerance = std::abs(gap) + 0.01;
  const double common = 0.7 * 0.7;
  scene.volumes = { { 1, 1 },
    { 2, gap > 0 ? 1.44 * (1 - gap) + gap * common : 1.44 * (1 - gap) + gap * common } };
  scene.areas[{ 1, 2 }] = gap > 0 ? common : common - 2 * 0.7 * gap;
  return scene;
}

// With another triangulation of its wall.
Scene ballInAMould()
{
  Scene scene;
  const Soup ball = sphere(6, 0.5);
  Soup mould = box({ -1, -1, -1 }, { 1, 1, 1 });
  mould.add(sphere(5, 0.51).flipped());
  scene.soup.addRegion(ball);
  scene.soup.addRegion(mould);
  scene.tolerance = 0.05;
  scene.volumes = { { 1, ball.volume() }, { 2, 8 - ball.volume() } };
  scene.areas[{ 1, 2 }] = ball.area();
  return scene;
}

Soup turned(const Soup& soup, unsigned way)
{
  Soup result = way == 0
    ? soup
    : (way == 1 ? soup.turned(2, 45) : (way == 2 ? soup.turned(0, 30) : soup.turned()));
  result.region = soup.region;
  return result;
}

Options optionsFor(const Scene& scene)
{
  Options options;
  options.grid = cellsOf(0.3);
  options.contactTolerance = scene.tolerance;
  return options;
}

// Of the walls between regions, as they are before the mesh.
void expectWalls(const Scene& scene, const Surface& surface)
{
  const double step = surface.lattice.step();
  std::map<int, double> volumes;
  std::map<std::pair<int, int>, double> areas;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners c = surface.corners(t);
    const Point& base = surface.vertices[0];
    const double volume =
      dot(minus(c[0], base), cross(minus(c[1], base), minus(c[2], base))) / 6 * step * step * step;
    const std::int32_t behind = surface.walls.behind(surface.boundary[t]);
    const std::int32_t front = surface.walls.front(surface.boundary[t]);
    volumes[behind] += volume;
    volumes[front] -= volume;
    areas[std::minmax(behind, front)] +=
      norm(cross(minus(c[1], c[0]), minus(c[2], c[0]))) / 2 * step * step;
  }
  for (const auto& [region, volume] : scene.volumes)
  {
    EXPECT_NEAR(volumes[region], volume, 1e-8) << "region " << region;
  }
  for (const auto& [regions, area] : areas)
  {
    const auto expected = scene.areas.find(regions);
    if (regions.first != OutsideRegion)
    {
      EXPECT_NEAR(area, expected == scene.areas.end() ? 0 : expected->second, 2e-8)
        << "between " << regions.first << " and " << regions.second;
    }
  }
}

void expectMesh(const Scene& scene, const MeshArrays& mesh, double part)
{
  const std::map<int, double> volumes = volumesByRegion(mesh);
  for (const auto& [region, volume] : scene.volumes)
  {
    EXPECT_NEAR(volumes.at(region), volume, std::max(part * volume, 20 * mesh.step))
      << "region " << region;
  }
}

}

TEST(Contacts, StrataWithRoughInterfaces)
{
  Execution execution;
  for (unsigned seed = 0; seed < repeats(60); ++seed)
  {
    SCOPED_TRACE(seed);
    const Scene scene = strata(seed, 5);
    const Soup soup = turned(scene.soup, seed % 4);
    expectWalls(scene, prepareSurface(soup.view(), optionsFor(scene), execution).surface);
  }
}

TEST(Contacts, WallsThatFaceEachOtherInPart)
{
  Execution execution;
  for (const double gap : { 0.002, 0.05, -0.05 })
  {
    for (unsigned way = 0; way < 4; ++way)
    {
      SCOPED_TRACE(std::to_string(gap) + " turned " + std::to_string(way));
      const Scene scene = bricks(gap);
      const Soup soup = turned(scene.soup, way);
      const PreparedSurface prepared = prepareSurface(soup.view(), optionsFor(scene), execution);
      expectWalls(scene, prepared.surface);
      if (gap > 0)
      {
        ASSERT_EQ(prepared.contacts.size(), 1U);
        const double step = prepared.surface.lattice.step();
        EXPECT_NEAR(prepared.contacts[0].width * step, gap, 1e-8);
        EXPECT_NEAR(prepared.contacts[0].closed * step * step * step, 0.49 * gap, 1e-8);
        EXPECT_NE(describeFlaws(prepared, {}, {}).find("region 2 got about"), std::string::npos);
      }
    }
  }
}

TEST(Contacts, ABallInAMould)
{
  Execution execution;
  for (unsigned way = 0; way < 4; ++way)
  {
    SCOPED_TRACE(way);
    const Scene scene = ballInAMould();
    const Soup soup = turned(scene.soup, way);
    expectWalls(scene, prepareSurface(soup.view(), optionsFor(scene), execution).surface);
  }
}

TEST(Contacts, TheMeshHasTheVolumesAndFacesInCommon)
{
  for (const unsigned way : cases({ 0U, 1U, 2U, 3U }))
  {
    SCOPED_TRACE(way);
    const Scene scene = strata(way, 5);
    const Soup soup = turned(scene.soup, way);
    TestOptions options = asTheyAre();
    options.contactTolerance = scene.tolerance;
    const MeshArrays exact = meshOf(soup, cellsAlongLongest(soup, 7), options).mesh;
    EXPECT_TRUE(isValid(exact));
    expectMesh(scene, exact, 1e-9);
    const auto areas = areasBetweenRegions(exact);
    for (const auto& [regions, area] : scene.areas)
    {
      EXPECT_NEAR(areas.at(regions), area, std::max(1e-9 * area, 20 * exact.step));
    }
    TestOptions defaults;
    defaults.contactTolerance = scene.tolerance;
    const MeshArrays shaped = meshOf(soup, cellsAlongLongest(soup, 25), defaults).mesh;
    EXPECT_TRUE(isValid(shaped, true));
    expectMesh(scene, shaped, 0.02);
  }
}

TEST(Contacts, DoNotDependOnThreads)
{
  const Scene scene = strata(3, 5);
  Execution one;
  Execution several(4);
  const PreparedSurface a = prepareSurface(scene.soup.view(), optionsFor(scene), one);
  const PreparedSurface b = prepareSurface(scene.soup.view(), optionsFor(scene), several);
  EXPECT_EQ(a.surface.vertices, b.surface.vertices);
  EXPECT_EQ(a.surface.triangles, b.surface.triangles);
  EXPECT_EQ(a.surface.boundary, b.surface.boundary);
}

// Parts of a grid, each meshed by itself, are together the mesh of the whole: the same points, bit
// for bit, the same cells, the same numbers.
#include "Base/Error.h"
#include "Boxes/Balance.h"
#include "Parts/Decomposition.h"
#include "Support/Effort.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace cartesian;

namespace
{

struct Part
{
  MeshArrays mesh;
  std::vector<Id> globalPoint; // of each point
  Id ownPoints;
  std::map<std::string, double> statistics;
};

PreparedSurface preparedWith(
  const Soup& soup, const GridSpec& grid, Options options, Execution& execution)
{
  options.grid = grid;
  options.memoryLimit = PlentyOfMemory;
  return prepareSurface(soup.view(), options, execution);
}

class Parts
{
public:
  Parts(const Soup& soup, const GridSpec& grid, const TestOptions& options)
    : execution_(options.threads)
    , options_(options)
    , prepared_(preparedWith(soup, grid, options, execution_))
    , decomposition_(decompose(prepared_, options, execution_))
  {
  }

  std::vector<SlabRange> split(std::size_t count)
  {
    return decomposition_->split(decomposition_->estimateLayers(execution_), count);
  }

  std::vector<SlabRange> eachLayer() const
  {
    std::vector<SlabRange> layers;
    for (std::uint32_t k = 0; k < decomposition_->allLayers().end; ++k)
    {
      layers.push_back({ k, k + 1 });
    }
    return layers;
  }

  Part part(SlabRange core, Id pointsBefore)
  {
    const auto assembly = meshPart(prepared_, *decomposition_, core, options_, execution_);
    const OutputMesh& mesh = *assembly->mesh;
    Part part;
    part.mesh = arraysOf(mesh, assembly->boxes, execution_);
    part.globalPoint.resize(part.mesh.points.size() / 3);
    mesh.writeGlobalPoints(pointsBefore, part.globalPoint.data(), execution_);
    part.ownPoints = mesh.ownPointCount();
    part.statistics = statisticsOf(*assembly);
    return part;
  }

private:
  Execution execution_;
  TestOptions options_;
  PreparedSurface prepared_;
  std::unique_ptr<Decomposition> decomposition_;
};

// Assembles the whole mesh from its parts. Points that several parts have must agree.
class Union
{
public:
  void add(const Part& part)
  {
    const MeshArrays& m = part.mesh;
    addPoints(part);
    const auto cellsBefore = static_cast<Id>(all_.cells());
    const auto point = [&](Id local) { return part.globalPoint.at(std::size_t(local)); };
    all_.offsets.resize(all_.cells()); // its end follows
    for (const Id offset : m.offsets)
    {
      all_.offsets.push_back(static_cast<Id>(all_.connectivity.size()) + offset);
    }
    for (const Id start : m.faceStart)
    {
      all_.faceStart.push_back(start < 0 ? start : start + Id(all_.faceStream.size()));
    }
    for (const Id local : m.connectivity)
    {
      all_.connectivity.push_back(point(local));
    }
    addFaceStream(m.faceStream, point);
    append(m.types, all_.types);
    append(m.globalBox, all_.globalBox);
    append(m.level, all_.level);
    append(m.region, all_.region);
    append(m.volumeFraction, all_.volumeFraction);
    all_.boundaryStart.resize(all_.boundaryCell.size());
    for (const Id start : m.boundaryStart)
    {
      all_.boundaryStart.push_back(static_cast<Id>(all_.boundaryPoints.size()) + start);
    }
    for (const Id local : m.boundaryPoints)
    {
      all_.boundaryPoints.push_back(point(local));
    }
    for (const Id cell : m.boundaryCell)
    {
      all_.boundaryCell.push_back(cellsBefore + cell);
    }
    append(m.boundaryIndex, all_.boundaryIndex);
    all_.meshlines = m.meshlines;
    all_.step = m.step;
    for (const auto& [name, value] : part.statistics)
    {
      statistics_[name] += value;
    }
    ownPoints_ += part.ownPoints;
  }

  const MeshArrays& mesh() const { return all_; }
  Id ownPoints() const { return ownPoints_; }
  const std::map<std::string, double>& statistics() const { return statistics_; }

private:
  template <class Array>
  static void append(const Array& from, Array& to)
  {
    to.insert(to.end(), from.begin(), from.end());
  }

  void addPoints(const Part& part)
  {
    for (std::size_t p = 0; p < part.globalPoint.size(); ++p)
    {
      const auto id = static_cast<std::size_t>(part.globalPoint[p]);
      if (p > 0)
      {
        ASSERT_LT(part.globalPoint[p - 1], part.globalPoint[p]);
      }
      if (3 * id >= all_.points.size())
      {
        all_.points.resize(3 * id + 3, std::nan(""));
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        double& x = all_.points[3 * id + axis];
        ASSERT_TRUE(std::isnan(x) || x == part.mesh.points[3 * p + axis]);
        x = part.mesh.points[3 * p + axis];
      }
    }
  }

  template <class PointOf>
  void addFaceStream(const std::vector<Id>& stream, PointOf&& point)
  {
    for (std::size_t i = 0; i < stream.size();)
    {
      const Id faces = stream[i++];
      all_.faceStream.push_back(faces);
      for (Id f = 0; f < faces; ++f)
      {
        const Id size = stream[i++];
        all_.faceStream.push_back(size);
        for (Id corner = 0; corner < size; ++corner)
        {
          all_.faceStream.push_back(point(stream[i++]));
        }
      }
    }
  }

  MeshArrays all_;
  Id ownPoints_ = 0;
  std::map<std::string, double> statistics_;
};

// Equal, but for the order in which volumes are summed.
void expectSame(std::map<std::string, double> one, std::map<std::string, double> other)
{
  for (const char* name : { "VolumeLeftOut", "MeshVolume" })
  {
    EXPECT_NEAR(one.at(name), other.at(name), 1e-12 * one.at(name));
    one.erase(name);
    other.erase(name);
  }
  EXPECT_EQ(one, other);
}

void expectUnion(
  Parts& parts, const Meshed& whole, const std::vector<std::vector<SlabRange>>& splits)
{
  for (const std::vector<SlabRange>& split : splits)
  {
    SCOPED_TRACE(std::to_string(split.size()) + " parts");
    Union all;
    for (const SlabRange& core : split)
    {
      all.add(parts.part(core, all.ownPoints()));
    }
    EXPECT_EQ(whole.mesh.points.size(), 3 * static_cast<std::size_t>(all.ownPoints()));
    EXPECT_TRUE(whole.mesh == all.mesh());
    expectSame(whole.statistics, all.statistics());
  }
}

void expectUnion(const Soup& soup, const GridSpec& grid, const TestOptions& options)
{
  Parts parts(soup, grid, options);
  std::vector<std::vector<SlabRange>> splits = { parts.eachLayer() };
  for (const std::size_t count : cases<std::size_t>({ 1, 2, 3, 5 }))
  {
    splits.push_back(parts.split(count));
    ASSERT_EQ(count, splits.back().size());
  }
  expectUnion(parts, meshOf(soup, grid, options), splits);
}

// Divided where the mesher would divide, and elsewhere.
void expectShapedUnion(const Soup& soup, const GridSpec& grid, const TestOptions& options)
{
  Parts parts(soup, grid, options);
  const auto end = static_cast<std::uint32_t>(parts.eachLayer().size());
  ASSERT_GT(end, 45u); // else parts see all layers
  expectUnion(parts, meshOf(soup, grid, options),
    { parts.split(2), parts.split(4), { { 0, 18 }, { 18, 19 }, { 19, 30 }, { 30, end } } });
}

void expectShapedUnion(const Soup& soup, const GridSpec& grid, int depthEverywhere)
{
  TestOptions options;
  options.refinement = depth(depthEverywhere);
  expectShapedUnion(soup, grid, options);
}

TestOptions automatic(int depthEverywhere, double smallCellRatio = 1e-3)
{
  TestOptions options = asTheyAre(smallCellRatio, depth(depthEverywhere));
  options.patches = PatchSpec();
  return options;
}

// So tall that parts do not see all layers; turned a little, so that no faces lie in the grid's
// planes.
Soup tall(const Soup& soup)
{
  return soup.scaled({ 1, 1, 9 }).turned(0, 2);
}

}

class ShapedParts : public ::testing::TestWithParam<NamedShape>
{
};

TEST_P(ShapedParts, AreTheWholeMesh)
{
  const Soup& soup = GetParam().soup;
  expectUnion(soup, cellsAlongLongest(soup, 12.3), automatic(0));
}

TEST_P(ShapedParts, AreTheWholeRefinedMesh)
{
  const Soup& soup = GetParam().soup;
  expectUnion(soup, cellsAlongLongest(soup, 6.7), automatic(2));
}

TEST_P(ShapedParts, AreTheWholeMeshOfShapedCells)
{
  const Soup soup = tall(GetParam().soup);
  expectShapedUnion(soup, cellsAlongLongest(soup, 61.3), 0);
}

TEST_P(ShapedParts, AreTheWholeRefinedMeshOfShapedCells)
{
  const Soup soup = tall(GetParam().soup);
  expectShapedUnion(soup, cellsAlongLongest(soup, 46.3), 1);
}

TEST_P(ShapedParts, AreTheWholeMeshByDefault)
{
  const Soup& soup = GetParam().soup;
  TestOptions options;
  options.refinement = depth(1);
  expectUnion(soup, cellsAlongLongest(soup, 4.7), options);
}

INSTANTIATE_TEST_SUITE_P(Of, ShapedParts,
  ::testing::Values(NamedShape{ "BumpySphere", bumpySphere(1, 10) },
    NamedShape{ "TurnedBox", box({ 0, 0, 0 }, { 1, 2, 3 }).turned() },
    NamedShape{ "Torus", torus(12, 1, 0.3) }, NamedShape{ "Comb", comb(5) },
    NamedShape{ "NestedSpheres", nestedSpheres() },
    NamedShape{ "BlockWithTubes", blockWithTubes() }),
  nameOf);

TEST(Parts, AreTheWholeMeshAroundADeepPlace)
{
  const Soup soup = bumpySphere(4, 10);
  TestOptions options = automatic(1);
  options.refinement.blocks.push_back({ { 3, 3, 4 }, { 4, 4, 4 }, 3, 3 });
  options.refinement.blocks.push_back({ { 0, 4, 2 }, { 8, 4, 2 }, 4, 0 });
  const Soup region = box({ -0.3, 0, -0.2 }, { 0.2, 2, 0.1 }).turned();
  options.refinement.regions.push_back({ region.view(), 3 });
  expectUnion(soup, cellsAlongLongest(soup, 8), options);
}

// Boxes at the low end are divided for those at the high end.
TEST(Parts, AreTheWholeMeshWithPeriodicSides)
{
  const Soup ball = sphere(6, 0.3).moved({ 0.5, 0.5, 27.6 });
  TestOptions options = automatic(3);
  options.refinement.periodic = 0b111;
  options.domain.domain = Domain::Outside;
  options.domain.boxFrom = BoxSource::Bounds;
  options.domain.bounds = { { 0, 0, 0 }, { 2, 2, 28 } };
  expectUnion(ball, cellsOf(1), options);
}

// For balance, a tiny region divides global boxes far away from it (TestBalance.cpp).
TEST(Parts, AreTheWholeMeshFarFromADeepPlace)
{
  const Soup soup = box({ 0, 0, 0 }, { 1, 1, 14 });
  GridSpec grid = cellsOf(1);
  grid.meshlines[0] = grid.meshlines[1] = { -0.9, 0.1, 1.1 };
  TestOptions options = asTheyAre();
  const Soup ball = sphere(1, 0.002).moved({ 0.46, 0, 2.964 });
  options.refinement.regions.push_back({ ball.view(), DeepestLevel });
  const MeshArrays mesh = meshOf(soup, grid, options).mesh;
  int farthest = 0;
  for (std::size_t c = 0; c < mesh.cells(); ++c)
  {
    const bool divided = std::any_of(
      &mesh.level[3 * c], &mesh.level[3 * c] + 3, [](unsigned char level) { return level > 0; });
    farthest = std::max(farthest, divided ? mesh.globalBox[3 * c + 2] : 0);
  }
  ASSERT_EQ(farthest, 2 + int(balanceReach(DeepestLevel, 1)));
  expectUnion(soup, grid, options);
}

// What is cut off goes in all parts or in none, wherever they are divided (Cells/Fragments.h).
TEST(Parts, AreTheWholeMeshWithoutFragments)
{
  Soup soup;
  for (int i = 0; i < 12; ++i)
  {
    soup.add(beadOnAThread(0.001).moved({ 0.03 * i, 0.02 * i, 4.93 * i }));
  }
  const GridSpec grid = cellsAlongLongest(soup, 61.3);
  ASSERT_GT(meshOf(soup, grid, TestOptions()).statistics.at("FragmentCellsRemoved"), 5);
  expectShapedUnion(soup, grid, 0);
}

// A ball in a block that a baffle divides.
TEST(Parts, AreTheWholeMeshOfSeveralRegions)
{
  Soup soup;
  soup.addRegion(sphere(5, 0.3).moved({ 0.4, 0.5, 0.5 }));
  soup.addRegion(cube());
  soup.boundary.assign(soup.triangles.size(), 0);
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (const Vector& corner : { Vector{ 0.85, 0, 0 }, Vector{ 0.9, 1, 0 }, Vector{ 0.8, 0, 1 } })
  {
    soup.points.push_back(corner);
  }
  soup.points.push_back({ 0.85, 1, 1 });
  for (const std::array<std::uint32_t, 3>& t :
    { std::array<std::uint32_t, 3>{ 0, 1, 3 }, { 0, 3, 2 } })
  {
    soup.triangles.push_back({ first + t[0], first + t[1], first + t[2] });
    soup.boundary.push_back(1);
    soup.region.push_back(FirstRegion + 1);
  }
  TestOptions options;
  options.baffles = { { 1, 2 } };
  expectShapedUnion(tall(soup), cellsAlongLongest(tall(soup), 46.3), options);
}

TEST(Parts, AreTheWholeMeshByExactFit)
{
  const Soup soup = bumpySphere(5, 8);
  expectUnion(soup, cellsAlongLongest(soup, 9), asTheyAre(0, depth(1), 3));
}

TEST(Parts, AreTheWholeMeshWhereSmallCellsAreRemoved)
{
  const Soup soup = bumpySphere(6, 8);
  expectUnion(soup, cellsAlongLongest(soup, 14), automatic(0, 0.3));
}

TEST(Parts, AreTheWholeMeshOfAFlawedSurface)
{
  Soup soup = bumpySphere(7, 12);
  soup.triangles.erase(soup.triangles.begin() + 100, soup.triangles.begin() + 140);
  soup.boundary.clear();
  soup.add(sphere(6, 0.4).moved({ 0.8, 0.1, 0.2 }));
  expectUnion(soup, cellsAlongLongest(soup, 25), automatic(0));
  expectUnion(kleinBottle(12), cellsAlongLongest(kleinBottle(12), 25), automatic(0));
}

TEST(Parts, AreTheWholeMeshCutOffByMeshlines)
{
  const Soup soup = bumpySphere(8, 10);
  GridSpec grid = cellsAlongLongest(soup, 12);
  grid.meshlines[2] = { -0.5, -0.3, -0.25, -0.1, 0, 0.05, 0.2, 0.4 };
  expectUnion(soup, grid, automatic(1));
}

// ... by as many as needed, but no more than there are layers.
TEST(Parts, AreAsManyAsMemoryAsksFor)
{
  const Soup soup = bumpySphere(9, 10);
  const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, 150));
  Execution execution;
  const auto needed = [&](double bytes) {
    const Decomposition decomposition(
      prepared.surface, prepared.planes, {}, { bytes }, {}, execution);
    return decomposition.partsNeeded(decomposition.estimateLayers(execution));
  };
  const double whole = estimateMesh(prepared.surface, prepared.planes).bytes({ 0 });
  EXPECT_EQ(1u, needed(2 * whole));
  EXPECT_GE(needed(whole / 2), 2u);
  EXPECT_LE(needed(whole / 2), 5u);
  EXPECT_GT(needed(whole / 3), needed(whole / 2));
  EXPECT_THROW(needed(whole / 100), Error);
}

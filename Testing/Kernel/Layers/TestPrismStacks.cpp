// Boundary layers on finished meshes.
#include "Layers/BoundaryLayers.h"

#include "Base/Error.h"
#include "Polyhedra/CellGeometry.h"
#include "Support/MeshChecker.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace cartesian
{

namespace
{

struct Layered
{
  PreparedSurface prepared;
  std::unique_ptr<Assembly> assembly;
  MeshArrays plain; // before there were layers
  MeshArrays mesh;  // as its points are with layers, without these

  const PrismStacks& stacks() const { return assembly->layers->stacks; }

  Vector point(Id p) const
  {
    const auto own = static_cast<std::size_t>(p);
    const std::size_t count = mesh.points.size() / 3;
    const double* const at =
      own < count ? &mesh.points[3 * own] : &stacks().points[3 * (own - count)];
    return { at[0], at[1], at[2] };
  }
};

Layered meshWithLayers(const Soup& soup, TestOptions options)
{
  Execution execution(options.threads);
  Layered result;
  options.memoryLimit = PlentyOfMemory;
  result.prepared = prepareSurface(soup.view(), options, execution);
  const auto decomposition = decompose(result.prepared, options, execution);
  result.assembly =
    meshPart(result.prepared, *decomposition, decomposition->allLayers(), options, execution);
  result.mesh = arraysOf(*result.assembly->mesh, result.assembly->boxes, execution);
  result.plain = result.mesh;
  for (const MovedPoint& moved : result.stacks().moved)
  {
    std::copy(moved.to.begin(), moved.to.end(), &result.mesh.points[3 * std::size_t(moved.point)]);
  }
  return result;
}

std::vector<Face> facesAt(const std::vector<Id>& stream, Id start)
{
  std::vector<Face> faces;
  auto at = stream.begin() + start;
  for (Id left = *at++; left > 0; --left)
  {
    faces.emplace_back(at + 1, at + 1 + *at);
    at += *at + 1;
  }
  return faces;
}

// Of the pyramids over a face's triangles, with the origin.
double volumeUnder(const Layered& layered, const Face& face)
{
  double sum = 0;
  Vector centre{};
  for (const Id p : face)
  {
    centre = plus(centre, scaled(layered.point(p), 1.0 / double(face.size())));
  }
  for (std::size_t i = 0; i < face.size(); ++i)
  {
    sum += dot(centre, cross(layered.point(face[i]), layered.point(face[(i + 1) % face.size()])));
  }
  return sum / 6;
}

struct LayerCells
{
  std::size_t notPositive = 0;
  std::size_t fewFaces = 0;       // cells of less than four
  std::size_t open = 0;           // cells with an edge that is not used once each way
  std::size_t unmatchedFaces = 0; // that are neither shared nor boundary
};

LayerCells examine(const Layered& l)
{
  LayerCells result;
  std::map<std::set<Id>, int> uses;
  for (std::size_t c = 0; c < l.stacks().cells(); ++c)
  {
    double volume = 0;
    std::map<std::pair<Id, Id>, int> edges;
    const std::vector<Face> faces = facesAt(l.stacks().faceStream, l.stacks().faceStart[c]);
    result.fewFaces += faces.size() < 4 ? 1 : 0;
    for (const Face& face : faces)
    {
      volume += volumeUnder(l, face);
      ++uses[{ face.begin(), face.end() }];
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        const Id next = face[(i + 1) % face.size()];
        ++edges[{ face[i], next }];
        --edges[{ next, face[i] }];
      }
    }
    result.notPositive += volume > 0 ? 0 : 1;
    result.open +=
      std::any_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 0; });
  }
  for (std::size_t f = 0; f + 1 < l.mesh.boundaryStart.size(); ++f) // where stacks stand
  {
    ++uses[{ l.mesh.boundaryPoints.begin() + l.mesh.boundaryStart[f],
      l.mesh.boundaryPoints.begin() + l.mesh.boundaryStart[f + 1] }];
  }
  const BoundaryMesh& boundary = l.assembly->layers->boundary.mesh;
  for (std::size_t f = 0; f + 1 < boundary.start.size(); ++f)
  {
    std::set<Id> points;
    for (Id i = boundary.start[f]; i < boundary.start[f + 1]; ++i)
    {
      points.insert(boundary.meshPoint[boundary.corners[i]]);
    }
    ++uses[points];
  }
  for (const auto& use : uses)
  {
    result.unmatchedFaces += use.second == 2 ? 0 : 1;
  }
  return result;
}

// The least FaceWeight of the sides between two stacks; 0.5 if there are none.
double thinnestSide(const Layered& l)
{
  struct Beside
  {
    std::size_t stack;
    double height; // of the cell's centre over the face
  };
  std::map<std::set<Id>, std::vector<Beside>> sides;
  for (std::size_t c = 0; c < l.stacks().cells(); ++c)
  {
    const std::vector<Face> faces = facesAt(l.stacks().faceStream, l.stacks().faceStart[c]);
    std::vector<FaceGeometry> measures;
    measures.reserve(faces.size());
    for (const Face& face : faces)
    {
      measures.push_back(measureFace(face.size(), [&](std::size_t i) { return l.point(face[i]); }));
    }
    const Vector centre = measureCell(faces.size(), [&](std::size_t i) -> const FaceGeometry& {
      return measures[i];
    }).centre;
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      const double height = dot(minus(measures[f].centre, centre), unit(measures[f].area));
      sides[{ faces[f].begin(), faces[f].end() }].push_back({ l.stacks().face[c], height });
    }
  }
  double least = 0.5;
  for (const auto& [points, cells] : sides)
  {
    if (cells.size() == 2 && cells[0].stack != cells[1].stack)
    {
      const auto [low, high] = std::minmax(cells[0].height, cells[1].height);
      least = std::min(least, low / (low + high));
    }
  }
  return least;
}

// Enclosed by the boundary.
double meshVolume(const Layered& layered)
{
  const BoundaryMesh& boundary = layered.assembly->layers->boundary.mesh;
  double sum = 0;
  for (std::size_t f = 0; f + 1 < boundary.start.size(); ++f)
  {
    Face face;
    for (Id i = boundary.start[f]; i < boundary.start[f + 1]; ++i)
    {
      face.push_back(boundary.meshPoint[boundary.corners[i]]);
    }
    sum += volumeUnder(layered, face);
  }
  return sum;
}

std::size_t countFailing(const Quality& quality, Measure measure)
{
  const auto& values = quality.cells[measure];
  return static_cast<std::size_t>(std::count_if(
    values.begin(), values.end(), [&](double value) { return fails(measure, value); }));
}

// As parts of the boundary that is to have layers, by area.
struct Coverage
{
  double covered = 0; // has all
  double filled = 0;  // each face counts by how much of the thickness asked for it has
};

Coverage coverageOf(const Layered& layered)
{
  const BoundaryLayers& layers = *layered.assembly->layers;
  const BoundaryMesh& faces = layers.boundary.mesh;
  Coverage coverage;
  double all = 0;
  for (std::size_t f = 0; f + 1 < faces.start.size(); ++f)
  {
    const double asked = layers.boundary.stacks[f].asked;
    if (asked <= 0)
    {
      continue;
    }
    const auto begin = static_cast<std::size_t>(faces.start[f]);
    const std::size_t corners = static_cast<std::size_t>(faces.start[f + 1]) - begin;
    const double area = norm(measureFace(corners, [&](std::size_t i) {
      return layered.point(faces.meshPoint[static_cast<std::size_t>(faces.corners[begin + i])]);
    }).area);
    all += area;
    coverage.covered += layers.boundary.stacks[f].layers == layers.spec.count ? area : 0;
    coverage.filled += area * std::min(1.0, layers.boundary.stacks[f].thickness / asked);
  }
  return { coverage.covered / all, coverage.filled / all };
}

void expectCovered(const Layered& layered, const Coverage& least)
{
  const Coverage coverage = coverageOf(layered);
  EXPECT_GE(coverage.covered, least.covered);
  EXPECT_GE(coverage.filled, least.filled);
}

TestOptions fiveLayers(double first, int threads = 1)
{
  TestOptions options = asTheyAre(0, {}, threads);
  options.layers.count = 5;
  options.layers.firstThickness = first;
  return options;
}

void expectFilled(const Soup& soup, TestOptions options, double cells, const Coverage& least)
{
  options.grid = cellsAlongLongest(soup, cells);
  const Layered layered = meshWithLayers(soup, options);
  const LayerCells found = examine(layered);
  EXPECT_EQ(found.fewFaces, 0U);
  EXPECT_EQ(found.open, 0U);
  EXPECT_EQ(found.notPositive, 0U);
  EXPECT_EQ(found.unmatchedFaces, 0U);
  expectCovered(layered, least);
  EXPECT_NEAR(meshVolume(layered) / soup.volume(), 1, 1e-9);
}

}

// Slivers of Exact Fit, which nothing merges here, end the layers of the faces around them.
TEST(PrismStacks, FillASphere)
{
  expectFilled(sphere(8, 1), fiveLayers(0.005), 20, { 0.09, 0.14 });
}

TEST(PrismStacks, FillATurnedCube)
{
  expectFilled(cube().turned(), fiveLayers(0.0025), 20, { 0.6, 0.7 });
}

TEST(PrismStacks, SlideWithinBoundariesWithoutLayers)
{
  TestOptions options = fiveLayers(0.0025);
  options.layers.boundaries = { { 0, 0 }, { 1, 0 } };
  expectFilled(cube().turned(), options, 20, { 0.6, 0.7 });
}

// As thick as asked, but where cells are cut off at edges.
TEST(PrismStacks, DifferOnBoundaries)
{
  constexpr std::array<double, 6> Asked{ 0.01, 0, 0.03, 0.02, 0.02, 0.015 };
  const Soup soup = cube();
  TestOptions options = fiveLayers(0);
  options.layers.thickness = 0.02;
  options.layers.boundaries = { { 0, Asked[0] }, { 1, 0 }, { 2, Asked[2] }, { 5, Asked[5] } };
  options.grid = cellsAlongLongest(soup, 20);
  const Layered layered = meshWithLayers(soup, options);
  EXPECT_EQ(examine(layered).unmatchedFaces, 0U);
  expectCovered(layered, { 0.85, 0.88 });
  EXPECT_NEAR(meshVolume(layered), 1, 1e-9);
  const LayeredBoundary& boundary = layered.assembly->layers->boundary;
  std::array<std::size_t, 6> faces{};
  std::array<std::size_t, 6> asAsked{};
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
  {
    const auto side = static_cast<std::size_t>(boundary.faces[f].boundary);
    ++faces[side];
    asAsked[side] += std::abs(boundary.stacks[f].thickness - Asked[side]) < 1e-6;
  }
  for (std::size_t side = 0; side < faces.size(); ++side)
  {
    EXPECT_GT(2 * asAsked[side], faces[side]) << side;
  }
}

// Along z from 0 to 4 with a radius of 1: boundary 0, with ends 1 and 2.
Soup pipe(std::uint32_t facets)
{
  Soup soup;
  soup.points = { { 0, 0, 0 }, { 0, 0, 4 } };
  for (std::uint32_t i = 0; i < facets; ++i)
  {
    const double angle = 2 * Pi * i / facets;
    soup.points.push_back({ std::cos(angle), std::sin(angle), 0 });
    soup.points.push_back({ std::cos(angle), std::sin(angle), 4 });
    const std::uint32_t a = 2 + 2 * i;
    const std::uint32_t b = 2 + 2 * ((i + 1) % facets);
    soup.triangles.insert(soup.triangles.end(),
      { { a, b, b + 1 }, { a, b + 1, a + 1 }, { 0, b, a }, { 1, a + 1, b + 1 } });
    soup.boundary.insert(soup.boundary.end(), { 0, 0, 1, 2 });
  }
  return soup;
}

// Boxes are ten times as long as the rim's edges.
TEST(PrismStacks, AreCompleteAlongFinelyDividedRims)
{
  const Soup soup = pipe(400).turned();
  TestOptions options;
  options.layers.count = 5;
  options.layers.firstThickness = 0.01;
  options.layers.boundaries = { { 1, 0 }, { 2, 0 } };
  options.grid = cellsAlongLongest(soup, 20);
  const Layered layered = meshWithLayers(soup, options);
  const LayerCells found = examine(layered);
  EXPECT_EQ(found.fewFaces, 0U);
  EXPECT_EQ(found.open, 0U);
  EXPECT_EQ(found.unmatchedFaces, 0U);
  const LayeredBoundary& boundary = layered.assembly->layers->boundary;
  std::size_t walls = 0;
  std::size_t thin = 0;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
  {
    const bool isWall = boundary.faces[f].boundary == 0;
    walls += isWall;
    thin += isWall && boundary.stacks[f].thickness < 0.5 * boundary.stacks[f].asked;
  }
  EXPECT_GT(walls, 500U);
  EXPECT_LT(12 * thin, walls); // 50 of 691
}

// Where walls are wider than boxes, all of them have layers, thinner ones in corners. Others are named here.
Coverage leastCoverage(const std::string& shape)
{
  static const std::map<std::string, Coverage> OfNarrowOnes{
    { "ThinPlate", { 0, 0 } }, // thinner than the layers, where they may take a third of it
    { "ThinPlateTurned", { 0, 0 } },
    { "Needle", { 0, 0 } },
    { "Flat", { 0, 0 } },
    { "Comb", { 0.35, 0.2 } }, // teeth and gaps are half as wide as boxes
    { "CombTurned", { 0, 0 } },
    { "StarPolyhedron", { 0.25, 0.35 } },
    { "BumpySphere", { 0.4, 0.45 } },
    { "Tiny", { 0.25, 0.32 } },
  };
  const auto named = OfNarrowOnes.find(shape);
  return named == OfNarrowOnes.end() ? Coverage{ 0.75, 0.8 } : named->second;
}

class LayersOnShapes : public ::testing::TestWithParam<NamedShape>
{
};

// The walls stay, no volume is lost, and solvers refuse nothing that they would accept without layers.
TEST_P(LayersOnShapes, AreAcceptedAndTakeNothingAway)
{
  const Soup& soup = GetParam().soup;
  TestOptions options;
  options.grid = cellsAlongLongest(soup, 8);
  options.layers.count = 3;
  const Layered layered = meshWithLayers(soup, options);
  expectCovered(layered, leastCoverage(GetParam().name));
  const LayerCells found = examine(layered);
  EXPECT_EQ(found.fewFaces, 0U);
  EXPECT_EQ(found.open, 0U);
  EXPECT_EQ(found.notPositive, 0U);
  EXPECT_EQ(found.unmatchedFaces, 0U);
  EXPECT_GE(thinnestSide(layered), 0.0199); // 0.02, but for rounding
  const Quality before = qualityOf(layered.plain);
  const Quality quality = qualityOf(withLayers(layered.plain, *layered.assembly->layers));
  for (const Measure measure :
    { Volume, Openness, OpenEdges, BoundaryAngle, NonOrthogonality, Skewness, AspectRatio })
  {
    EXPECT_LE(countFailing(quality, measure), countFailing(before, measure))
      << MeasureSpecs[measure].name;
  }
  const auto sum = [](const Quality& of) {
    const auto& volumes = of.cells[Volume];
    return std::accumulate(volumes.begin(), volumes.end(), 0.0);
  };
  EXPECT_NEAR(sum(quality) / sum(before), 1, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Of, LayersOnShapes, ::testing::ValuesIn(cleanShapes()), nameOf);

// Nodes of its stacks' points, by whether they taper.
std::array<std::set<std::size_t>, 2> nodesOfStacks(const PrismStacks& stacks, Id meshPoints)
{
  std::array<std::set<std::size_t>, 2> nodes;
  for (std::size_t c = 0; c < stacks.cells(); ++c)
  {
    for (Id i = stacks.offsets[c]; i < stacks.offsets[c + 1]; ++i)
    {
      const Id point = stacks.connectivity[static_cast<std::size_t>(i)] - meshPoints;
      if (point >= 0)
      {
        nodes[stacks.tapers[c]].insert(stacks.nodeOfPoint[static_cast<std::size_t>(point)]);
      }
    }
  }
  return nodes;
}

TEST(PrismStacks, TaperInOneCellBesideFullOnes)
{
  const Soup soup = torus(12, 1, 0.35);
  TestOptions options;
  options.grid = cellsAlongLongest(soup, 6);
  options.layers.count = 3;
  const Layered layered = meshWithLayers(soup, options);
  const PrismStacks& stacks = layered.stacks();
  std::map<std::size_t, int> cells; // of each stack
  for (const std::size_t face : stacks.face)
  {
    ++cells[face];
  }
  std::array<int, 2> found{};
  for (std::size_t c = 0; c < stacks.cells(); ++c)
  {
    ++found[stacks.tapers[c]];
    EXPECT_EQ(cells[stacks.face[c]], stacks.tapers[c] ? 1 : 3);
  }
  EXPECT_GT(std::min(found[0], found[1]), 20);
  const auto [full, tapering] = nodesOfStacks(stacks, layered.assembly->mesh->pointCount());
  EXPECT_TRUE(std::includes(full.begin(), full.end(), tapering.begin(), tapering.end()));
}

TEST(PrismStacks, AreTheSameForThreads)
{
  const Soup soup = sphere(8, 1);
  TestOptions one = fiveLayers(0.005);
  one.grid = cellsAlongLongest(soup, 20);
  TestOptions four = one;
  four.threads = 4;
  const Layered a = meshWithLayers(soup, one);
  const Layered b = meshWithLayers(soup, four);
  EXPECT_GT(a.stacks().cells(), 0U);
  EXPECT_EQ(a.stacks().points, b.stacks().points);
  EXPECT_EQ(a.stacks().faceStream, b.stacks().faceStream);
}

// Of the cell at a boundary face, or of the one under its stack.
Box boxAt(const Layered& layered, const BoundaryFace& face)
{
  const OutputMesh& mesh = *layered.assembly->mesh;
  const std::vector<Id>& numbers = layered.assembly->layers->numbers;
  const Id own = std::find(numbers.begin(), numbers.end(), face.cell) - numbers.begin();
  const Id above = own - mesh.cellCount();
  const Id cell = above < 0 ? own : layered.stacks().below[static_cast<std::size_t>(above)];
  return layered.assembly->boxes.box(mesh.boxOf(cell));
}

// Around a cube, one of whose sides has boxes a quarter as wide as the others, layers are by default as thick as a
// third of the box beside them.
TEST(PrismStacks, FollowTheBoxesBesideThem)
{
  const Soup soup = cube().turned();
  TestOptions options;
  options.layers.count = 3;
  options.domain.domain = Domain::Outside;
  options.domain.before = options.domain.behind = options.domain.beside = 0.5;
  options.grid = cellsAlongLongest(soup, 8);
  options.refinement.boundaries = { { 0, 2 } };
  const Layered layered = meshWithLayers(soup, options);
  EXPECT_EQ(examine(layered).unmatchedFaces, 0U);
  EXPECT_EQ(examine(layered).notPositive, 0U);
  const LayeredBoundary& boundary = layered.assembly->layers->boundary;
  std::map<int, std::array<std::size_t, 2>>
    byLevel; // faces with layers half as thick or more, and all
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
  {
    if (boundary.stacks[f].asked > 0)
    {
      const Box box = boxAt(layered, boundary.faces[f]);
      double side = box.high[0] - box.low[0];
      side = std::min({ side, double(box.high[1] - box.low[1]), double(box.high[2] - box.low[2]) });
      side *= layered.prepared.surface.lattice.step();
      EXPECT_NEAR(boundary.stacks[f].asked / side, 1.0 / 3, 0.004);
      byLevel[box.level[0]][0] += boundary.stacks[f].thickness >= side / 6;
      ++byLevel[box.level[0]][1];
    }
  }
  ASSERT_EQ(byLevel.size(), 3U);
  for (const auto& [level, faces] : byLevel)
  {
    EXPECT_GT(2 * faces[0], faces[1]) << level;
  }
}

// Where a body is nearly on the ground there is room for no layer: none goes through the ground.
TEST(PrismStacks, StayInTheFlowDomain)
{
  TestOptions options;
  options.layers.count = 3;
  options.domain.domain = Domain::Outside;
  options.domain.boxFrom = BoxSource::Bounds;
  options.refinement = depth(2);
  const auto lowest = [](const std::vector<double>& points) {
    double z = points[2];
    for (std::size_t i = 2; i < points.size(); i += 3)
    {
      z = std::min(z, points[i]);
    }
    return z;
  };
  for (const Soup& soup : { sphere(8, 1), cube().turned(), torus(12, 1, 0.4) })
  {
    for (const double gap : { 0.0, 0.003, 0.006, 0.01, 0.02, 0.03 })
    {
      SCOPED_TRACE(gap);
      const auto low = soup.low();
      const auto high = soup.high();
      options.domain.bounds = { { low[0] - 0.5, low[1] - 0.5, low[2] - gap },
        { high[0] + 0.5, high[1] + 0.5, high[2] + 0.5 } };
      options.grid = cellsAlongLongest(soup, 8);
      const Layered layered = meshWithLayers(soup, options);
      const double ground = lowest(layered.plain.points) - 1e-9;
      EXPECT_GE(lowest(layered.mesh.points), ground);
      EXPECT_GE(lowest(layered.stacks().points), ground);
    }
  }
}

// Walls that come together leave ever less room for layers.
TEST(PrismStacks, AreNoFilms)
{
  Soup soup;
  soup.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0.4, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 0.4, 1 } };
  soup.triangles = { { 0, 2, 1 }, { 3, 4, 5 }, { 0, 1, 4 }, { 0, 4, 3 }, { 1, 2, 5 }, { 1, 5, 4 },
    { 2, 0, 3 }, { 2, 3, 5 } };
  soup.boundary.assign(soup.triangles.size(), 0);
  TestOptions options;
  options.layers.count = 3;
  options.layers.thickness = 0.02;
  options.grid = cellsAlongLongest(soup, 40);
  const Layered layered = meshWithLayers(soup, options);
  const LayeredBoundary& boundary = layered.assembly->layers->boundary;
  std::size_t thin = 0;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
  {
    const double part = boundary.stacks[f].thickness / boundary.stacks[f].asked;
    thin += part > 0 && part < 1;
    EXPECT_TRUE(!(part > 0) || part >= 0.12) << part;
  }
  EXPECT_GT(thin, 0U);
}

}

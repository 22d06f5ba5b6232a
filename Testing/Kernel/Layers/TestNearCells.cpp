// SPDX-License-Identifier: BSD-3-Clause
// The cells near the walls, as they are found in the mesh, and by brute force in the arrays that it writes.
#include "Layers/NearCells.h"

#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

constexpr int Rings = 2;
constexpr int Far = Rings + 2;

struct WithWall
{
  WithWall(const Soup& soup, double cells, TestOptions options)
    : assembly(assembledOf(soup, cellsAlongLongest(soup, cells), options, execution))
    , mesh(*assembly->mesh)
    , points(3 * static_cast<std::size_t>(mesh.pointCount()))
  {
    mesh.writePoints(points.data(), execution);
    options.layers.count = 1; // from here on: the mesh is made as if there were none
    wall = findLayeredWall(layerRegions(mesh, assembly->patches.walls, execution).front(), mesh,
      points, options.layers, execution);
    near = findNearCells(mesh, wall, Rings, execution);
  }

  Execution execution;
  std::unique_ptr<Assembly> assembly;
  const OutputMesh& mesh;
  std::vector<double> points;
  LayeredWall wall;
  NearCells near;
};

// Of a cube.
TestOptions layersOnOneSide()
{
  TestOptions options;
  for (std::int32_t side = 1; side < 6; ++side)
  {
    options.layers.boundaries.push_back({ side, 0 });
  }
  return options;
}

// As they are written, hexahedra first; each with its points in order, and those of each face in a polyhedron.
struct Written
{
  std::vector<std::vector<Id>> points;
  std::vector<std::vector<std::vector<Id>>> faces; // of hexahedra none

  Written(const OutputMesh& mesh, Execution& execution)
  {
    const auto cells = static_cast<std::size_t>(mesh.cellCount());
    std::vector<Id> offsets(cells + 1);
    std::vector<Id> connectivity(static_cast<std::size_t>(mesh.connectivitySize()));
    std::vector<unsigned char> types(cells);
    std::vector<Id> faceStart(cells);
    std::vector<Id> stream(static_cast<std::size_t>(mesh.faceStreamSize()));
    mesh.writeCells(
      { offsets.data(), connectivity.data(), types.data(), faceStart.data(), stream.data(), 0, 1 },
      execution);
    faces.resize(cells);
    for (std::size_t c = 0; c < cells; ++c)
    {
      const auto begin = connectivity.begin();
      points.emplace_back(begin + offsets[c], begin + offsets[c + 1]);
      auto at = stream.begin() + faceStart[c];
      for (Id left = types[c] == 0 ? 0 : *at++; left > 0; --left)
      {
        faces[c].emplace_back(at + 1, at + 1 + *at);
        at += *at + 1;
      }
    }
  }
};

std::size_t index(Id point)
{
  return static_cast<std::size_t>(point);
}

// How many cells are between a node and each point, at most Far: for all nodes by themselves, so that it is known
// which is nearest.
std::vector<int> distancesFrom(std::size_t node, const Written& written, std::size_t points)
{
  std::vector<int> distance(points, Far);
  distance[node] = 0;
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const std::vector<Id>& cell : written.points)
    {
      int least = Far;
      for (const Id p : cell)
      {
        least = std::min(least, distance[index(p)] + 1);
      }
      for (const Id p : cell)
      {
        changed = changed || least < distance[index(p)];
        distance[index(p)] = std::min(distance[index(p)], least);
      }
    }
  }
  return distance;
}

struct Expected
{
  std::vector<int> distance; // of each point from the wall
  std::vector<std::uint32_t> origin;

  Expected(const LayeredWall& wall, const Written& written, std::size_t points)
    : distance(points, Far)
    , origin(points, None)
  {
    for (std::size_t n = 0; n < wall.nodes(); ++n)
    {
      if (!wall.isOnWall[n])
      {
        continue;
      }
      const std::vector<int> own = distancesFrom(index(wall.of.mesh.meshPoint[n]), written, points);
      for (std::size_t p = 0; p < points; ++p)
      {
        origin[p] = own[p] < distance[p] ? static_cast<std::uint32_t>(n) : origin[p];
        distance[p] = std::min(distance[p], own[p]);
      }
    }
  }

  // How many cells are between a cell and the wall.
  int of(const std::vector<Id>& cell) const
  {
    int least = Far;
    for (const Id p : cell)
    {
      least = std::min(least, distance[index(p)]);
    }
    return least;
  }
};

std::vector<std::vector<Id>> facesOf(const CellFaces& cells, std::size_t c)
{
  std::vector<std::vector<Id>> faces;
  for (std::size_t f = cells.firstFace[c]; f < cells.firstFace[c + 1]; ++f)
  {
    const auto begin = cells.corners.begin();
    faces.emplace_back(begin + static_cast<std::ptrdiff_t>(cells.firstCorner[f]),
      begin + static_cast<std::ptrdiff_t>(cells.firstCorner[f + 1]));
  }
  return faces;
}

// Six quadrangles, with each edge once each way.
bool isHexahedron(const std::vector<std::vector<Id>>& faces, const std::vector<Id>& points)
{
  std::map<std::pair<Id, Id>, int> edges;
  std::set<Id> used;
  for (const std::vector<Id>& face : faces)
  {
    used.insert(face.begin(), face.end());
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const Id next = face[(i + 1) % face.size()];
      ++edges[{ face[i], next }];
      --edges[{ next, face[i] }];
    }
  }
  return faces.size() == 6 && edges.size() == 24 &&
    used == std::set<Id>(points.begin(), points.end()) &&
    std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

void expectAsWritten(const WithWall& with)
{
  Execution execution;
  const NearCells& near = with.near;
  const Written written(with.mesh, execution);
  const std::size_t points = near.origin.size();
  const Expected expected(with.wall, written, points);
  std::vector<std::uint8_t> mayMove(points);
  for (std::size_t p = 0; p < points; ++p)
  {
    mayMove[p] = expected.distance[p] > 0 && expected.distance[p] <= Rings;
  }
  std::vector<Id> places;
  for (std::size_t c = 0; c < written.points.size(); ++c)
  {
    const std::vector<Id>& cell = written.points[c];
    const int distance = expected.of(cell);
    if (distance <= Rings)
    {
      places.push_back(static_cast<Id>(c));
    }
    for (const Id p : cell)
    {
      mayMove[index(p)] = mayMove[index(p)] && distance < Rings;
    }
  }
  ASSERT_EQ(near.places, places);
  EXPECT_LT(places.size(), written.points.size()); // some are farther
  EXPECT_EQ(near.mayMove, mayMove);
  for (std::size_t p = 0; p < points; ++p)
  {
    EXPECT_EQ(near.origin[p], expected.distance[p] < Far ? expected.origin[p] : None) << p;
    EXPECT_EQ(near.wallNode[p], expected.distance[p] == 0 ? expected.origin[p] : None) << p;
  }
  const std::vector<double> volumes = volumesOf(near.cells, with.points, execution);
  for (std::size_t c = 0; c < places.size(); ++c)
  {
    const std::size_t place = index(places[c]);
    const auto faces = facesOf(near.cells, c);
    EXPECT_GT(volumes[c], 0);
    EXPECT_TRUE(written.faces[place].empty() ? isHexahedron(faces, written.points[place])
                                             : faces == written.faces[place]);
  }
}

}

TEST(NearCells, AreAsTheMeshWritesThem)
{
  expectAsWritten({ octahedron(1).turned(), 12, {} });
}

TEST(NearCells, AreAsWrittenWhereBoxesAreDivided)
{
  TestOptions options = layersOnOneSide();
  options.refinement.depth = 1;
  const WithWall with(cube().turned(), 8, options);
  EXPECT_FALSE(with.assembly->sides.divided.empty());
  expectAsWritten(with);
}

TEST(NearCells, AreTheFirstSlabsBesideAFlatWall)
{
  const WithWall with(cube(), 8, layersOnOneSide());
  ASSERT_EQ(with.mesh.cellCount(), 512);
  EXPECT_EQ(with.near.cells.cellCount(), std::size_t(Rings + 1) * 64);
  for (std::size_t p = 0; p < with.near.origin.size(); ++p)
  {
    const double x = 8 * with.points[3 * p];
    const std::uint32_t origin = with.near.origin[p];
    ASSERT_EQ(origin == None, x > Rings + 1.5) << x;
    EXPECT_EQ(with.near.wallNode[p] != None, x < 0.5);
    EXPECT_EQ(with.near.mayMove[p] != 0, x > 0.5 && x < Rings - 0.5) << x;
    for (std::size_t axis = 0; axis < 3 && origin != None; ++axis)
    {
      const double away = std::abs(with.wall.place[origin][axis] - with.points[3 * p + axis]);
      EXPECT_LT(8 * away, x + 0.5);
    }
  }
}

}

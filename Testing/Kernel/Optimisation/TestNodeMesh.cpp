// SPDX-License-Identifier: BSD-3-Clause
// What the nodes at the wall move in: which may, all that changes with them, and what that costs.
#include "Optimisation/MeshEnergy.h"
#include "Optimisation/MovingCells.h"
#include "Optimisation/WorstFaces.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cartesian
{

namespace
{

struct Whole
{
  explicit Whole(const Soup& soup, double cells = 6)
    : a(assembledOf(soup, cellsAlongLongest(soup, cells), asTheyAre(), execution))
    , slab{ a->boxes.allLayers(), a->boxes.allLayers(), a->boxes.allLayers(), a->boxes.allLayers() }
  {
  }

  NodeMesh mesh() const { return nodeMesh(a->boxes, a->sides, a->nodes, a->wall, slab); }

  Execution execution;
  std::unique_ptr<Assembly> a;
  Slab slab;
};

double volumeOf(const NodeMesh& mesh)
{
  double sum = 0;
  for (std::size_t c = 0; c < mesh.cells.changing; ++c)
  {
    sum += mesh.cells.measures[c].volume;
  }
  return sum;
}

}

TEST(MovingCells, AreAllThatHaveAMovingNode)
{
  const Whole whole(octahedron(1).turned());
  MovingCells moving(whole.a->boxes, whole.a->sides, whole.a->nodes, whole.a->wall, whole.slab);
  const WallMesh& wall = whole.a->wall;
  std::size_t movable = 0;
  for (CellKey c = 0; c < wall.size(); ++c)
  {
    bool any = false;
    wall.forEachNodeOf(c, [&](std::uint32_t node) { any = any || moving.isMovable(node); });
    EXPECT_EQ(std::binary_search(moving.cells().begin(), moving.cells().end(), c), any);
    movable += any ? 1 : 0;
  }
  EXPECT_GT(movable, 0U);
  for (const std::uint32_t box : moving.hexahedra())
  {
    bool any = false;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const std::uint32_t node =
        nodeOfCorner(whole.a->boxes, whole.a->sides, whole.a->nodes, box, corner);
      any = any || (node != None && moving.isMovable(node));
    }
    EXPECT_TRUE(any);
  }
}

TEST(NodeMesh, HasNodesByPlaceAndEachFaceOnce)
{
  const NodeMesh mesh = Whole(octahedron(1).turned()).mesh();
  EXPECT_TRUE(std::is_sorted(mesh.nodes.at.begin(), mesh.nodes.at.end()));
  std::set<std::vector<std::uint32_t>> rings;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    std::vector<std::uint32_t> ring(mesh.faces.corners.begin() + mesh.faces.start[f],
      mesh.faces.corners.begin() + mesh.faces.stop[f]);
    std::sort(ring.begin(), ring.end());
    EXPECT_TRUE(rings.insert(ring).second);
  }
  for (std::uint32_t c = 0; c < mesh.cells.changing; ++c)
  {
    for (std::uint32_t u = mesh.cells.firstUse[c]; u < mesh.cells.endUse[c]; ++u)
    {
      const auto& cells = mesh.faces.cells[mesh.cells.uses[u]];
      EXPECT_EQ(std::count(cells.begin(), cells.end(), c), 1);
    }
  }
}

TEST(NodeMesh, IsTheSameInWhateverOrderTrianglesCome)
{
  Soup soup = octahedron(1).turned();
  const NodeMesh one = Whole(soup).mesh();
  std::reverse(soup.triangles.begin(), soup.triangles.end());
  const NodeMesh other = Whole(soup).mesh();
  EXPECT_EQ(one.nodes.at, other.nodes.at);
  EXPECT_EQ(one.nodes.mayMove, other.nodes.mayMove);
  EXPECT_EQ(one.faces.start, other.faces.start);
  EXPECT_EQ(one.faces.corners, other.faces.corners);
}

TEST(MeshEnergy, MeasuresTheCellsAsTheirNodesAre)
{
  const Soup soup = octahedron(1).turned();
  NodeMesh mesh = Whole(soup).mesh();
  const LayerPrisms none = addPrisms(mesh, nullptr);
  const std::vector<double> edges = mesh.edgesAtFaces();
  MeshEnergy energy(mesh, none, edges, std::vector<std::uint8_t>(mesh.faces.size(), 1));
  energy.evaluate();
  const double before = volumeOf(mesh);
  EXPECT_GT(before, 0);
  for (Vector& at : mesh.nodes.at)
  {
    at = scaled(at, 2);
  }
  energy.evaluate();
  EXPECT_NEAR(volumeOf(mesh), 8 * before, 1e-9 * before);
}

// A step against the gradient costs less, as far as the derivatives are exact.
TEST(MeshEnergy, FallsAgainstItsGradient)
{
  const Soup soup = sphere(6, 1);
  NodeMesh mesh = Whole(soup, 9).mesh();
  const LayerPrisms none = addPrisms(mesh, nullptr);
  const std::vector<double> edges = mesh.edgesAtFaces();
  MeshEnergy energy(mesh, none, edges, std::vector<std::uint8_t>(mesh.faces.size(), 1));
  const auto sum = [&] {
    energy.evaluate();
    double all = 0;
    for (const FaceEnergy& face : energy.ofFaces())
    {
      all += face.all;
    }
    return all;
  };
  const double before = sum();
  energy.differentiate();
  std::vector<Vector> gradient(mesh.nodes.at.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    energy.forEachDerivative(f, [&](std::size_t i, const Vector& by) {
      Vector& of = gradient[mesh.faces.corners[mesh.faces.start[f] + i]];
      of = plus(of, by);
    });
  }
  double largest = 0;
  for (std::size_t n = 0; n < gradient.size(); ++n)
  {
    largest = std::max(largest, mesh.nodes.mayMove[n] ? norm(gradient[n]) : 0);
  }
  ASSERT_GT(largest, 0);
  const double step = 1e-5 * std::cbrt(mesh.cells.volumeOfBox.front()) / largest;
  for (std::size_t n = 0; n < gradient.size(); ++n)
  {
    if (mesh.nodes.mayMove[n])
    {
      mesh.nodes.at[n] = plus(mesh.nodes.at[n], scaled(gradient[n], -step));
    }
  }
  EXPECT_LT(sum(), before);
}

// Faces are mended one by one; none of that costs more than it gains, and the mesh stays closed.
TEST(WorstFaces, FallInCostAndKeepTheirVolume)
{
  for (const Soup& soup : { octahedron(1).turned(), bumpySphere(3, 12) })
  {
    NodeMesh mesh = Whole(soup, 8).mesh();
    const double feature = std::cos(radians(30));
    const NodePaths paths(mesh, feature);
    const LayerPrisms none = addPrisms(mesh, nullptr);
    const std::vector<Vector> places = mesh.nodes.at;
    const std::vector<double> edges = mesh.edgesAtFaces();
    MeshEnergy energy(mesh, none, edges, std::vector<std::uint8_t>(mesh.faces.size(), 1));
    energy.evaluate();
    energy.keepStars();
    energy.keepLimits(energy.ofFaces(), 15);
    const auto sum = [&] {
      double all = 0;
      for (std::uint32_t c = 0; c < mesh.cells.changing; ++c)
      {
        for (std::uint32_t u = mesh.cells.firstUse[c]; u < mesh.cells.endUse[c]; ++u)
        {
          all += energy.ofFaces()[mesh.cells.uses[u]].limits;
        }
      }
      return all;
    };
    const double before = sum();
    const double volume = volumeOf(mesh);
    Execution execution;
    const std::vector<FaceEdit> edits =
      mendWorstFaces({ mesh, paths, places, edges, feature }, energy, execution);
    EXPECT_LT(sum(), before);
    EXPECT_NEAR(volumeOf(mesh), volume, 3e-3 * volume);
    EXPECT_TRUE(std::is_sorted(edits.begin(), edits.end(),
      [](const FaceEdit& a, const FaceEdit& b) { return a.face < b.face; }));
    FaceEdits whole(mesh);
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    {
      const auto isGone = std::find_if(edits.begin(), edits.end(), [&](const FaceEdit& edit) {
        return edit.face == mesh.faces.number[f] && edit.ring.empty();
      });
      if (isGone == edits.end())
      {
        EXPECT_GE(mesh.faces.stop[f] - mesh.faces.start[f], 3U);
      }
    }
  }
}

}

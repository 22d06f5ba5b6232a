// SPDX-License-Identifier: BSD-3-Clause
// The mesh at the wall: faces and cells know each other, as they are assembled and after slabs have changed them.
#include "Mesher/Assembly.h"
#include "Polyhedra/CellGeometry.h"
#include "Shaping/CellSplitting.h"
#include "Shaping/RefusedCells.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cartesian
{

namespace
{

std::unique_ptr<Assembly> assembled(
  const Soup& soup, const GridSpec& grid, Execution& execution, int levels = 0)
{
  return assembledOf(soup, grid, asTheyAre(0, depth(levels)), execution);
}

// Enclosed by the star triangles of a cell's faces, in levels; `sum`: of its face vectors.
double volumeOf(const Assembly& a, std::size_t cell, Vector& sum)
{
  const Point origin = a.boxes.lowOf(a.wall.cells[cell].box);
  double volume = 0;
  sum = {};
  a.wall.forEachUse(cell, [&](const FaceUse& use) {
    std::vector<Vector> ring;
    a.wall.faces.forEachNode(
      use, [&](std::uint32_t node) { ring.push_back(minus(a.nodes.at[node], origin)); });
    Vector area{};
    const Vector mean = forEachStarTriangle(
      ring.size(), [&](std::size_t i) { return ring[i]; },
      [&](const Vector&, const Vector&, const Vector& triangle) { area = plus(area, triangle); });
    volume += dot(mean, area) / 3;
    sum = plus(sum, area);
  });
  return volume;
}

double volumeOfBox(const Assembly& a, std::uint32_t b)
{
  const Box box = a.boxes.box(b);
  const Vector size = minus(box.high, box.low);
  return size[0] * size[1] * size[2];
}

bool hasFace(const Assembly& a, std::uint32_t box, std::uint32_t face)
{
  BesideHexahedron beside;
  for (unsigned side = 0; side < 6; ++side)
  {
    lookBeside(a.boxes, a.sides, a.wall, box, side, beside);
    if (std::any_of(beside.faces.begin(), beside.faces.end(), [&](const FaceUse& use) {
          return use.face == face && a.wall.faces.cells[face][use.turned] == keyOfHexahedron(box);
        }))
    {
      return true;
    }
  }
  return false;
}

void expectSound(const Assembly& a)
{
  const WallMesh& wall = a.wall;
  ASSERT_EQ(wall.boxStart.size(), a.sides.polyhedral.size() + 1);
  ASSERT_EQ(wall.boxStart.back(), wall.size());
  std::vector<std::array<int, 2>> uses(wall.faces.size());
  for (std::uint32_t c = 0; c < wall.size(); ++c)
  {
    wall.forEachUse(c, [&](const FaceUse& use) {
      ++uses[use.face][use.turned];
      EXPECT_EQ(wall.faces.cells[use.face][use.turned], c);
    });
    Vector sum;
    const double box = volumeOfBox(a, wall.cells[c].box);
    EXPECT_NEAR(volumeOf(a, c, sum), wall.cells[c].volumeFraction * box, 1e-9 * box);
    EXPECT_LT(norm(sum), 1e-9 * std::pow(box, 2.0 / 3));
  }
  for (std::uint32_t f = 0; f < wall.faces.size(); ++f)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      const CellKey key = wall.faces.cells[f][k];
      EXPECT_EQ(uses[f][k], key < FirstHexahedron ? 1 : 0);
      if (isHexahedron(key))
      {
        EXPECT_EQ(a.sides.polyhedralOrdinal(boxOfHexahedron(key)), None);
        EXPECT_TRUE(hasFace(a, boxOfHexahedron(key), f));
      }
    }
  }
}

// What `change` does to the cells of one slab, written back.
template <class Change>
void shape(Assembly& a, Execution& execution, Change&& change)
{
  ShapedWall whole(a.boxes, a.patches, a.sides, a.nodes, a.wall, 45);
  const Layers all = a.boxes.allLayers();
  whole.measure(all, execution);
  std::vector<std::unique_ptr<CellComplex>> slabs;
  slabs.push_back(std::make_unique<CellComplex>(whole, Slab{ all, all, all, all }));
  change(*slabs.front());
  writeBack(whole, slabs, execution);
}

double volumeOf(const Assembly& a)
{
  double sum = 0;
  for (std::uint32_t c = 0; c < a.wall.size(); ++c)
  {
    Vector area;
    sum += a.wall.cells[c].removed ? 0 : volumeOf(a, c, area);
  }
  return sum;
}

std::uint32_t smallestOf(const Assembly& a)
{
  const auto begin = a.wall.cells.begin();
  return static_cast<std::uint32_t>(
    std::min_element(begin, begin + std::ptrdiff_t(a.wall.size()),
      [](const Cell& x, const Cell& y) { return x.volumeFraction < y.volumeFraction; }) -
    begin);
}

}

TEST(WallMesh, FacesAndCellsKnowEachOther)
{
  for (const int levels : { 0, 1 })
  {
    for (const Soup& soup : { octahedron(1).turned(), sphere(6, 1), cube().turned() })
    {
      Execution execution;
      expectSound(*assembled(soup, cellsAlongLongest(soup, 5), execution, levels));
    }
  }
}

TEST(WallMesh, HoldsTheFacesBetweenRegionsOnce)
{
  Execution execution;
  Soup soup;
  soup.addRegion(box({ 0, 0, 0 }, { 3, 3, 1.3 }));
  soup.addRegion(box({ 0, 0, 1.3 }, { 3, 3, 3 }));
  const auto a = assembled(soup, cellsOf(1), execution);
  expectSound(*a);
  double area = 0;
  const WallFaces& faces = a->wall.faces;
  for (std::uint32_t f = faces.firstInterface(); f < faces.firstShaped; ++f)
  {
    EXPECT_EQ(faces.originOf(f), FaceOrigin::Interface);
    EXPECT_TRUE(a->wall.isInterface(f));
    std::vector<Vector> ring;
    faces.forEachNode(
      { f, false }, [&](std::uint32_t node) { ring.push_back(minus(a->nodes.at[node], Point{})); });
    area += norm(measureFace(ring.size(), [&](std::size_t i) { return ring[i]; }).area);
  }
  const Box box = a->boxes.box(0);
  EXPECT_NEAR(
    area, 9 * double(box.high[0] - box.low[0]) * double(box.high[1] - box.low[1]), 1e-6 * area);
}

// Hexahedra that get a node on an edge become polyhedra.
TEST(WallMesh, StaysSoundWhenCellsAreCut)
{
  Execution execution;
  const Soup soup = bumpySphere(3, 8);
  const auto a = assembled(soup, cellsAlongLongest(soup, 6), execution);
  const std::size_t before = a->wall.size();
  const std::size_t boxes = a->sides.polyhedral.size();
  const double volume = volumeOf(*a);
  std::size_t cuts = 0;
  shape(*a, execution, [&](CellComplex& cells) {
    cuts = splitCells(cells, cells.polyhedraAtFault(), 0, execution).cellsSplit;
  });
  ASSERT_GT(cuts, 0U);
  expectSound(*a);
  const std::size_t opened = a->sides.polyhedral.size() - boxes;
  EXPECT_GE(a->wall.size(), before + cuts + opened); // a cut makes two parts or more
  EXPECT_NEAR(volumeOf(*a), volume + double(opened) * volumeOfBox(*a, 0), 1e-9 * volume);
  EXPECT_GT(a->wall.faces.size(), a->wall.faces.firstShaped);
}

// Beside hexahedra: they become polyhedra, whose volume is that of their boxes.
TEST(WallMesh, StaysSoundWhenCellsMergeAndGo)
{
  Execution execution;
  const Soup soup = sphere(6, 1);
  const auto a = assembled(soup, cellsAlongLongest(soup, 9), execution);
  const std::size_t before = a->wall.size();
  const double volume = volumeOf(*a);
  double gained = 0;
  shape(*a, execution, [&](CellComplex& cells) {
    const CellKey small = smallestOf(*a);
    const CellKey into = cells.neighbours(small).front().first;
    gained = isHexahedron(into) ? cells.volumeOfBox(into) : 0;
    cells.merge(small, into);
  });
  expectSound(*a);
  EXPECT_EQ(a->wall.size(), before - (gained > 0 ? 0 : 1));
  EXPECT_NEAR(volumeOf(*a), volume + gained, 1e-9 * volume);
  double lost = 0;
  shape(*a, execution, [&](CellComplex& cells) {
    const CellKey small = smallestOf(*a);
    lost = cells.volume(small);
    std::vector<RemovedCell> removed;
    remove(cells, small, removed);
  });
  expectSound(*a);
  EXPECT_GT(lost, 0);
}

}

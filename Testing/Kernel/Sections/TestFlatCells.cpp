// Meshes one cell across: volumes and areas by construction, closed cells, conforming sides.
#include "Quality/FaceCorners.h"
#include "Sections/FlatCells.h"
#include "Sections/SideMerging.h"
#include "Support/CellFacesOf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace cartesian;

namespace
{

struct Flat
{
  FacedCells mesh;
  SideFaces side;
  FlatCells cells;
};

std::vector<std::size_t> oppositesOf(const FacedCells& mesh)
{
  Execution execution;
  const FaceList list = listFaces(mesh.cells, mesh.points.size() / 3, Clashes::Refused, execution);
  std::vector<std::size_t> opposite(mesh.cells.faceCount(), NoFace);
  for (std::size_t i = 0; i < list.neighbour.size(); ++i)
  {
    const std::size_t beyond = faceBeyond(mesh.cells, list.face[i], list.neighbour[i]);
    opposite[list.face[i]] = beyond;
    opposite[beyond] = list.face[i];
  }
  return opposite;
}

Flat flatOf(const Soup& soup, double cellSize, const SweepSpec& spec, bool merges = false)
{
  Flat flat;
  flat.mesh = facedCells(meshOf(soup, cellsOf(cellSize)).mesh);
  flat.side = facesOfSide(flat.mesh.cells, flat.mesh.points, spec.across, oppositesOf(flat.mesh));
  if (merges)
  {
    mergeSkew(
      flat.mesh.points, [](std::uint32_t, std::uint32_t) { return true; },
      [](std::size_t) { return InnerEdge; }, flat.side);
  }
  flat.cells = sweep(flat.side, flat.mesh.points, spec);
  return flat;
}

double volumeOf(const Flat& flat)
{
  std::vector<FaceGeometry> faces;
  const FaceCorners corners(flat.cells.cells, flat.cells.points.data());
  double volume = 0;
  for (std::size_t cell = 0; cell < flat.cells.cells.cellCount(); ++cell)
  {
    const double own = corners.geometryOfCell(cell, faces).volume;
    EXPECT_GT(own, 0) << cell;
    volume += own;
  }
  return volume;
}

// Each edge of a cell is there once in each direction; each face is of two cells, in both directions, or of one.
void expectClosed(const Flat& flat)
{
  const CellFaces& cells = flat.cells.cells;
  std::map<std::vector<std::uint32_t>, int> uses; // of faces, by their sorted corners
  for (std::size_t cell = 0; cell < cells.cellCount(); ++cell)
  {
    std::map<std::array<std::uint32_t, 2>, int> edges;
    for (std::size_t f = cells.firstFace[cell]; f < cells.firstFace[cell + 1]; ++f)
    {
      const std::size_t first = cells.firstCorner[f];
      const std::size_t size = cells.firstCorner[f + 1] - first;
      for (std::size_t i = 0; i < size; ++i)
      {
        const std::uint32_t from = cells.corners[first + i];
        const std::uint32_t to = cells.corners[first + (i + 1) % size];
        ++edges[{ from, to }];
        --edges[{ to, from }];
      }
      std::vector<std::uint32_t> corners(cells.corners.begin() + std::ptrdiff_t(first),
        cells.corners.begin() + std::ptrdiff_t(first + size));
      std::sort(corners.begin(), corners.end());
      ++uses[corners];
    }
    EXPECT_TRUE(
      std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; }));
  }
  for (const auto& [corners, count] : uses)
  {
    EXPECT_LE(count, 2);
  }
}

SweepSpec planeOf(std::size_t across, double thickness)
{
  SweepSpec spec;
  spec.across = across;
  spec.thickness = thickness;
  return spec;
}

SweepSpec wedgeOf(double angle)
{
  SweepSpec spec;
  spec.isWedge = true;
  spec.angle = angle;
  return spec;
}

// A channel with a bend along z, of an area of 3.
Soup channel()
{
  return voxels({ std::vector<double>{ 0, 1, 2 }, { 0, 1, 2 }, { 0, 0.5 } },
    [](int i, int j, int) { return i == 0 || j == 0; });
}

}

TEST(FlatCells, PlaneAcrossEachAxis)
{
  for (const double size : { 0.31, 0.17, 0.09 })
  {
    for (std::size_t across = 0; across < 3; ++across)
    {
      const int axis = static_cast<int>(across);
      const Soup soup = channel().permuted({ (5 - axis) % 3, (6 - axis) % 3, (7 - axis) % 3 });
      const Flat flat = flatOf(soup, size, planeOf(across, 2));
      expectClosed(flat);
      EXPECT_NEAR(volumeOf(flat), 6, 1e-7);
    }
  }
}

TEST(FlatCells, WedgeWithAndWithoutAnAxis)
{
  for (const double size : { 0.31, 0.17, 0.09 })
  {
    for (const double angle : { 1., 5., 60. })
    {
      const double half = std::sin(radians(angle)) / 2;
      const Flat onAxis = flatOf(box({ 0, 0, 0 }, { 3, 2, 0.5 }), size, wedgeOf(angle));
      expectClosed(onAxis);
      EXPECT_NEAR(volumeOf(onAxis), half * 3 * 4, 1e-6);
      const Flat around = flatOf(box({ 0, 1, 0 }, { 3, 2, 0.5 }), size, wedgeOf(angle));
      expectClosed(around);
      EXPECT_NEAR(volumeOf(around), half * 3 * 3, 1e-6);
    }
  }
}

TEST(FlatCells, ThicknessIsTheMeanSideIfNoneIsGiven)
{
  const Flat flat = flatOf(box({ 0, 0, 0 }, { 1, 1, 0.5 }), 0.25, planeOf(2, 0));
  const double side = 1 / std::sqrt(static_cast<double>(flat.side.count()));
  EXPECT_NEAR(volumeOf(flat), side, 1e-8);
}

// Polygons that are united keep the area, and the border.
TEST(FlatCells, SkewPolygonsAreUnited)
{
  Flat flat = flatOf(channel().turned(2, 20), 0.13, planeOf(2, 1));
  const std::size_t before = flat.side.count();
  const Flat merged = flatOf(channel().turned(2, 20), 0.13, planeOf(2, 1), true);
  EXPECT_LE(merged.side.count(), before);
  expectClosed(merged);
  EXPECT_NEAR(volumeOf(merged), volumeOf(flat), 1e-9);
}

// Its third point is beside a short part of a nearly straight edge.
TEST(FlatCells, ASliverStaysATriangle)
{
  const std::vector<double> points{ 0, 0, 0, 1, 0, 0, 0.05, 1e-9, 0 };
  SideFaces side;
  addPolygon({ { 0, 2, NoFace }, { 2, 1, NoFace }, { 1, 0, NoFace } }, 0, side);
  mergeSkew(
    points, [](std::uint32_t, std::uint32_t) { return true; }, [](std::size_t) { return 0LL; },
    side);
  ASSERT_EQ(side.count(), 1U);
  EXPECT_EQ(side.size(0), 3U);
}

TEST(FlatCells, WhatIsWrongIsTold)
{
  const Soup soup = box({ 0, -1, 0 }, { 1, 1, 0.5 });
  EXPECT_THROW(flatOf(soup, 0.3, wedgeOf(5)), Error); // on both sides of the axis
  EXPECT_THROW(flatOf(soup, 0.3, wedgeOf(0)), Error);
  EXPECT_THROW(flatOf(soup, 0.3, wedgeOf(90)), Error);
  EXPECT_THROW(flatOf(soup, 0.3, planeOf(2, -1)), Error);
  SweepSpec across = wedgeOf(5);
  across.across = 0;
  EXPECT_THROW(flatOf(soup, 0.3, across), Error);
}

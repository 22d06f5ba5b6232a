// Faces of cells matched and put in order.

#include "Base/Error.h"
#include "Quality/FaceList.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

using namespace cartesian;

namespace
{

constexpr std::uint32_t N = 5; // cubes along each axis of a block

std::uint32_t point(std::uint32_t i, std::uint32_t j, std::uint32_t k)
{
  return i + (N + 1) * (j + (N + 1) * k);
}

void addFace(CellFaces& cells, const std::vector<std::uint32_t>& corners)
{
  cells.firstCorner.push_back(cells.corners.size());
  cells.corners.insert(cells.corners.end(), corners.begin(), corners.end());
}

// Faces outward: low and high x, y, z.
void addCube(CellFaces& cells, std::uint32_t cube)
{
  const std::uint32_t i = cube % N;
  const std::uint32_t j = cube / N % N;
  const std::uint32_t k = cube / (N * N);
  const auto at = [&](unsigned corner) {
    return point(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
  };
  cells.firstFace.push_back(cells.firstCorner.size());
  addFace(cells, { at(0), at(4), at(6), at(2) });
  addFace(cells, { at(1), at(3), at(7), at(5) });
  addFace(cells, { at(0), at(1), at(5), at(4) });
  addFace(cells, { at(2), at(6), at(7), at(3) });
  addFace(cells, { at(0), at(2), at(3), at(1) });
  addFace(cells, { at(4), at(5), at(7), at(6) });
}

CellFaces finished(CellFaces cells)
{
  cells.firstFace.push_back(cells.firstCorner.size());
  cells.firstCorner.push_back(cells.corners.size());
  return cells;
}

CellFaces cubes(const std::vector<std::uint32_t>& order)
{
  CellFaces cells;
  for (const std::uint32_t cube : order)
  {
    addCube(cells, cube);
  }
  return finished(cells);
}

std::vector<std::uint32_t> shuffledBlock()
{
  std::vector<std::uint32_t> order(N * N * N);
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  return order;
}

constexpr std::size_t Points = (N + 1) * (N + 1) * (N + 1);

FaceList list(const CellFaces& cells, int threads = 1, Clashes clashes = Clashes::Refused)
{
  Execution execution(threads);
  return listFaces(cells, Points, clashes, execution);
}

std::vector<double> positions()
{
  std::vector<double> xyz;
  for (std::uint32_t p = 0; p < Points; ++p)
  {
    xyz.push_back(p % (N + 1));
    xyz.push_back(p / (N + 1) % (N + 1));
    xyz.push_back(p / (N + 1) / (N + 1));
  }
  return xyz;
}

void expectRefused(const CellFaces& cells, const std::string& part)
{
  try
  {
    list(cells);
    ADD_FAILURE() << "not refused";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::BadMesh);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

}

TEST(FaceList, TwoCubesShareAFace)
{
  const FaceList faces = list(cubes({ 1, 0 }));
  EXPECT_EQ(faces.owner, (std::vector<std::uint32_t>{ 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1 }));
  EXPECT_EQ(faces.neighbour, (std::vector<std::uint32_t>{ 1 }));
  // The low x side of cube 1; the boundary in order of cells and their faces.
  EXPECT_EQ(faces.face, (std::vector<std::uint32_t>{ 0, 1, 2, 3, 4, 5, 6, 8, 9, 10, 11 }));
}

TEST(FaceList, IsInUpperTriangularOrder)
{
  const FaceList faces = list(cubes(shuffledBlock()));
  const std::size_t inner = faces.neighbour.size();
  EXPECT_EQ(inner, 3 * N * N * (N - 1));
  EXPECT_EQ(faces.face.size() - inner, 6 * N * N);
  for (std::size_t i = 0; i < inner; ++i)
  {
    EXPECT_LT(faces.owner[i], faces.neighbour[i]);
    EXPECT_EQ(faces.face[i] / 6, faces.owner[i]);
    if (i > 0)
    {
      EXPECT_LT(std::make_pair(faces.owner[i - 1], faces.neighbour[i - 1]),
        std::make_pair(faces.owner[i], faces.neighbour[i]));
    }
  }
  EXPECT_TRUE(
    std::is_sorted(faces.face.begin() + static_cast<std::ptrdiff_t>(inner), faces.face.end()));
}

TEST(FaceList, NeighboursAreThoseOfTheGrid)
{
  const std::vector<std::uint32_t> order = shuffledBlock();
  const FaceList faces = list(cubes(order));
  constexpr std::array<std::uint32_t, 3> Steps = { 1, N, N * N };
  for (std::size_t i = 0; i < faces.neighbour.size(); ++i)
  {
    const std::uint32_t side = faces.face[i] % 6;
    const std::uint32_t a = order[faces.owner[i]];
    const std::uint32_t b = order[faces.neighbour[i]];
    EXPECT_EQ(side % 2 == 1 ? a + Steps[side / 2] : a - Steps[side / 2], b);
  }
}

TEST(FaceList, DoesNotDependOnThreads)
{
  const CellFaces cells = cubes(shuffledBlock());
  const FaceList one = list(cells, 1);
  const FaceList three = list(cells, 3);
  EXPECT_EQ(one.face, three.face);
  EXPECT_EQ(one.owner, three.owner);
  EXPECT_EQ(one.neighbour, three.neighbour);
}

TEST(FaceList, FacesOfCommonEdgesAreNotTheSame)
{
  // Two squares that share the edges between three points in a row, 0, 1 and 2.
  CellFaces cells;
  cells.firstFace = { 0, 1 };
  addFace(cells, { 0, 1, 2, 14, 12 });
  addFace(cells, { 2, 1, 0, 72, 74 });
  EXPECT_EQ(list(finished(cells)).neighbour.size(), 0u);
}

TEST(FaceList, AWallInsideACellIsBoundaryOnBothSides)
{
  CellFaces cells;
  addCube(cells, 0);
  addFace(cells, { 20, 21, 27 });
  addFace(cells, { 27, 21, 20 });
  const FaceList faces = list(finished(cells));
  EXPECT_EQ(faces.neighbour.size(), 0u);
  EXPECT_EQ(faces.face.size(), 8u);
}

TEST(FaceList, OverlappingCellsAreRefused)
{
  expectRefused(cubes({ 0, 0 }), "Face 0 of cell 0");
  expectRefused(cubes({ 7, 0, 1, 1 }), "Face 1 of cell 1");
}

TEST(FaceList, OverlappingCellsCanBeBoundary)
{
  const FaceList faces = list(cubes({ 0, 1, 1 }), 1, Clashes::AreBoundary);
  EXPECT_EQ(faces.neighbour.size(), 0u);
  EXPECT_EQ(faces.face.size(), 18u);
}

TEST(FaceList, AFaceThatVisitsAPointTwiceIsShared)
{
  CellFaces cells;
  cells.firstFace = { 0, 1 };
  addFace(cells, { 0, 1, 2, 0, 3, 4 });
  addFace(cells, { 1, 0, 4, 3, 0, 2 });
  EXPECT_EQ(list(finished(cells)).neighbour.size(), 1u);
}

TEST(FaceList, CellsInsideOutAreTurned)
{
  CellFaces cells = cubes({ 0, 1 });
  const CellFaces right = cells;
  for (std::size_t f = 6; f < 12; ++f)
  {
    const auto corner = cells.corners.begin() + static_cast<std::ptrdiff_t>(4 * f);
    std::reverse(corner, corner + 4);
  }
  expectRefused(cells, "Face 1 of cell 0");
  Execution execution;
  turnOutward(cells, positions().data(), execution);
  EXPECT_EQ(cells.corners, right.corners);
}

TEST(FaceList, PatchesAreSortedAndKeepTheirOrder)
{
  FaceList faces = list(cubes({ 0, 1 }));
  const std::vector<std::size_t> counts = sortByPatch(faces, { 2, 0, 2, 0, 0, 2, 0, 2, 0, 0 }, 3);
  EXPECT_EQ(counts, (std::vector<std::size_t>{ 6, 0, 4 }));
  EXPECT_EQ(faces.face, (std::vector<std::uint32_t>{ 1, 2, 4, 5, 8, 10, 11, 0, 3, 7, 9 }));
  EXPECT_EQ(faces.owner, (std::vector<std::uint32_t>{ 0, 0, 0, 0, 1, 1, 1, 0, 0, 1, 1 }));
}

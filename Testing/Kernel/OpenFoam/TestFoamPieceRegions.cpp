// Cubes of random regions in random pieces: each region's pieces are parts of the mesh that it has as a whole.

#include "OpenFoam/FoamPieceRegions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

using namespace cartesian;

namespace
{

constexpr std::uint32_t Size = 4; // cubes along an edge
constexpr std::uint32_t Points = Size + 1;
constexpr std::uint32_t Cells = Size * Size * Size;
constexpr std::size_t Regions = 3;

// A mesh of some cubes, without patches, with the numbers of its points among those of all.
struct Cubes
{
  FoamMesh mesh;
  std::vector<std::int32_t> points;
  std::array<std::size_t, 2> ofBoundary{}; // faces: at x = 0, and on the other sides
};

std::array<std::uint32_t, 3> placeOf(std::uint32_t number, std::uint32_t size)
{
  return { number % size, number / size % size, number / (size * size) };
}

CellFaces facesOfCubes(std::uint32_t begin, std::uint32_t end)
{
  CellFaces cells{ { 0 }, { 0 }, {} };
  for (std::uint32_t cell = begin; cell < end; ++cell)
  {
    for (std::uint32_t side = 0; side < 6; ++side)
    {
      const std::uint32_t axis = side / 2;
      for (std::uint32_t corner = 0; corner < 4; ++corner)
      {
        std::array<std::uint32_t, 3> at = placeOf(cell, Size);
        const std::uint32_t turn = side % 2 == 1 ? corner : 3 - corner;
        at[axis] += side % 2;
        at[(axis + 1) % 3] += turn == 1 || turn == 2 ? 1 : 0;
        at[(axis + 2) % 3] += turn / 2;
        cells.corners.push_back(at[0] + Points * (at[1] + Points * at[2]));
      }
      cells.firstCorner.push_back(cells.corners.size());
    }
    cells.firstFace.push_back(cells.firstCorner.size() - 1);
  }
  return cells;
}

// Points that no cube has are left out.
std::vector<std::int32_t> numberPoints(CellFaces& cells)
{
  std::vector<std::int32_t> points(cells.corners.begin(), cells.corners.end());
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (std::uint32_t& corner : cells.corners)
  {
    const auto place =
      std::lower_bound(points.begin(), points.end(), static_cast<std::int32_t>(corner));
    corner = static_cast<std::uint32_t>(place - points.begin());
  }
  return points;
}

Cubes cubes(std::uint32_t begin, std::uint32_t end)
{
  Cubes result;
  Execution execution(1);
  CellFaces cells = facesOfCubes(begin, end);
  result.points = numberPoints(cells);
  std::vector<double> coordinates;
  for (const std::int32_t point : result.points)
  {
    const auto at = placeOf(static_cast<std::uint32_t>(point), Points);
    coordinates.insert(coordinates.end(), at.begin(), at.end());
  }
  FaceList list = listFaces(cells, result.points.size(), Clashes::Refused, execution);
  std::vector<std::uint32_t> patch; // 2: of another piece
  for (std::size_t i = list.neighbour.size(); i < list.face.size(); ++i)
  {
    const std::uint32_t side = list.face[i] % 6;
    const std::uint32_t place = placeOf(begin + list.owner[i], Size)[side / 2];
    const bool isOuter = place == (side % 2 == 0 ? 0 : Size - 1);
    patch.push_back(!isOuter ? 2 : side == 0 ? 0 : 1);
  }
  const std::vector<std::size_t> counts = sortByPatch(list, patch, 3);
  std::copy_n(counts.begin(), 2, result.ofBoundary.begin());
  result.mesh = foamMesh(std::move(coordinates), cells, std::move(list), {}, execution);
  return result;
}

FoamRegions regionsOf(const std::vector<std::uint32_t>& ofAll, std::size_t begin, std::size_t end)
{
  const auto first = ofAll.begin();
  return { { "a", "b", "c" },
    { first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end) } };
}

std::vector<CompletePiece> piecesOf(
  const std::vector<std::uint32_t>& starts, const std::vector<std::uint32_t>& regions)
{
  std::vector<FoamPiece> pieces;
  std::vector<FoamOutline> outlines;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i)
  {
    Cubes made = cubes(starts[i], starts[i + 1]);
    FoamPiece piece{ std::move(made.mesh), std::move(made.points), starts[i], {},
      regionsOf(regions, starts[i], starts[i + 1]) };
    for (const std::int32_t boundary : { 0, 1 })
    {
      if (made.ofBoundary[boundary] > 0)
      {
        piece.boundaries.emplace_back(boundary, made.ofBoundary[boundary]);
      }
    }
    outlines.push_back(FoamOutline::fromNumbers(outlineOf(piece).toNumbers()));
    pieces.push_back(std::move(piece));
  }
  const std::vector<FaceNumbers> numbers = numberFaces(outlines);
  std::vector<CompletePiece> result;
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    const auto& ofBoundaries = numbers[i].boundaries;
    result.push_back(completed(std::move(pieces[i]), i, numbers[i],
      { { "inlet", ofBoundaries[0].count }, { "wall", ofBoundaries[1].count } }));
  }
  return result;
}

using Face = std::vector<std::uint32_t>; // corners

Face faceOf(const FoamMesh& mesh, std::size_t face)
{
  return { mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.start[face]),
    mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.start[face + 1]) };
}

// Corners are where the addressing says, owners too; patches have their faces in the order of the whole.
void expectPart(const FoamMesh& piece, const FoamMesh& whole)
{
  const FoamAddressing& addressing = *piece.addressing;
  ASSERT_EQ(addressing.cells.size(), piece.cellCount);
  ASSERT_EQ(addressing.points.size() * 3, piece.points.size());
  ASSERT_EQ(addressing.faces.size(), piece.owner.size());
  for (std::size_t i = 0; i < piece.points.size(); ++i)
  {
    const auto point = static_cast<std::size_t>(addressing.points[i / 3]);
    ASSERT_EQ(piece.points[i], whole.points[3 * point + i % 3]);
  }
  for (std::size_t i = 0; i < piece.owner.size(); ++i)
  {
    const bool isTurned = addressing.faces[i] < 0;
    const auto number = static_cast<std::size_t>(std::abs(addressing.faces[i])) - 1;
    ASSERT_LT(number, whole.owner.size());
    const auto own = static_cast<std::uint32_t>(addressing.cells[piece.owner[i]]);
    EXPECT_EQ(own, isTurned ? whole.neighbour[number] : whole.owner[number]);
    if (i < piece.neighbour.size())
    {
      const auto other = static_cast<std::uint32_t>(addressing.cells[piece.neighbour[i]]);
      EXPECT_EQ(other, whole.neighbour[number]);
    }
    Face mine = faceOf(piece, i);
    std::for_each(mine.begin(), mine.end(), [&](std::uint32_t& corner) {
      corner = static_cast<std::uint32_t>(addressing.points[corner]);
    });
    Face theirs = faceOf(whole, number);
    if (isTurned)
    {
      std::reverse(theirs.begin() + 1, theirs.end());
    }
    EXPECT_EQ(mine, theirs);
  }
}

// Patches are those of the whole; how many faces each has in all pieces.
std::map<std::string, std::size_t> countsOf(const FoamMesh& piece, const FoamMesh& whole)
{
  std::map<std::string, std::size_t> counts;
  std::size_t face = piece.neighbour.size();
  for (std::size_t i = 0; i < piece.patches.size(); ++i)
  {
    const FoamPatch& patch = piece.patches[i];
    const bool isShared = patch.processes.other >= 0;
    EXPECT_EQ(piece.addressing->patches[i], isShared ? -1 : static_cast<int>(i));
    const std::size_t count = patch.count;
    if (!isShared)
    {
      EXPECT_EQ(patch.name, whole.patches.at(i).name);
      EXPECT_EQ(patch.sample.patch, whole.patches.at(i).sample.patch);
      counts[patch.name] += count;
    }
    const auto labels = piece.addressing->faces.begin() + static_cast<std::ptrdiff_t>(face);
    EXPECT_TRUE(std::is_sorted(labels, labels + static_cast<std::ptrdiff_t>(count),
      [](std::int32_t a, std::int32_t b) { return std::abs(a) < std::abs(b); }));
    face += count;
  }
  EXPECT_EQ(face, piece.owner.size());
  return counts;
}

void expectWhole(const std::vector<CompletePiece>& pieces, std::uint32_t region,
  const RegionLabels& labels, const FoamMesh& whole)
{
  std::map<std::string, std::size_t> counts;
  std::size_t cells = 0;
  for (const CompletePiece& piece : pieces)
  {
    const FoamMesh part = pieceOfRegion(piece, region, labels);
    expectPart(part, whole);
    cells += part.cellCount;
    for (const auto& [name, count] : countsOf(part, whole))
    {
      counts[name] += count;
    }
  }
  EXPECT_EQ(cells, whole.cellCount);
  EXPECT_EQ(counts.size(), whole.patches.size());
  for (const FoamPatch& patch : whole.patches)
  {
    EXPECT_EQ(counts[patch.name], patch.count);
  }
}

// Taken to numbers and back, as between processes.
std::vector<RegionLabels> labelsOfAll(const std::vector<CompletePiece>& pieces)
{
  std::vector<RegionLabels> labels(Regions);
  for (const CompletePiece& piece : pieces)
  {
    const auto ofPiece = regionLabels(toNumbers(labelsOfRegions(piece)));
    for (std::size_t i = 0; i < labels.size(); ++i)
    {
      labels[i].add(ofPiece.at(i));
    }
  }
  return labels;
}

// Faces between pieces that are between regions too.
std::size_t countSharedInterfaces(const std::vector<CompletePiece>& pieces)
{
  std::size_t count = 0;
  for (const CompletePiece& piece : pieces)
  {
    const std::vector<std::uint32_t>& owner = piece.mesh.owner;
    const std::vector<std::uint32_t>& beyond = piece.regions.beyond;
    for (std::size_t i = 0; i < beyond.size(); ++i)
    {
      const std::uint32_t cell = owner[owner.size() - beyond.size() + i];
      count += piece.regions.ofCell[cell] != beyond[i] ? 1 : 0;
    }
  }
  return count;
}

}

TEST(FoamPieceRegions, ArePartsOfTheRegionsMeshes)
{
  std::mt19937 random(1);
  std::size_t sharedInterfaces = 0;
  for (int round = 0; round < 20; ++round)
  {
    std::vector<std::uint32_t> regions(Cells);
    std::generate(
      regions.begin(), regions.end(), [&] { return random() % (round < 2 ? 2 : Regions); });
    const auto middle = static_cast<std::uint32_t>(2 + random() % (Cells - 3));
    const std::vector<std::uint32_t> starts{ 0, 1, middle, Cells };
    const std::vector<CompletePiece> pieces = piecesOf(starts, regions);
    const std::vector<RegionLabels> labels = labelsOfAll(pieces);
    sharedInterfaces += countSharedInterfaces(pieces);
    Cubes all = cubes(0, Cells);
    all.mesh.patches = { { "inlet", all.ofBoundary[0] }, { "wall", all.ofBoundary[1] } };
    const FoamRegions ofAll = regionsOf(regions, 0, Cells);
    for (std::uint32_t region = 0; region < Regions; ++region)
    {
      const FoamMesh whole = meshOfRegion(all.mesh, ofAll, separateMeshes(ofAll), region);
      expectWhole(pieces, region, labels[region], whole);
    }
  }
  EXPECT_GT(sharedInterfaces, 100U);
}

TEST(LabelRuns, CountWhatIsBelow)
{
  LabelRuns runs({ 7, 3, 4, 4, 9 });
  runs.add(LabelRuns({ 5, 6, 12 }));
  EXPECT_EQ(runs.size(), 7U);
  const std::vector<std::size_t> expected{ 0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 6, 6, 6, 7 };
  for (std::size_t label = 0; label < expected.size(); ++label)
  {
    EXPECT_EQ(runs.countBelow(static_cast<std::int32_t>(label)), expected[label]) << label;
  }
  EXPECT_EQ(LabelRuns().size(), 0U);
}

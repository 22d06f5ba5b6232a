// The steps of shaping, each by itself, on meshes of a few cells.
#include "Acceptance/CellCost.h"
#include "Mesher/Assembly.h"
#include "Shaping/CellCession.h"
#include "Shaping/CellSplitting.h"
#include "Shaping/CutSearch.h"
#include "Shaping/InvalidCells.h"
#include "Shaping/PartTransfer.h"
#include "Shaping/RefusedCells.h"
#include "Shaping/TipRemoval.h"
#include "Shaping/WallJoining.h"
#include "Support/CellShapes.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cartesian
{

namespace
{

// A mesh as cutting leaves it; one slab sees and changes all of it.
class FewCells
{
public:
  FewCells(const Soup& soup, const GridSpec& grid, const PatchSpec& patches = exactFit())
  {
    TestOptions options = asTheyAre();
    options.patches = patches;
    a_ = assembledOf(soup, grid, options, execution);
    whole_ =
      std::make_unique<ShapedWall>(a_->boxes, a_->patches, a_->sides, a_->nodes, a_->wall, 45);
    const Layers all = a_->boxes.allLayers();
    whole_->measure(all, execution);
    complex_ = std::make_unique<CellComplex>(*whole_, Slab{ all, all, all, all });
  }

  CellComplex& operator*() { return *complex_; }
  CellComplex* operator->() { return complex_.get(); }

  std::vector<CellKey> keys() const { return complex_->polyhedra(); }

  // The one cell that is so.
  template <class Is>
  CellKey find(Is&& is) const
  {
    const std::vector<CellKey> all = keys();
    EXPECT_EQ(std::count_if(all.begin(), all.end(), is), 1);
    return *std::find_if(all.begin(), all.end(), is);
  }

  double volume() const
  {
    double sum = 0;
    for (const CellKey key : keys())
    {
      sum += complex_->volume(key);
    }
    return sum;
  }

  Verdict verdict(CellKey key) const
  {
    MeasuredCell cell;
    return verdictOf(*complex_, key, cell);
  }

  Execution execution;

private:
  std::unique_ptr<Assembly> a_;
  std::unique_ptr<ShapedWall> whole_;
  std::unique_ptr<CellComplex> complex_;
};

// Boxes of edge 1 from 0 to 4, filled up to `heights` along z.
GridSpec unitGrid()
{
  GridSpec grid = cellsOf(1);
  const std::vector<double> lines{ 0, 1, 2, 3, 4 };
  grid.meshlines = { lines, lines, lines };
  return grid;
}

constexpr double Slice = 0.005; // of a box

// 2 x 1 x 1 boxes filled, and a slice of each box above.
FewCells sliced()
{
  return { box({ 0, 0, 0 }, { 2, 1, 1 + Slice }), unitGrid() };
}

bool isSlice(const FewCells&, double share)
{
  return share < 2 * Slice;
}

// An L in one box; its arms are so thick.
FewCells ell(double arm)
{
  const std::vector<double> lines{ 0, arm, 1 };
  return { voxels({ lines, lines, { 0, 1 } }, [](int i, int j, int) { return i == 0 || j == 0; }),
    unitGrid() };
}

// Along y from 0 to 1, over a convex polygon in x and z, clockwise.
Soup extruded(const std::vector<std::array<double, 2>>& polygon)
{
  Soup soup;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (std::uint32_t i = 0; i < n; ++i)
  {
    const auto& [x, z] = polygon[i];
    const std::uint32_t next = (i + 1) % n;
    soup.points.push_back({ x, 0, z });
    soup.points.push_back({ x, 1, z });
    soup.triangles.push_back({ 2 * i, 2 * i + 1, 2 * next });
    soup.triangles.push_back({ 2 * next, 2 * i + 1, 2 * next + 1 });
    if (i > 0 && next > 0)
    {
      soup.triangles.push_back({ 0, 2 * i, 2 * next });
      soup.triangles.push_back({ 1, 2 * next + 1, 2 * i + 1 });
    }
  }
  return soup.volume() < 0 ? soup.flipped() : soup;
}

std::vector<CellKey> slicesOf(FewCells& cells)
{
  std::vector<CellKey> slices = cells.keys();
  slices.erase(std::remove_if(slices.begin(), slices.end(),
                 [&](CellKey key) { return !isSlice(cells, cells->share(key)); }),
    slices.end());
  return slices;
}

MergeSpec merging()
{
  MergeSpec spec;
  spec.ratio = 0.3;
  spec.joins = { std::cos(radians(3)), std::cos(radians(20)) };
  return spec;
}

}

TEST(ShapingSteps, SmallCellsMerge)
{
  FewCells cells = sliced();
  const double before = cells.volume();
  ASSERT_EQ(slicesOf(cells).size(), 2U);
  EXPECT_GT(cells.verdict(slicesOf(cells).front()).worst, PoorCost);
  const MergeSpec spec = merging();
  CellMerger merger(*cells, spec, cells.execution);
  merger.mergeSmall();
  EXPECT_EQ(merger.merged(), 2U);
  EXPECT_TRUE(slicesOf(cells).empty());
  EXPECT_NEAR(cells.volume(), before, 1e-9 * before);
}

TEST(ShapingSteps, AnEllIsSplit)
{
  FewCells cells = ell(0.3);
  ASSERT_EQ(cells->polyhedraAtFault().size(), 1U);
  EXPECT_GT(cells.verdict(cells.keys().front()).refused, 0U);
  const double before = cells.volume();
  EXPECT_EQ(splitCells(*cells, cells->polyhedraAtFault(), 0, cells.execution).cellsSplit, 1U);
  EXPECT_EQ(cells.keys().size(), 2U);
  EXPECT_TRUE(cells->polyhedraAtFault().empty());
  EXPECT_NEAR(cells.volume(), before, 1e-9 * before);
}

TEST(ShapingSteps, NoPartIsSmallerThanAsked)
{
  FewCells cells = ell(0.3);
  EXPECT_EQ(splitCells(*cells, cells->polyhedraAtFault(), 0.3, cells.execution).cellsSplit, 0U);
  EXPECT_EQ(cells.keys().size(), 1U);
}

TEST(ShapingSteps, WhatIsTurnedOverIsCutUntilItIsValid)
{
  FewCells cells = ell(0.1);
  EXPECT_GT(cells.verdict(cells.keys().front()).invalid, 0U);
  EXPECT_GT(splitInvalid(*cells, cells.keys(), cells.execution), 0U);
  for (const CellKey key : cells.keys())
  {
    EXPECT_EQ(cells.verdict(key).invalid, 0U);
  }
}

// Where solvers accept both parts, neither has to go to another cell.
TEST(ShapingSteps, PartsThatAreFairStayApart)
{
  FewCells cells = ell(0.1);
  const double before = cells.volume();
  const MergeSpec spec = merging();
  CellMerger merger(*cells, spec, cells.execution);
  std::vector<RemovedCell> removed;
  transferParts(*cells, cells.keys(), LeftOver::ComesBack, merger, cells.execution, removed);
  EXPECT_TRUE(removed.empty());
  EXPECT_TRUE(merger.refused(true).empty());
  EXPECT_EQ(cells.keys().size(), 2U);
  EXPECT_NEAR(cells.volume(), before, 1e-9 * before);
}

TEST(ShapingSteps, WhatIsRefusedIsRemovedIfItIsSmall)
{
  FewCells cells = ell(0.1);
  std::vector<RemovedCell> removed;
  removeRefused(*cells, cells.keys(), {}, 0.18, cells.execution, removed); // it has 0.19 of its box
  EXPECT_TRUE(removed.empty());
  removeRefused(*cells, cells.keys(), {}, 0.2, cells.execution, removed);
  EXPECT_EQ(removed.size(), 1U);
  EXPECT_TRUE(cells.keys().empty());
}

// A roof that is bent at a tenth of its length by about as many degrees: no layers fit on the narrow part.
TEST(ShapingSteps, ANarrowFaceJoinsTheOneBesideItWhereLayersWillStand)
{
  for (const double slope : { 0.2, 1.0 })
  {
    FewCells cells(
      extruded({ { 0, 0 }, { 0, 0.8 - 0.1 * slope }, { 0.1, 0.8 }, { 1, 0.8 }, { 1, 0 } }),
      unitGrid(), PatchSpec{});
    const CellKey key = cells.keys().front();
    ASSERT_EQ(cells.verdict(key).faces, 7U);
    WallLayerSpec layers;
    layers.boundaries = { { 0, 0 } }; // none
    joinWalls(*cells, { key }, layers, cells.execution);
    EXPECT_EQ(cells.verdict(key).faces, 7U);
    layers.boundaries.clear();
    joinWalls(*cells, { key }, layers, cells.execution);
    EXPECT_EQ(cells.verdict(key).faces, slope < 0.5 ? 6U : 7U) << slope;
  }
}

TEST(ShapingSteps, CellsSideBySideAreOneGroup)
{
  FewCells cells = sliced();
  const std::vector<CellKey> slices = slicesOf(cells);
  ASSERT_EQ(slices.size(), 2U);
  EXPECT_EQ(sideBySide(*cells, { { slices[0], 0 }, { slices[1], 0 } }),
    std::vector<std::vector<CellKey>>{ slices });
  EXPECT_EQ(sideBySide(*cells, { { slices[0], 0 }, { slices[1], 1 } }),
    (std::vector<std::vector<CellKey>>{ { slices[0] }, { slices[1] } }));
}

TEST(ShapingSteps, TipsGoAndWhatIsBelowClosesThem)
{
  FewCells cells = sliced();
  const std::vector<CellKey> slices = slicesOf(cells);
  removeTips(*cells, slices, {}, 0.05, { 1, 1 });
  EXPECT_TRUE(slicesOf(cells).empty());
  for (const CellKey key : slices)
  {
    EXPECT_FALSE(cells->isAlive(key));
  }
}

TEST(ShapingSteps, TipsStayThatAreTooLarge)
{
  FewCells cells = sliced();
  removeTips(*cells, slicesOf(cells), {}, Slice / 4, { 1, 1 });
  EXPECT_EQ(slicesOf(cells).size(), 2U);
}

TEST(ShapingSteps, ACellGoesWithItsWallOnly)
{
  FewCells cells = sliced();
  for (const CellKey key : slicesOf(cells))
  {
    EXPECT_TRUE(sparesOthers(*cells, key));
  }
  // The cells below would leave five walls.
  for (const CellKey key : cells.keys())
  {
    EXPECT_EQ(keepsWall(*cells, key), isSlice(cells, cells->share(key)));
  }
  std::vector<RemovedCell> removed;
  const double volume = cells->volume(slicesOf(cells).front());
  remove(*cells, slicesOf(cells).front(), removed);
  ASSERT_EQ(removed.size(), 1U);
  EXPECT_EQ(removed.front().volume, volume);
  EXPECT_EQ(slicesOf(cells).size(), 1U);
}

// The wall between two regions lies a bit beside a plane of the grid. Only the slice in the middle has no other wall.
TEST(ShapingSteps, ASliceBetweenRegionsGoesToTheOther)
{
  Soup soup;
  soup.addRegion(box({ 0, 0, 0 }, { 3, 3, 1 + Slice }));
  soup.addRegion(box({ 0, 0, 1 + Slice }, { 3, 3, 3 }));
  FewCells cells(soup, unitGrid());
  ASSERT_EQ(slicesOf(cells).size(), 9U);
  const double before = cells.volume();
  const MergeSpec spec = merging();
  CellMerger merger(*cells, spec, cells.execution);
  EXPECT_FALSE(cedeCells(*cells, cells.keys(), Slice / 2, merger, cells.execution));
  EXPECT_TRUE(cedeCells(*cells, cells.keys(), 0.1, merger, cells.execution));
  EXPECT_EQ(slicesOf(cells).size(), 8U);
  EXPECT_NEAR(cells.volume(), before, 1e-9 * before);
}

TEST(CutParts, KnowWhatACutMakesOfACell)
{
  // Two boxes of 100 and 300 by 100 by 100, cut apart.
  const Polyhedron cell = boxOf(400, 100, 100, true);
  CellView view;
  view.shape = cell;
  view.beyond.resize(cell.faces());
  CellCut cut;
  ASSERT_TRUE(cutCell(cell, { { 100, 0, 0 }, { 1, 0, 0 }, {} }, cut));
  CellShape shape;
  measure(cell, shape);
  CutParts parts(view, shape);
  EXPECT_TRUE(parts.make(cut, 0));
  ASSERT_EQ(parts.parts.size(), 2U);
  EXPECT_NEAR(parts.smallest, 1e6, 1e-3);
  EXPECT_NEAR(parts.shapes[0].volume + parts.shapes[1].volume, 4e6, 1e-3);
  EXPECT_NEAR(parts.largestAspect(), 14e4 / (6 * std::pow(3e6, 2.0 / 3)), 1e-9);
  EXPECT_EQ(parts.faults().weight(), 0);
  EXPECT_EQ(parts.faultsAlone(0).weight(), 0);
  EXPECT_FALSE(parts.make(cut, 2e6));
}

}

// What the mesh lacks is known, and told where it is more than a thousandth of the volume.
#include "Mesher/CellsLeftOut.h"
#include "Mesher/Messages.h"
#include "Mesher/Statistics.h"
#include "Support/MeshChecker.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

namespace cartesian
{
namespace
{

class CellsLeftOut : public ::testing::TestWithParam<NamedShape>
{
};
INSTANTIATE_TEST_SUITE_P(Of, CellsLeftOut, ::testing::ValuesIn(cleanShapes()), nameOf);

// Calls visit(assembly) for meshes of some sizes.
template <class Visit>
void forEachMesh(const Soup& soup, Visit&& visit)
{
  Options options;
  Execution execution;
  for (const double boxes : { 3.3, 5.0, 8.0 })
  {
    SCOPED_TRACE(boxes);
    options.grid = cellsAlongLongest(soup, boxes);
    const auto assembly = mesh(soup.view(), options, execution);
    visit(*assembly, arraysOf(*assembly->mesh, assembly->boxes, execution));
  }
}

TEST_P(CellsLeftOut, AreToldWhereTheyMatter)
{
  forEachMesh(GetParam().soup, [](const Assembly& assembly, const MeshArrays& arrays) {
    const double left = volumeLeftOut(assembly);
    const double share = shareLeftOut(assembly);
    const double volume = volumeOf(arrays);
    EXPECT_NEAR(share * (volume + left), left, 1e-6 * volume);
    EXPECT_EQ(left == 0, cellsLeftOut(assembly).empty());
    EXPECT_EQ(describeFlaws(assembly).find("% of the volume") != std::string::npos, share > 1e-3);
  });
}

// In one line, from a tenth of a box on.
TEST(CellsLeftOut, AtRimsAreToldInALine)
{
  Options options;
  options.grid.meshlines = { std::vector<double>{ 0, 1, 2, 3, 4 }, std::vector<double>{ 0, 1, 2 },
    std::vector<double>{ 0, 1, 2 } };
  Execution execution;
  const auto assembly = mesh(box({ 0.5, 0.5, 0.5 }, { 3.5, 1.5, 1.5 }).view(), options, execution);
  std::vector<RemovedCell>& removed = assembly->edits.removed;
  removed.clear();
  const auto boxAt = [&](const Point& corner) {
    std::uint32_t b = 0;
    while (assembly->boxes.box(b).low != corner)
    {
      ++b;
    }
    return b;
  };
  const Box first = assembly->boxes.box(0);
  const Level width = first.high[0] - first.low[0];
  const std::uint32_t other =
    boxAt({ first.low[0] + 2 * width, first.low[1] + width, first.low[2] });
  const double volume = double(width) * double(width) * double(width);
  removed.push_back({ 0, 0.04 * volume, RemovalReason::Rim });
  removed.push_back({ 0, 0.5 * volume, RemovalReason::Small });
  EXPECT_EQ(describeFlaws(*assembly), "");
  EXPECT_EQ(statisticsOf(*assembly).at("RefusedCellsRemoved"), 1);
  removed.push_back({ other, 0.26 * volume, RemovalReason::Rim });
  EXPECT_EQ(statisticsOf(*assembly).at("RefusedCellsRemoved"), 2);
  EXPECT_EQ(describeFlaws(*assembly),
    "At rims of fins and sheets 2 pieces of cells were left out, 0.3 boxes in all (the largest at "
    "(2.5, 1.5, 0.5)): solvers would reject them. Where the shape of these rims matters, use a "
    "smaller Cell Size or a larger Refinement Depth.");
}

}
}

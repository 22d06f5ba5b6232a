// Every number that users get has a name of its own and a meaning, and they fit together.
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

using namespace cartesian;

TEST(Statistics, FitTogether)
{
  const Soup soup = blockWithTubes().turned();
  Options options;
  options.grid = cellsAlongLongest(soup, 15);
  Execution execution;
  const auto assembly = mesh(soup.view(), options, execution);
  std::map<std::string, double> values;
  for (const Statistic& statistic : statistics(*assembly))
  {
    EXPECT_TRUE(values.emplace(statistic.name, statistic.value).second) << statistic.name;
    EXPECT_GT(std::string(statistic.meaning).size(), 10U) << statistic.name;
    EXPECT_GE(statistic.value, 0) << statistic.name;
  }
  EXPECT_EQ(values.at("Cells"), static_cast<double>(assembly->mesh->cellCount()));
  EXPECT_EQ(values.at("Cells"), values.at("Hexahedra") + values.at("Polyhedra"));
  EXPECT_EQ(values.at("BoxesInside") + values.at("BoxesIntersected"),
    static_cast<double>(assembly->boxes.packed.size()));
  EXPECT_EQ(values.at("BoxesByMarchingCubes") + values.at("BoxesByExactFit"),
    values.at("BoxesIntersected"));
}

// What edits remove is small, or failed: where a sphere is barely larger than boxes, and of thin teeth that are cut askew.
TEST(Statistics, CellsLeftOutAreCountedByTheReason)
{
  std::map<RemovalReason, double> all;
  for (const NamedShape& shape : cleanShapes())
  {
    if (shape.name != "CombTurned" && shape.name != "TinyAndFarAway")
    {
      continue;
    }
    for (const double cells : { 6.0, 12.0 })
    {
      TestOptions options;
      options.grid = cellsAlongLongest(shape.soup, cells);
      Execution execution;
      const auto assembly = mesh(shape.soup.view(), options, execution);
      std::map<RemovalReason, double> counts;
      for (const auto* list :
        { &assembly->edits.removed, &assembly->edits.overlapping, &assembly->separate.fragments })
      {
        for (const RemovedCell& cell : *list)
        {
          ++counts[cell.reason];
          ++all[cell.reason];
        }
      }
      const std::map<std::string, double> values = statisticsOf(*assembly);
      EXPECT_EQ(values.at("RefusedCellsRemoved"),
        counts[RemovalReason::Refused] + counts[RemovalReason::Rim]);
      EXPECT_EQ(values.at("FragmentCellsRemoved"), counts[RemovalReason::Fragment]);
      EXPECT_GE(values.at("SmallCellsRemoved"), counts[RemovalReason::Small]);
    }
  }
  EXPECT_GT(all[RemovalReason::Small], 0);
  EXPECT_GT(all[RemovalReason::Refused], 0);
}

TEST(Statistics, AMeshInOneCallIsThatOfTheStages)
{
  const Soup soup = sphere(12, 1);
  TestOptions options;
  options.grid = cellsAlongLongest(soup, 9);
  Execution execution;
  const auto assembly = mesh(soup.view(), options, execution);
  EXPECT_TRUE(arraysOf(*assembly->mesh, assembly->boxes, execution) ==
    meshOf(soup, options.grid, options).mesh);
}

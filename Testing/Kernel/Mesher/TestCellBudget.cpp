// Cell Budget: sizes that find themselves are relaxed until the cells fit.
#include "Mesher/CellBudget.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

namespace cartesian
{
namespace
{

TestOptions asking(double cellSize, const SizingSpec& sizing)
{
  TestOptions options;
  options.grid = cellsOf(cellSize);
  options.refinement.sizing = sizing;
  return options;
}

std::unique_ptr<Assembly> meshOf(const Soup& soup, const TestOptions& options, int threads = 1)
{
  Execution execution(threads);
  const PreparedSurface prepared = prepareSurface(soup.view(), options, execution);
  const auto decomposition = decompose(prepared, options, execution);
  return meshWithinBudget(prepared, *decomposition, options, execution);
}

// What asks for sizes, and how many cells it gets with the budget.
void expectWithin(const Soup& soup, TestOptions options, const std::vector<double>& budgets)
{
  options.cellBudget = 1e9;
  const std::unique_ptr<Assembly> all = meshOf(soup, options);
  EXPECT_EQ(all->relaxation, 1);
  EXPECT_EQ(describeBudget(*all, options), "");
  for (const double budget : budgets)
  {
    ASSERT_LT(budget, 0.9 * static_cast<double>(all->mesh->cellCount()));
    options.cellBudget = budget;
    const std::unique_ptr<Assembly> fitted = meshOf(soup, options);
    EXPECT_NEAR(static_cast<double>(fitted->mesh->cellCount()), budget, BudgetTolerance * budget);
    EXPECT_GT(fitted->relaxation, 1);
    EXPECT_NE(describeBudget(*fitted, options).find("multiplied by"), std::string::npos);
  }
}

TEST(CellBudget, CurvatureIsRelaxed)
{
  SizingSpec sizing;
  sizing.curvatureAngle = 14;
  Soup soup = torus(24, 1, 0.3).turned();
  soup.add(sphere(8, 0.4).turned());
  expectWithin(soup, asking(0.3, sizing), { 3000, 1500 });
}

TEST(CellBudget, GapsAndSizesAreRelaxed)
{
  SizingSpec sizing;
  sizing.cellsAcrossGaps = 9;
  sizing.largestDepth = 4;
  for (int i = 0; i < 10; ++i)
  {
    for (int j = 0; j < 10; ++j)
    {
      sizing.sizes.push_back(
        { { 0.3 * i, 0.1 * j, 0 }, { 0.3 * (i + 1), 0.1 * (j + 1), 1 }, 0.02 * (2 + i + 0.3 * j) });
    }
  }
  const Soup wedge = box({ 0, 0, 0 }, { 3, 1, 1 }).each([](const Vector& p) {
    return Vector{ p[0], p[1], p[2] * (0.3 + 0.2 * p[0]) };
  });
  expectWithin(wedge, asking(0.3, sizing), { 9000, 4000 });
}

TEST(CellBudget, RefinementForLayersIsRelaxed)
{
  const Soup soup = torus(24, 1, 0.3).turned();
  TestOptions options = asking(0.25, {});
  options.layers.count = 3;
  options.layers.firstThickness = 1e-3;
  const auto cellsOf = [&](double budget) {
    options.cellBudget = budget;
    const std::unique_ptr<Assembly> made = meshOf(soup, options);
    return static_cast<double>(made->mesh->cellCount()) +
      static_cast<double>(made->layers->stacks.cells());
  };
  const double all = cellsOf(1e9);
  options.layers.refine = false;
  const double without = cellsOf(1e9);
  options.layers.refine = true;
  ASSERT_GT(all, 1.5 * without);
  const double budget = (all + without) / 2;
  EXPECT_LE(cellsOf(budget), (1 + BudgetTolerance) * budget);
}

TEST(CellBudget, WhatIsNotRelaxedIsTold)
{
  SizingSpec sizing;
  sizing.curvatureAngle = 20;
  TestOptions options = asking(0.1, sizing);
  options.cellBudget = 1000;
  const std::unique_ptr<Assembly> fitted = meshOf(sphere(8, 1), options);
  EXPECT_GT(fitted->mesh->cellCount(), 2000);
  EXPECT_NE(describeBudget(*fitted, options).find("cannot be met"), std::string::npos);
}

TEST(CellBudget, TheSameForAnyNumberOfThreads)
{
  SizingSpec sizing;
  sizing.curvatureAngle = 20;
  TestOptions options = asking(0.3, sizing);
  options.cellBudget = 900;
  const Soup soup = torus(16, 1, 0.4).turned();
  const auto arrays = [&](int threads) {
    Execution execution(threads);
    const std::unique_ptr<Assembly> assembly = meshOf(soup, options, threads);
    return arraysOf(*assembly->mesh, assembly->boxes, execution);
  };
  EXPECT_TRUE(arrays(1) == arrays(3));
}

}
}

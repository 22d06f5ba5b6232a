// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/CellBudget.h"

#include "Base/Error.h"
#include "Boxes/IntersectedBoxes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cartesian
{

namespace
{

// Cells per box that the surface passes through, where short edges collapse; measured from 0.5 to 0.9, the most on
// thin bodies.
constexpr double CellsOfCutBoxes = 0.7;

// Boxes are fitted more closely than the cells have to.
constexpr double BoxTolerance = 0.01;

constexpr double MostRelaxed = 1e3;
constexpr int MostSteps = 12;
constexpr int MostMeshes = 3;

// Beyond this multiple of the budget boxes are not made, only estimated.
constexpr double FarTooMany = 4;

double cellsOf(const Assembly& assembly)
{
  return static_cast<double>(assembly.mesh->cellCount()) +
    (assembly.layers ? static_cast<double>(assembly.layers->stacks.cells()) : 0);
}

// The number of cells when sizes are relaxed by a factor: each is computed once.
class Forecast
{
public:
  Forecast(Decomposition& decomposition, const Options& options, Execution& execution)
    : decomposition_(decomposition)
    , execution_(execution)
    , budget_(options.cellBudget)
    , cellsOfCutBoxes_(options.collapse.ratio > 0 && shapesCells(options) &&
            options.patches.method != PatchMethod::ExactFit
          ? CellsOfCutBoxes
          : 1)
  {
  }

  double cells(double factor)
  {
    const auto known = known_.find(factor);
    return scale_ * (known != known_.end() ? known->second : count(factor));
  }

  // A mesh was made with this factor.
  void learn(double factor, double cells) { scale_ = cells / known_.at(factor); }

  // The least factor, within the tolerance, with which the cells fit. Where many sizes change at once, the number of
  // cells jumps: past the jump, if the budget allows it and is nearer there.
  double factorThatFits()
  {
    const auto fits = [&](double factor) { return cells(factor) <= budget_ * (1 + BoxTolerance); };
    if (fits(1))
    {
      return 1;
    }
    double low = 1;
    double high = 2;
    for (; !fits(high) && high < MostRelaxed; high *= 2)
    {
      low = high;
    }
    for (int step = 0; step < MostSteps && cells(high) < budget_ * (1 - BoxTolerance); ++step)
    {
      const double middle = between(low, high, step);
      (fits(middle) ? high : low) = middle;
    }
    const double over = cells(low) / budget_ - 1;
    return over <= BudgetTolerance && over < 1 - cells(high) / budget_ ? low : high;
  }

private:
  // Where the budget lies if cells are a power of the factor; every other time the middle, as they may not be.
  double between(double low, double high, int step)
  {
    const double most = std::log(cells(low));
    const double least = std::log(std::max(1.0, cells(high)));
    const double part = step % 2 == 1 || most <= least
      ? 0.5
      : std::clamp((most - std::log(budget_)) / (most - least), 0.05, 0.95);
    return low * std::pow(high / low, part);
  }

  double count(double factor)
  {
    decomposition_.relax(factor, execution_);
    double cells = 0;
    for (const MeshEstimate& layer : decomposition_.estimateLayers(execution_))
    {
      cells += layer.inside + cellsOfCutBoxes_ * layer.intersected;
    }
    if (scale_ * cells <= FarTooMany * budget_)
    {
      const Boxes boxes = decomposition_.boxes(decomposition_.allLayers(), execution_);
      cells =
        static_cast<double>(boxes.packed.size()) - (1 - cellsOfCutBoxes_) * countIntersected(boxes);
    }
    known_.emplace(factor, cells);
    return cells;
  }

  Decomposition& decomposition_;
  Execution& execution_;
  const double budget_;
  const double cellsOfCutBoxes_;
  double scale_ = 1; // of the mesh made last
  std::map<double, double> known_;
};

}

std::unique_ptr<Assembly> meshWithinBudget(const PreparedSurface& prepared,
  Decomposition& decomposition, const Options& options, Execution& execution)
{
  Forecast forecast(decomposition, options, execution);
  std::unique_ptr<Assembly> assembly;
  for (int meshes = 0; meshes < MostMeshes; ++meshes)
  {
    const double factor = forecast.factorThatFits();
    if (assembly && factor == assembly->relaxation)
    {
      break;
    }
    assembly.reset();
    decomposition.relax(factor, execution);
    assembly = meshPart(prepared, decomposition, decomposition.allLayers(), options, execution);
    assembly->relaxation = factor;
    const double cells = cellsOf(*assembly);
    const double tooMany = cells / options.cellBudget - 1;
    if (tooMany <= BudgetTolerance && (factor == 1 || tooMany >= -BudgetTolerance))
    {
      break;
    }
    forecast.learn(factor, cells);
  }
  return assembly;
}

std::string describeBudget(const Assembly& assembly, const Options& options)
{
  const double cells = cellsOf(assembly);
  const std::string has = "the mesh has " + std::to_string(static_cast<long long>(cells)) +
    " cells, the Cell Budget is " + std::to_string(static_cast<long long>(options.cellBudget)) +
    ".";
  std::string text;
  if (assembly.relaxation > 1)
  {
    text =
      "To meet the Cell Budget, Curvature Angle, that of Refine For Layers, the box size in gaps "
      "(Cells Across Gaps) and the sizes of the Size Array, where used, were multiplied by " +
      number(assembly.relaxation) + ": " + has;
  }
  if (cells > options.cellBudget * (1 + BudgetTolerance))
  {
    text += std::string(text.empty() ? "" : " ") +
      "The Cell Budget cannot be met by relaxing Curvature Angle, Refine For Layers, Cells Across "
      "Gaps and the Size Array alone: " +
      has + " Choose a larger Cell Size or a smaller Refinement Depth.";
  }
  return text;
}

}

// SPDX-License-Identifier: BSD-3-Clause
// A mesh within the user's number of cells: sizes by shape or field (SizingSpec.h) are relaxed by a common factor until
// it fits.
#pragma once

#include "Mesher/Assembly.h"
#include "Mesher/Mesher.h"

namespace cartesian
{

// A mesh may have more cells than the budget, or fewer where sizes are relaxed, by this part of it.
constexpr double BudgetTolerance = 0.05;

// The whole mesh, with the sizes of `decomposition` relaxed as the budget requires. The final cell count is not known
// before: the mesh is rebuilt, at most twice, if there are too many or too few. If there are too many even without
// those sizes, that mesh. Throws what meshPart() throws.
std::unique_ptr<Assembly> meshWithinBudget(const PreparedSurface& prepared,
  Decomposition& decomposition, const Options& options, Execution& execution);

// A message: what was relaxed, or that the budget cannot be met; empty if there was nothing to do.
std::string describeBudget(const Assembly& assembly, const Options& options);

}

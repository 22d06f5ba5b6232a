// SPDX-License-Identifier: BSD-3-Clause
// A mesh of as many cells as the user wants: what asks for small boxes by itself (SizingSpec.h) is relaxed, evenly,
// until the cells fit.
#pragma once

#include "Mesher/Assembly.h"
#include "Mesher/Mesher.h"

namespace cartesian
{

// A mesh may have more cells than the budget, or fewer where sizes are relaxed, by this part of it.
constexpr double BudgetTolerance = 0.05;

// The whole mesh, with the sizes of `decomposition` as relaxed as the budget needs. The final cell count is not
// known before: the mesh is made anew, at most twice, if there are too many or too few. Where even without those
// sizes there are too many, that mesh. Throws what meshPart() throws.
std::unique_ptr<Assembly> meshWithinBudget(const PreparedSurface& prepared,
  Decomposition& decomposition, const Options& options, Execution& execution);

// What was relaxed, or that the budget cannot be kept; empty if nothing was to do.
std::string describeBudget(const Assembly& assembly, const Options& options);

}

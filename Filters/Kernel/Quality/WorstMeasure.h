// SPDX-License-Identifier: BSD-3-Clause
// Which of the measures of a mesh is the worst, relative to the limits.
#pragma once

#include "Quality/QualityMeasures.h"

namespace cartesian
{

// Bits of Failures that solvers of flow care about: only those that track particles need tetrahedra.
constexpr std::uint32_t FailuresForSolvers = ~(1U << TetQuality);

// How near a value is to its limit: 0 far from it, 1 at it, more beyond; 0 for measures whose limit is none or a mere sign.
double nearnessToLimit(Measure measure, double value, const QualityLimits& limits);

// Of FailuresForSolvers, the measure that most cells fail; where none fails, the one whose worst value is nearest to its
// limit. `summary`: of summarise(), or the same over all processes.
Measure worstMeasure(const std::vector<SummaryValue>& summary, const QualityLimits& limits);

}

// SPDX-License-Identifier: BSD-3-Clause
// Where each stage of the task ends, as a part of all work: measured on a mesh of 2 million cells with
// default properties.
#pragma once

#include "Base/Execution.h"
#include "Mesher/Options.h"

namespace cartesian
{

constexpr double AfterSurface = 0.008;
constexpr double AfterDefects = 0.016; // while Boxes begin where Surface ends
constexpr double AfterBoxes = 0.045;
constexpr double AfterPatches = 0.155;
constexpr double AfterSides = 0.19;
constexpr double AfterInnerFaces = 0.21;
constexpr double AfterCells = 0.22;
constexpr double AfterShortEdges = 0.3;
constexpr double AfterShaping = 0.88;
constexpr double AfterNumbering = 0.93;

// Leaves out of the progress the stages that the options do not ask for; before the first stage.
inline void planStages(const Options& options, Execution& execution)
{
  execution.leaveOut(options.collapse.ratio > 0 ? AfterShortEdges : AfterCells,
    shapesCells(options) ? AfterShortEdges : AfterShaping);
}

}

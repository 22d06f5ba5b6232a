// SPDX-License-Identifier: BSD-3-Clause
// Where each stage of the task ends, as a part of all work: measured on a mesh of 2 million cells with
// default properties.
#pragma once

#include "Base/Execution.h"
#include "Mesher/Options.h"

namespace cartesian
{

constexpr double AfterSurface = 0.0056;
constexpr double AfterDefects = 0.0112; // while Boxes begin where Surface ends
constexpr double AfterBoxes = 0.0315;
constexpr double AfterPatches = 0.1085;
constexpr double AfterSides = 0.133;
constexpr double AfterInnerFaces = 0.147;
constexpr double AfterCells = 0.154;
constexpr double AfterEditing = 0.616;
constexpr double AfterNumbering = 0.651;
constexpr double AfterLayers = 0.951;

// Excludes from the progress the stages that the options do not need; before the first stage.
inline void planStages(const Options& options, Execution& execution)
{
  if (!editsWall(options))
  {
    execution.leaveOut(AfterCells, AfterEditing);
  }
  if (!options.layers.any())
  {
    execution.leaveOut(AfterNumbering, AfterLayers);
  }
}

}

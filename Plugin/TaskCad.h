// SPDX-License-Identifier: BSD-3-Clause
// How the CAD files of a task are read: its table [cad].
#pragma once

#include "TaskTables.h"

namespace cartesian
{

bool isCadReader(vtkSMProxy* source);

// What all CAD readers before a mesher have in common, as far as it is not what a task takes by itself: then [cad] is
// empty. Reads the files if it must. Throws std::runtime_error: they differ.
TaskTable cadTable(vtkSMProxy* mesher);

}

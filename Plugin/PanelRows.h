// SPDX-License-Identifier: BSD-3-Clause
// Tables of the panel in states that have fewer columns.
#pragma once

class vtkSMProxy;

namespace cartesian
{

// Extends the columns of each table to the longest, by the values of a new row, which must mean the same as none: the
// panel shows no rows where columns are not equally long, and would lose them with the next one added.
void completeTables(vtkSMProxy* source);

// Called when the plugin is loaded. From then on, tables in states that are loaded are completed, if the source has the
// hint CompleteRows.
void completeRowsOfStates();

}

// SPDX-License-Identifier: BSD-3-Clause
// Tables of the panel in states that have fewer columns.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on columns without values, of tables in states that are loaded, have those
// of a new row, if the source has the hint CompleteRows: the panel shows no rows where columns are not equally long, and would lose them with the next one added.
// Such values must mean the same as none.
void completeRowsOfStates();

}

// SPDX-License-Identifier: BSD-3-Clause
// Where new rows of tables in the panel begin.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on a row that the user adds to a table begins with the bounding box of the
// source's input, if the table says in its hints which columns are its lower corner and its lengths:
//
//   <BeginAtInput position="RefinementPositions" lengths="RefinementLengths"/>
//
// Scripts, states and tasks give all values of a row themselves.
void watchNewRows();

}

// SPDX-License-Identifier: BSD-3-Clause
// Joins the rims of sheets whose triangles are present twice to the walls that they end on, so that what a sheet divides
// stays divided: a file rounds a rim that does not have the walls' vertices, and so it ends beside them.
#pragma once

#include "Repair/ThinSheets.h"

namespace cartesian
{

// Rims within the snap distance (Snapping.h) of walls of their region. If there are any, the sheets are the last triangles
// of the surface afterwards, and known to be such (Surface::ofSheet); otherwise nothing changes, and false is returned.
bool joinRimsOfSheets(Surface& surface, const std::vector<SheetPair>& sheets, Execution& execution);

}

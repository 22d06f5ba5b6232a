// SPDX-License-Identifier: BSD-3-Clause
// What the report of a mesh says and shows.
#pragma once

#include "Report/ReportPage.h"
#include "UpstreamSettings.h"

class vtkUnstructuredGrid;

namespace cartesian
{

// `grid`: the whole mesh, on one process; others need not call this. Throws Error (BadMesh): a cell with curved edges, too many points, no cells.
ReportPage reportOf(vtkUnstructuredGrid* grid, const Upstream& upstream);

}

// SPDX-License-Identifier: BSD-3-Clause
// The faces between cells of two regions.
#pragma once

#include "Cells/Cells.h"

namespace cartesian
{

// Makes the patches between two regions inner faces, below which is the region behind: from then on whatever
// changes such a face changes it for both its cells. Patches keep their numbers; no cell has those any more.
void makeInterfaces(const Patches& patches, InnerFaces& inner, Cells& cells, Execution& execution);

// Whether a face of a cell is between two regions.
bool isInterface(const Cells& cells, const FaceOfCell& face);

}

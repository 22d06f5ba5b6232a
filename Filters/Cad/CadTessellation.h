// SPDX-License-Identifier: BSD-3-Clause
// Tessellated solids of a STEP file (AP242): triangles instead of exact shapes, which Open CASCADE 7.6 does not read.
#pragma once

#include "CadPart.h"

namespace cartesian
{

bool holdsTriangles(const std::string& text);

// A part for each solid or shell, wherever assemblies place it; if the file has exact shapes, of those products alone that have
// none, and of solids that refer to none. Faces have triangles and no surface, and know no edges. Throws CadError.
std::vector<CadPart> tessellatedParts(const std::string& text, bool isBesideExact);

// Of what the file may place its triangles by, and is not read, in words; empty if there is none.
std::string unreadPlacement(const std::string& text);

}

// SPDX-License-Identifier: BSD-3-Clause
// Whether the faces of a cell close it.
#pragma once

#include "Editing/EditMesh.h"

namespace cartesian
{

// The first test, which nearly all that are not closed fail: Euler's formula. False also of cells with more faces or corners
// than edits look at.
bool isClosedByCount(EditMesh& mesh, std::uint32_t c);

// Each edge is one of two faces, in opposite directions; all faces are one shell, which nowhere touches itself and has no
// handle: then Euler's formula holds.
bool isClosed(EditMesh& mesh, std::uint32_t c);

}

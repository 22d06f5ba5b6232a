// SPDX-License-Identifier: BSD-3-Clause
// Whether the faces of a cell close it.
#pragma once

#include "Editing/MeshEditor.h"

namespace cartesian
{

// By how much a cell eulerDefect Euler's formula: nodes - edges + faces = 2. By 2 for each handle, as where a rod goes through it,
// and 1 for each node at which it touches itself; by less than 0: it is in pieces, or open. Cells are cut from boxes with handles;
// edits may take these away, but make no more.
void noteEulerDefects(EditMesh& whole, Execution& execution);

// Where edits took a handle away, or an edge at which it touches itself.
void lowerMisses(MeshEditor& mesh, std::uint32_t c);

// The first test, which nearly all that are not closed fail: that formula.
bool isClosedByCount(MeshEditor& mesh, std::uint32_t c);

// Each edge is one of two faces, in opposite directions, or of several such pairs where the cell may touch itself; all faces are
// one shell, with no more handles than noted.
bool isClosed(MeshEditor& mesh, std::uint32_t c);

// Whether a cell has an edge of more than two faces.
bool touchesItself(const MeshView& mesh, std::uint32_t c);

}

// SPDX-License-Identifier: BSD-3-Clause
// No face without area: one whose corners lie on a line.
//
// Patches of walls that touch in a plane leave such faces on sides of boxes, and edits that take thin cells away leave
// some of their faces. A face on a line encloses nothing: each piece of the line is passed as often one way as the other.
// Once its edges are divided at its corners, in all faces that have them, its cells close without it.
#pragma once

#include "Cells/WallMesh.h"
#include "Editing/EditLoop.h"

namespace cartesian
{

// Whether the corners of a face lie on a line as far as doubles can tell: then area and normal are noise.
bool isFlat(const MeshView& mesh, std::uint32_t f);

// Whether any face of the mesh at the wall is, as it was cut.
bool hasFlatFaces(const Nodes& nodes, const WallMesh& wall, Execution& execution);

// Takes them out: cells keep their volumes, walls their places. Where that cannot be (a cell of few other faces, which only
// holds what these are warped; faces that would touch themselves) a cell becomes part of another, where the rules allow that, or
// goes whatever they say, as solvers cannot use it, or a corner becomes the next: returns what was done to cells. What changes
// is measured, and costs as the rules say. All cells are in zone 0.
std::vector<MadeEdit> removeFlatFaces(
  EditMesh& whole, const EditRules& rules, Execution& execution);

}

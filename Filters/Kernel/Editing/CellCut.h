// SPDX-License-Identifier: BSD-3-Clause
// Cuts a cell by a plane (section 4.11): any section of one polygon or several, through faces of any shape.
#pragma once

#include "Editing/FixedList.h"
#include "Editing/MeshEditor.h"

namespace cartesian
{

struct CutPlane
{
  Vector through;
  Vector normal;            // of length 1
  double tolerance;         // nodes as near as this lie on it
  bool mayLookBack = false; // a face between parts may, where further edits follow
};

using CutParts = FixedList<std::uint32_t, 16>;

// The first part stays cell c. As PrimitiveEdits.h: false, where a section would touch itself or have a hole, or there
// is none.
bool cutCell(MeshEditor& mesh, std::uint32_t c, const CutPlane& plane, CutParts& parts);

}

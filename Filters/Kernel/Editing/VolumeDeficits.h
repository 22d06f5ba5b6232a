// SPDX-License-Identifier: BSD-3-Clause
// What walls owe of the volume that the surface encloses: they pass it on to those that edits put in their place.
#pragma once

#include "Editing/MeshEditor.h"

namespace cartesian
{

// Of the walls that changed since the last commit: what they owed, what those there now would owe (signed, in volume), and
// the area of these, and how many changed.
struct ChangedDeficit
{
  double before = 0;
  double after = 0;
  double area = 0;
  std::size_t walls = 0;
};

// `ofWalls`: or of faces between regions.
ChangedDeficit changedDeficit(const MeshEditor& mesh, bool ofWalls);

// After edits are made and before they are committed.
void passOnDeficits(MeshEditor& mesh);

}

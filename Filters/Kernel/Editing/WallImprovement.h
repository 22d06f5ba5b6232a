// SPDX-License-Identifier: BSD-3-Clause
// The wall, from raw cells to ones that solvers take: simplified, short edges snapped, then the loop, first in general, then
// for what still fails, and last the volume made true.
#pragma once

#include "Editing/EditMesh.h"

#include <functional>

namespace cartesian
{

// `poll`: called now and then; may throw.
void improveWall(EditMesh& mesh, const std::function<void()>& poll);

}

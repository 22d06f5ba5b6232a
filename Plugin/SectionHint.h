// SPDX-License-Identifier: BSD-3-Clause
// What ParaView's own sections do to polyhedra.
#pragma once

namespace cartesian
{

// From now on a message says, once in a session, that Divide Polyhedra makes Clip and Slice exact, when either has
// been applied to a mesh of polyhedra.
void watchSections();

}

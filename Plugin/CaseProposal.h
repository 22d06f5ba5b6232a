// SPDX-License-Identifier: BSD-3-Clause
// What the window proposes where a mesh is saved as an OpenFOAM case.
#pragma once

#include <string>

class vtkSMProxy;

namespace cartesian
{

// A folder of its own (the writer's New Folder), if that of the file has other files and no case: a case has several
// files and folders beside the one that is chosen.
void proposeFolder(vtkSMProxy* writer);

// A Solver Setup, if there is one that the mesh has all of: around bodies, or from a boundary called inlet to one called outlet;
// and Regions As Zones, if they are zones of one fluid.
// None where there is a case, which has its own.
void proposeSetup(vtkSMProxy* writer);

// DIR/NAME.foam: DIR/NAME/NAME.foam.
std::string inNewFolder(const std::string& file);

}

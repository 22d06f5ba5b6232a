// SPDX-License-Identifier: BSD-3-Clause
// Wavefront OBJ files of nothing but vertices, faces, groups and objects, as most surfaces are: read on all threads.
#pragma once

#include "Base/Execution.h"

class vtkPolyData;

namespace cartesian
{

// Reads what vtkOBJReader does, GroupIds included. False, and nothing is read: the file has something else in it, or
// something wrong, and is vtkOBJReader's.
bool readPlainObj(const char* file, vtkPolyData* surface, Execution& execution);

}

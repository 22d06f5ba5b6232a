// SPDX-License-Identifier: BSD-3-Clause
// What this version of vtkSTLReader reads ASCII from; only this file and its source depend on that.
#pragma once

#include "vtkVersionMacros.h"

#include <cstdio>

#define CARTESIAN_STL_PARSER (VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0))

#if CARTESIAN_STL_PARSER
#include "vtkResourceParser.h"
#include "vtkSmartPointer.h"
#endif

namespace cartesian
{

// From VTK 9.6 on it is a parser, here of a file's text in memory; before, the file.
#if CARTESIAN_STL_PARSER
vtkSmartPointer<vtkResourceParser> stlSource(std::FILE* file);
#else
inline std::FILE* stlSource(std::FILE* file)
{
  return file;
}
#endif

}

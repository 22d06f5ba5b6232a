// SPDX-License-Identifier: BSD-3-Clause
// How users stop a filter, in each version of VTK.
#pragma once

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace cartesian
{

// Whether the algorithm, or since VTK 9.3 one before or after it, is to stop.
inline bool isStopped(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220823) // ParaView 5.11's
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

}

// SPDX-License-Identifier: BSD-3-Clause
// What read-cad has read, as blocks.
#pragma once

#include "CadProgram.h"

class vtkMultiBlockDataSet;

namespace cartesian
{

// Fills `blocks` as vtkCADReader.h says.
void cadBlocks(const CadContent& content, double metresPerUnit, vtkMultiBlockDataSet* blocks);

}

// SPDX-License-Identifier: BSD-3-Clause
// The solids of an assembly, each instance by itself, with the names, colours and layers of their faces.
#pragma once

#include "CadEntities.h"

class TDocStd_Document;

namespace cartesian
{

// Of each product its solids, and then its faces that belong to none, if there are any.
std::vector<CadPart> partsOf(const Handle(TDocStd_Document) & document, const NamesOfShapes& names);

}

// SPDX-License-Identifier: BSD-3-Clause
// The names that a legend of an output's colours has.
#pragma once

#include <string>
#include <vector>

class vtkDataObject;

namespace cartesian
{

// Of all outputs, each once: "array/value" for the arrays of strings on cells, as the field data "arrays" list them, or
// else sorted; "Region/number/name" for the regions. Null outputs have none.
std::vector<std::string> legendOf(const std::vector<vtkDataObject*>& outputs);

}

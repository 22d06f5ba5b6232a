// SPDX-License-Identifier: BSD-3-Clause
// Which boundary each face is.
#pragma once

#include "CadOptions.h"
#include "CadPart.h"

#include <cstdint>

namespace cartesian
{

struct CadBoundaries
{
  std::vector<std::string> names;                // by number
  std::vector<std::vector<std::int32_t>> ofFace; // of each part, in order of facesOf()
};

// Whether an assembly only counts its instances: "NAUO1", "9".
bool isNumbered(const std::string& instance);

// Gives solids of one name names that differ: those of the instances, if these do, else bolt_1, bolt_2. Those without a
// name are called `other`; a sheet beside a solid of its name, bolt_sheet.
void numberAlike(std::vector<CadPart>& parts, const std::string& other);

// Faces of one name in one part are one boundary; names that several parts have are numbered. Colours and layers are
// boundaries of all parts together.
CadBoundaries boundariesOf(
  const std::vector<CadPart>& parts, CadNames from, const CadReport& report);

}

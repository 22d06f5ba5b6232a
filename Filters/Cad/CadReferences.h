// SPDX-License-Identifier: BSD-3-Clause
// Other files in which a STEP file has parts of its assembly.
#pragma once

#include <string>
#include <vector>

class STEPCAFControl_Reader;

namespace cartesian
{

// Names of those that hold shapes of products and were not read, once the others were.
std::vector<std::string> unreadFiles(const STEPCAFControl_Reader& reader);

// All files that are named, whatever they hold.
std::vector<std::string> namedFiles(const STEPCAFControl_Reader& reader);

// "a.stp, b.stp and 7 more".
std::string listOf(const std::vector<std::string>& files);

}

// SPDX-License-Identifier: BSD-3-Clause
// Names for formats that allow ASCII only.
#pragma once

#include <string>

namespace cartesian
{

// A name (UTF-8) in ASCII: letters of Latin, Greek and Cyrillic alphabets by the Latin ones that they are written with
// elsewhere, "Gehaeuse"; any other character by its code point, "u8fdb", so that names that differ mostly still do.
std::string asciiName(const std::string& name);

}

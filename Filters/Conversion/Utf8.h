// SPDX-License-Identifier: BSD-3-Clause
// Names come from files in any encoding; Python and its JSON take UTF-8 only.
#pragma once

#include <string>

namespace cartesian
{

// The text itself where it is UTF-8; else its bytes are characters of Latin-1.
std::string toUtf8(const std::string& text);

bool isAscii(const std::string& text);

}

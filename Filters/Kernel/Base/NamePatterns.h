// SPDX-License-Identifier: BSD-3-Clause
// Patterns for names: * is any text, ? any character.
#pragma once

#include <string>

namespace cartesian
{

bool isPattern(const std::string& name);
bool isOf(const std::string& text, const std::string& pattern);

}

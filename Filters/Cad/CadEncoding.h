// SPDX-License-Identifier: BSD-3-Clause
// In which encoding a file's names are. STEP files ought to be ASCII; many programs write their own system's bytes.
#pragma once

#include "CadOptions.h"

#include <string>

namespace cartesian
{

bool isUtf8(const std::string& text);

// That of bytes that are not UTF-8, of the whole file: what is frequent in a language tells.
CadEncoding guessedEncoding(const std::string& text);

// "Western European".
std::string nameOf(CadEncoding encoding);

// What means nothing becomes a replacement character. Throws CadError if the system does not know the encoding.
std::string toUtf8(const std::string& text, CadEncoding from);

}

// SPDX-License-Identifier: BSD-3-Clause
// Names of arrays and options as words.
#pragma once

#include <cctype>
#include <string>

namespace cartesian
{

// NonOrthogonality: Non Orthogonality, as the panel has it.
inline std::string wordsOf(const std::string& name)
{
  std::string words;
  for (const char c : name)
  {
    words += std::isupper(static_cast<unsigned char>(c)) != 0 && !words.empty() ? " " : "";
    words += c;
  }
  return words;
}

}

// SPDX-License-Identifier: BSD-3-Clause
// Names as words: of arrays and options, of cells of the surface.
#pragma once

#include <cctype>
#include <string>

namespace cartesian
{

// NonOrthogonality: Non Orthogonality, as the panel has it; NamedSTLReader: Named STL Reader.
inline std::string wordsOf(const std::string& name)
{
  const auto isCapital = [&](std::size_t i) {
    return i < name.size() && std::isupper(static_cast<unsigned char>(name[i])) != 0;
  };
  std::string words;
  for (std::size_t i = 0; i < name.size(); ++i)
  {
    const bool begins =
      isCapital(i) && (!isCapital(i - 1) || (i + 1 < name.size() && !isCapital(i + 1)));
    words += i > 0 && begins ? " " : "";
    words += name[i];
  }
  return words;
}

// -1: of triangles that close a hole.
inline std::string nameOfCell(long long cell)
{
  return cell < 0 ? "a lid" : "cell " + std::to_string(cell);
}

}

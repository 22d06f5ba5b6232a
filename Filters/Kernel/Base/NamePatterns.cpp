// SPDX-License-Identifier: BSD-3-Clause
#include "Base/NamePatterns.h"

namespace cartesian
{

bool isOf(const std::string& text, const std::string& pattern)
{
  std::size_t t = 0;
  std::size_t p = 0;
  std::size_t star = std::string::npos; // the last one, which so far is for what is before `from`
  std::size_t from = 0;
  while (t < text.size())
  {
    if (p < pattern.size() && pattern[p] == '*')
    {
      star = p++;
      from = t;
    }
    else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t]))
    {
      ++p;
      ++t;
    }
    else if (star != std::string::npos)
    {
      p = star + 1;
      t = ++from;
    }
    else
    {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string::npos;
}

bool isPattern(const std::string& name)
{
  return name.find_first_of("*?") != std::string::npos;
}

}

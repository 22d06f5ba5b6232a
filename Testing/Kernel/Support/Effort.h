// How often tests repeat: less often under the sanitizers, which make the kernel ten times slower and
// look for faults that any input of a kind shows.
#pragma once

#include <initializer_list>
#include <vector>

namespace cartesian
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int RepeatedLess = 6;
#else
constexpr int RepeatedLess = 1;
#endif

// How many of `count` seeds or random inputs to use.
constexpr unsigned repeats(unsigned count)
{
  return (count + RepeatedLess - 1) / RepeatedLess;
}

// Which of the cases to use: under the sanitizers, only the last one.
template <class Case>
std::vector<Case> cases(std::initializer_list<Case> all)
{
  return RepeatedLess == 1 ? std::vector<Case>(all) : std::vector<Case>{ *(all.end() - 1) };
}

}

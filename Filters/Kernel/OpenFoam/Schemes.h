// SPDX-License-Identifier: BSD-3-Clause
// fvSchemes of a steady case.
#pragma once

#include <string>

namespace cartesian
{

// Beside what all cases have in common.
struct Schemes
{
  std::string gradients;   // entries of gradSchemes; empty: the default alone
  std::string divergences; // entries of divSchemes; empty: nothing flows
  double correction; // how much of a gradient along a face's normal its correction may be, 0 to 1
};

std::string schemesOf(const Schemes& schemes);

}

// SPDX-License-Identifier: BSD-3-Clause
// The values that an option may have.
#pragma once

#include "Base/Error.h"

#include <limits>

namespace cartesian
{

struct Range
{
  double least = 0;
  double most = std::numeric_limits<double>::infinity();
  bool withMost = true; // whether `most` itself is allowed
  bool withLeast = true;

  // False for NaN.
  constexpr bool holds(double value) const
  {
    return (withLeast ? value >= least : value > least) &&
      (withMost ? value <= most : value < most);
  }
};

constexpr Range moreThan(double least)
{
  return { least, std::numeric_limits<double>::infinity(), true, false };
}

// Throws Error (BadParameter) where the option `name` is out of its range.
inline void requireInRange(const Range& range, double value, const std::string& name)
{
  if (range.holds(value))
  {
    return;
  }
  std::string text = name + " is " + number(value) + ": it must be ";
  if (range.most == std::numeric_limits<double>::infinity())
  {
    text += range.withLeast ? number(range.least) + " or more."
                            : "more than " + number(range.least) + ".";
  }
  else
  {
    text += (range.withLeast ? "from " : "from more than ") + number(range.least) +
      (range.withMost ? " to " : " to less than ") + number(range.most) + ".";
  }
  throw Error(Fault::BadParameter, text);
}

}

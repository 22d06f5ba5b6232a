// SPDX-License-Identifier: BSD-3-Clause
// Names as a format allows them, each different.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace cartesian
{

class UniqueNames
{
public:
  explicit UniqueNames(std::size_t mostBytes)
    : mostBytes_(mostBytes)
  {
  }

  // Of this name: cut short if it is too long, with a number at its end where that is taken.
  std::string take(const std::string& name);

  // The unique name for this name, always the same.
  const std::string& of(const std::string& name);

  // No other gets a name that these have.
  void avoid(const UniqueNames& others)
  {
    taken_.insert(others.taken_.begin(), others.taken_.end());
  }

private:
  std::size_t mostBytes_;
  std::map<std::string, std::string> names_;
  std::set<std::string> taken_;
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Which row of a table counts for something that has a name.
#pragma once

#include "Base/NamePatterns.h"

#include <algorithm>
#include <string>
#include <vector>

namespace cartesian
{

// The row of that name, else the first whose pattern fits; null: none. `nameIn`: where a row has its name.
template <class Row>
const Row* rowFor(const std::vector<Row>& rows, std::string Row::*nameIn, const std::string& name)
{
  const auto isNamed = [&](const Row& row) { return row.*nameIn == name; };
  const auto fits = [&](
                      const Row& row) { return isPattern(row.*nameIn) && isOf(name, row.*nameIn); };
  auto found = std::find_if(rows.begin(), rows.end(), isNamed);
  found = found == rows.end() ? std::find_if(rows.begin(), rows.end(), fits) : found;
  return found == rows.end() ? nullptr : &*found;
}

template <class Row>
std::vector<std::string> namesOf(const std::vector<Row>& rows, std::string Row::*nameIn)
{
  std::vector<std::string> names(rows.size());
  std::transform(
    rows.begin(), rows.end(), names.begin(), [&](const Row& row) { return row.*nameIn; });
  return names;
}

std::string listOf(const std::vector<std::string>& names, const std::string& separator);

// Throws Error (BadParameter): a row of `table` is for none of the `names`, or has the name of an earlier row. `kind`:
// what has these names, such as "boundary".
void requireRowsFit(const std::vector<std::string>& rows, const std::vector<std::string>& names,
  const std::string& table, const std::string& kind);

}

// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/Rows.h"

#include "Base/Error.h"

namespace cartesian
{

std::string listOf(const std::vector<std::string>& names, const std::string& separator)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : separator) + name;
  }
  return text;
}

void requireRowsFit(const std::vector<std::string>& rows, const std::vector<std::string>& names,
  const std::string& table, const std::string& kind)
{
  for (auto row = rows.begin(); row != rows.end(); ++row)
  {
    if (std::none_of(
          names.begin(), names.end(), [&](const auto& name) { return isOf(name, *row); }))
    {
      throw Error(Fault::BadParameter,
        table + ": no " + kind + " is called \"" + *row + "\", only " + listOf(names, ", ") +
          ". Nothing is written: correct the name, or remove the row.");
    }
    if (std::find(rows.begin(), row, *row) != row)
    {
      throw Error(Fault::BadParameter,
        table + ": two rows are for " + *row + ". Nothing is written: remove one of them.");
    }
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/UniqueNames.h"

namespace cartesian
{

std::string UniqueNames::take(const std::string& name)
{
  std::string cut = name.substr(0, mostBytes_);
  for (int i = 2; !taken_.insert(cut).second; ++i)
  {
    const std::string end = "_" + std::to_string(i);
    cut = name.substr(0, mostBytes_ - end.size()) + end;
  }
  return cut;
}

const std::string& UniqueNames::of(const std::string& name)
{
  const auto [found, isNew] = names_.try_emplace(name);
  if (isNew)
  {
    found->second = take(name);
  }
  return found->second;
}

}

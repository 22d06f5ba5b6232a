// SPDX-License-Identifier: BSD-3-Clause
#include "SplitNames.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace cartesian
{

namespace
{

std::vector<std::string> listed(const std::string& text)
{
  std::vector<std::string> names;
  std::istringstream stream(text);
  for (std::string name; std::getline(stream, name, ',');)
  {
    const std::size_t first = name.find_first_not_of(" \t");
    if (first != std::string::npos)
    {
      names.push_back(name.substr(first, name.find_last_not_of(" \t") - first + 1));
    }
  }
  return names.empty() ? std::vector<std::string>{ "cap" } : names;
}

// What a patch is called before numbers tell those of one name apart.
class BaseNames
{
public:
  BaseNames(
    const SurfaceSplit& split, const BoundaryNames& names, SplitBy by, const std::string& capNames)
    : names_(names)
    , by_(by)
    , capNames_(listed(capNames))
  {
    for (const SurfacePatch& patch : split.patches)
    {
      ++patches_[patch.boundary];
    }
  }

  std::string next(const SurfacePatch& patch)
  {
    const std::string& name = names_.at(patch.boundary);
    const bool isUnnamed = names_.size() == 1 && name == unnamedBoundary(patch.boundary);
    if (by_ == SplitBy::Boundaries || (patches_[patch.boundary] == 1 && !isUnnamed))
    {
      return name;
    }
    if (by_ == SplitBy::FlatCaps && patch.standsAlone)
    {
      return capNames_[std::min(caps_++, capNames_.size() - 1)];
    }
    if (!isUnnamed)
    {
      return name;
    }
    if (by_ == SplitBy::FlatCaps || by_ == SplitBy::Planes)
    {
      return patch.standsAlone ? "plane" : "wall";
    }
    return "patch";
  }

private:
  const BoundaryNames& names_;
  SplitBy by_;
  std::vector<std::string> capNames_;
  std::map<std::int32_t, std::size_t> patches_; // of each boundary
  std::size_t caps_ = 0;                        // so far
};

}

std::vector<std::string> patchNames(
  const SurfaceSplit& split, const BoundaryNames& names, SplitBy by, const std::string& capNames)
{
  BaseNames bases(split, names, by, capNames);
  std::vector<std::string> result;
  std::map<std::string, std::size_t> count;
  for (const SurfacePatch& patch : split.patches)
  {
    result.push_back(bases.next(patch));
    ++count[result.back()];
  }
  std::map<std::string, std::size_t> last;
  for (std::string& name : result)
  {
    const std::string base = name;
    for (bool isNew = count[base] == 1; !isNew; isNew = count.emplace(name, 1).second)
    {
      name = base + "_" + std::to_string(++last[base]);
    }
  }
  return result;
}

}

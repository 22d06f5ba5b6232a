// SPDX-License-Identifier: BSD-3-Clause
#include "SplitNames.h"

#include "OpenFoam/FoamBoundary.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
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

std::vector<std::string> baseNames(
  const SurfaceSplit& split, const BoundaryNames& names, SplitBy by, const std::string& capNames)
{
  BaseNames bases(split, names, by, capNames);
  std::vector<std::string> result;
  std::transform(split.patches.begin(), split.patches.end(), std::back_inserter(result),
    [&](const SurfacePatch& patch) { return bases.next(patch); });
  return result;
}

std::vector<std::string> numbered(
  const std::vector<std::string>& bases, const std::vector<bool>& isGone, const std::string& taken)
{
  std::map<std::string, std::size_t> count;
  for (const std::string& base : bases)
  {
    ++count[base];
  }
  std::set<std::string> used{ taken };
  std::transform(count.begin(), count.end(), std::inserter(used, used.end()),
    [](const auto& named) { return named.first; });
  std::map<std::string, std::size_t> last;
  std::vector<std::string> result = bases;
  for (std::size_t i = 0; i < bases.size(); ++i)
  {
    const bool isLeft = isGone.empty() || !isGone[i];
    for (bool isNew = count[bases[i]] == 1 || !isLeft; !isNew;
         isNew = used.insert(result[i]).second)
    {
      result[i] = bases[i] + "_" + std::to_string(++last[bases[i]]);
    }
  }
  return result;
}

std::string describeWalledCaps(const SurfaceSplit& split, SplitBy by,
  const std::vector<std::string>& bases, const std::string& capNames,
  const std::vector<std::string>& nameOf)
{
  const std::vector<std::string> ofCaps = listed(capNames);
  std::set<std::string> walled;
  for (std::size_t i = 0; i < bases.size() && by == SplitBy::FlatCaps; ++i)
  {
    const bool isCap = split.patches[i].standsAlone &&
      std::find(ofCaps.begin(), ofCaps.end(), bases[i]) != ofCaps.end();
    if (isCap && !nameOf[i].empty() && !isOpening(nameOf[i]) && !isSymmetry(nameOf[i]))
    {
      walled.insert(nameOf[i]);
    }
  }
  std::string names;
  for (const std::string& name : walled)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

}

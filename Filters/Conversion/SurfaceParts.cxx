// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceParts.h"

#include "Base/Error.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace cartesian
{

SurfaceParts::SurfaceParts(const SurfaceSplit& split, const std::vector<std::string>& names,
  const std::vector<vtkIdType>& cells)
  : cells_(cells)
  , of_(split.patchOf.begin(), split.patchOf.end())
  , patches_(names.size())
{
  for (const std::string& name : names)
  {
    names_.emplace(static_cast<std::int32_t>(names_.size()), name);
  }
}

void SurfaceParts::select(const std::vector<bool>& cells, bool wholeParts, const std::string& name)
{
  if (name.empty())
  {
    throw Error(Fault::BadParameter,
      "Selection Name is empty: name the boundary that the selected cells become.");
  }
  std::set<std::int32_t> touched;
  for (std::size_t t = 0; t < of_.size(); ++t)
  {
    if (cells[static_cast<std::size_t>(cells_[t])])
    {
      touched.insert(of_[t]);
    }
  }
  if (touched.empty())
  {
    throw Error(Fault::BadParameter,
      "The Selection has no cell of the surface: select cells of it, or clear the Selection.");
  }
  const auto known = std::find_if(
    names_.begin(), names_.end(), [&](const auto& named) { return named.second == name; });
  const std::int32_t part = known != names_.end() ? known->first : names_.rbegin()->first + 1;
  names_[part] = name;
  for (std::size_t t = 0; t < of_.size(); ++t)
  {
    const bool isSelected = cells[static_cast<std::size_t>(cells_[t])];
    of_[t] = isSelected || (wholeParts && touched.count(of_[t]) != 0) ? part : of_[t];
  }
  dropEmpty();
}

std::vector<bool> SurfaceParts::areGone(const std::string& joined) const
{
  std::vector<bool> areGone(patches_);
  for (std::size_t patch = 0; patch < patches_; ++patch)
  {
    const auto part = names_.find(static_cast<std::int32_t>(patch));
    areGone[patch] = part == names_.end() || part->second == joined;
  }
  return areGone;
}

void SurfaceParts::nameLeft(const std::vector<std::string>& names, const std::string& joined)
{
  for (auto& [part, name] : names_)
  {
    const auto patch = static_cast<std::size_t>(part);
    name = patch < patches_ && name != joined ? names[patch] : name;
  }
}

void SurfaceParts::rename(const BoundarySettings& settings)
{
  const BoundaryNames given = mergedNames(settings, names_);
  std::map<std::string, std::int32_t> first;
  std::map<std::int32_t, std::int32_t> becomes;
  for (auto& [part, name] : names_)
  {
    const auto other = given.find(part);
    const std::string now = other == given.end() ? name : other->second;
    becomes[part] = first.emplace(now, part).first->second;
    std::string& former = former_[becomes[part]];
    former += (former.empty() ? "" : ", ") + name;
    name = now;
    given_[part] = now;
  }
  for (std::int32_t& part : of_)
  {
    part = becomes[part];
  }
  dropEmpty();
}

void SurfaceParts::dropEmpty()
{
  const std::set<std::int32_t> used(of_.begin(), of_.end());
  for (auto named = names_.begin(); named != names_.end();)
  {
    named = used.count(named->first) == 0 ? names_.erase(named) : std::next(named);
  }
}

std::vector<std::string> SurfaceParts::namesOfPatches() const
{
  std::vector<std::string> list(patches_);
  for (std::size_t patch = 0; patch < patches_; ++patch)
  {
    const auto given = given_.find(static_cast<std::int32_t>(patch));
    list[patch] = given == given_.end() ? "" : given->second;
  }
  return list;
}

std::vector<std::string> SurfaceParts::names() const
{
  std::vector<std::string> list;
  std::transform(names_.begin(), names_.end(), std::back_inserter(list),
    [](const auto& named) { return named.second; });
  return list;
}

std::vector<std::string> SurfaceParts::formerNames() const
{
  std::vector<std::string> list;
  for (const auto& [part, name] : names_)
  {
    const auto former = former_.find(part);
    list.push_back(former == former_.end() ? name : former->second);
  }
  return list;
}

std::vector<std::int32_t> SurfaceParts::ofTriangles() const
{
  std::vector<std::int32_t> number(
    names_.empty() ? 0 : static_cast<std::size_t>(names_.rbegin()->first) + 1);
  std::int32_t next = 0;
  for (const auto& named : names_)
  {
    number[static_cast<std::size_t>(named.first)] = next++;
  }
  std::vector<std::int32_t> result(of_.size());
  std::transform(of_.begin(), of_.end(), result.begin(),
    [&](std::int32_t part) { return number[static_cast<std::size_t>(part)]; });
  return result;
}

std::vector<std::int32_t> SurfaceParts::ofCells(vtkIdType count) const
{
  const std::vector<std::int32_t> ofTriangle = ofTriangles();
  std::vector<std::int32_t> result(static_cast<std::size_t>(count), NoBoundary);
  for (std::size_t t = ofTriangle.size(); t-- > 0;)
  {
    result[static_cast<std::size_t>(cells_[t])] = ofTriangle[t];
  }
  return result;
}

}

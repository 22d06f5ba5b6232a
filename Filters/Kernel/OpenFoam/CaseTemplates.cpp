// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/CaseTemplates.h"

#include "Base/Error.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>

namespace cartesian
{

namespace
{

namespace fs = std::filesystem;

bool isLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// The text with each placeholder replaced.
std::string replaced(
  const std::string& text, const std::function<std::string(const std::string& name)>& valueOf)
{
  std::string result;
  for (std::size_t at = 0; at < text.size();)
  {
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = *begin == '@' ? std::find_if_not(begin + 1, text.end(), isLetter) : begin;
    if (end != text.end() && *end == '@' && end - begin > 1)
    {
      result += valueOf({ begin + 1, end });
      at = static_cast<std::size_t>(end - text.begin()) + 1;
    }
    else
    {
      result += text[at++];
    }
  }
  return result;
}

std::set<std::string> placeholdersIn(const std::string& text)
{
  std::set<std::string> names;
  replaced(text, [&](const std::string& name) {
    names.insert(name);
    return std::string();
  });
  return names;
}

template <class Names, class NameOf>
std::string listed(const Names& names, const NameOf& nameOf)
{
  std::string list;
  for (const auto& each : names)
  {
    list += (list.empty() ? "" : ", ") + nameOf(each);
  }
  return list.empty() ? "none" : list;
}

[[noreturn]] void refuse(const std::string& what)
{
  throw Error(Fault::BadParameter, "Case Templates: " + what);
}

void requireKnown(const fs::path& file, const std::string& own, const std::string& ours)
{
  const std::set<std::string> known = placeholdersIn(ours);
  for (const std::string& name : placeholdersIn(own))
  {
    if (known.count(name) == 0)
    {
      refuse(file.string() + " has the placeholder @" + name +
        "@, which has no value there. Those that have: " +
        listed(known, [](const std::string& each) { return "@" + each + "@"; }) + ".");
    }
  }
}

}

CaseTemplates::CaseTemplates(const fs::path& folder)
{
  for (const auto& [name, text] : builtInTemplates())
  {
    texts_[name] = text;
  }
  if (folder.empty())
  {
    return;
  }
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error))
  {
    const std::string name = at->path().lexically_relative(folder).generic_string();
    if (at->is_directory() || name == "README.md")
    {
      continue;
    }
    const auto ours = texts_.find(name);
    if (ours == texts_.end())
    {
      refuse(at->path().string() + " is no template. Templates are: " +
        listed(texts_, [](const auto& each) { return each.first; }) + ".");
    }
    std::ifstream file(at->path(), std::ios::binary);
    const std::string own((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (!file)
    {
      refuse(at->path().string() + " cannot be read: let this user read it.");
    }
    requireKnown(at->path(), own, ours->second);
    ours->second = own;
  }
  if (error)
  {
    refuse(folder.string() + " cannot be read (" + error.message() +
      "): give a folder of templates, or none.");
  }
}

std::string CaseTemplates::filled(const std::string& name, const Values& values) const
{
  return replaced(
    texts_.at(name), [&](const std::string& placeholder) { return values.at(placeholder); });
}

}

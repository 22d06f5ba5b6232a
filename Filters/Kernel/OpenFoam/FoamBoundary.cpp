// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FoamBoundary.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fstream>
#include <iterator>

namespace cartesian
{

namespace
{

constexpr const char* Blank = " \t\r\n";
constexpr const char* EndOfWord = " \t\r\n;";

std::string newEntries(const std::string& name)
{
  const bool wall = name.rfind("wall", 0) == 0 || name.rfind("Wall", 0) == 0;
  return std::string("\n        type            ") + (wall ? "wall" : "patch") +
    ";\n        nFaces          0;\n        startFace       0;\n    ";
}

// Replaces the value of the entry `key`.
void setEntry(std::string& entries, const std::string& key, const std::string& value)
{
  for (std::size_t at = entries.find(key); at != std::string::npos; at = entries.find(key, at + 1))
  {
    const std::size_t after = at + key.size();
    const std::size_t begin = std::min(entries.find_first_not_of(Blank, after), entries.size());
    const std::size_t end = std::min(entries.find_first_of(EndOfWord, begin), entries.size());
    const std::size_t next = entries.find_first_not_of(Blank, end);
    const bool wholeWord = at == 0 || std::strchr(EndOfWord, entries[at - 1]);
    const bool oneWord = begin > after && end > begin && next < entries.size();
    if (wholeWord && oneWord && entries[next] == ';')
    {
      entries.replace(begin, end - begin, value);
      return;
    }
  }
}

}

const std::vector<std::string>& foamTypes()
{
  static const std::vector<std::string> types = { "patch", "wall", "symmetry", "symmetryPlane",
    "empty" };
  return types;
}

std::string foamWord(const std::string& name)
{
  std::string word = name;
  std::replace_if(
    word.begin(), word.end(),
    [](unsigned char c) { return c < 128 && !std::isalnum(c) && !std::strchr("_-.:", c); }, '_');
  // A word that starts like a number might be read as one.
  return word.empty() || std::strchr("-.:0123456789", word[0]) ? "_" + word : word;
}

FoamBoundary::FoamBoundary(const std::vector<FoamPatch>& patches)
{
  patches_.reserve(patches.size());
  for (const FoamPatch& patch : patches)
  {
    patches_.push_back({ patch.name, newEntries(patch.name) });
  }
}

FoamBoundary::FoamBoundary(const std::filesystem::path& path)
{
  std::ifstream file(path);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  std::vector<Patch> found;
  std::size_t at = text.find("\n(\n");
  at = at == std::string::npos ? at : text.find_first_not_of(Blank, at + 3);
  while (at != std::string::npos && text[at] != ')')
  {
    const std::size_t open = text.find_first_of("{}()", at);
    const std::size_t close = text.find_first_of("{}", open == std::string::npos ? open : open + 1);
    if (close == std::string::npos || text[open] != '{' || text[close] != '}')
    {
      return;
    }
    found.push_back({ text.substr(at, text.find_first_of(" \t\r\n{", at) - at),
      text.substr(open + 1, close - open - 1) });
    at = text.find_first_not_of(Blank, close + 1);
  }
  if (at != std::string::npos && text.find_first_not_of(Blank, at + 1) == std::string::npos)
  {
    patches_ = std::move(found);
  }
}

bool FoamBoundary::hasNamesOf(const std::vector<FoamPatch>& patches) const
{
  return std::equal(patches_.begin(), patches_.end(), patches.begin(), patches.end(),
    [](const Patch& a, const FoamPatch& b) { return a.name == b.name; });
}

std::string FoamBoundary::text(const std::vector<FoamPatch>& patches, std::size_t start) const
{
  std::string result = std::to_string(patches_.size()) + "\n(\n";
  for (std::size_t i = 0; i < patches_.size(); ++i)
  {
    std::string entries = patches_[i].entries;
    setEntry(entries, "nFaces", std::to_string(patches[i].count));
    setEntry(entries, "startFace", std::to_string(start));
    if (!patches[i].type.empty())
    {
      setEntry(entries, "type", patches[i].type);
    }
    result += "    " + patches_[i].name + "\n    {" + entries + "}\n";
    start += patches[i].count;
  }
  return result + ")\n";
}

}

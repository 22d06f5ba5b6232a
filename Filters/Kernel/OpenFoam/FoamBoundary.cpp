// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FoamBoundary.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

namespace cartesian
{

namespace
{

constexpr const char* Blank = " \t\r\n";
constexpr const char* EndOfWord = " \t\r\n;";

std::string entry(const std::string& key, const std::string& value)
{
  return "\n        " + key + std::string(key.size() < 16 ? 16 - key.size() : 1, ' ') + value + ";";
}

std::string vectorText(const Vector& v)
{
  std::array<char, 96> text;
  std::snprintf(text.data(), text.size(), "(%.17g %.17g %.17g)", v[0], v[1], v[2]);
  return text.data();
}

// Periodic, where the patch has a type; else both have the same place.
std::string pairEntries(const FoamPatch& patch)
{
  const SideMotion& motion = patch.motion;
  const std::string type = patch.type.empty() ? "cyclicAMI" : patch.type;
  return entry("inGroups", "1(" + type + ")") + entry("matchTolerance", "0.0001") +
    (patch.type.empty() ? entry("transform", "noOrdering")
        : motion.angle != 0
        ? entry("transform", "rotational") + entry("rotationAxis", vectorText(motion.axis)) +
          entry("rotationCentre", vectorText(motion.centre))
        : entry("transform", "translational") +
          entry("separationVector", vectorText(motion.translation))) +
    entry("neighbourPatch", patch.partner);
}

std::string newEntries(const FoamPatch& patch)
{
  const bool isMapped = !patch.sample.region.empty();
  const bool isShared = patch.processes.other >= 0;
  const bool isCoupled = !patch.partner.empty();
  std::string text = entry("type",
                       isMapped                  ? "mappedWall"
                         : isShared              ? "processor"
                         : !patch.type.empty()   ? patch.type
                         : isCoupled             ? "cyclicAMI"
                         : isOpening(patch.name) ? "patch"
                                                 : "wall") +
    entry("nFaces", "0") + entry("startFace", "0");
  if (isMapped)
  {
    text += entry("sampleMode", "nearestPatchFace") + entry("sampleRegion", patch.sample.region) +
      entry("samplePatch", patch.sample.patch);
  }
  if (isCoupled)
  {
    text += pairEntries(patch);
  }
  if (isShared)
  {
    text += entry("inGroups", "1(processor)") + entry("matchTolerance", "0.0001") +
      entry("transform", "unknown") + entry("myProcNo", std::to_string(patch.processes.own)) +
      entry("neighbProcNo", std::to_string(patch.processes.other));
  }
  return text + "\n    ";
}

// `word` is in lower case; the name may be in any.
bool beginsWith(const std::string& name, const std::string& word)
{
  return name.size() >= word.size() &&
    std::equal(word.begin(), word.end(), name.begin(),
      [](char a, unsigned char b) { return a == static_cast<char>(std::tolower(b)); });
}

// Where the value of the entry `key` is; of length 0: nowhere.
struct Place
{
  std::size_t at;
  std::size_t length;
};

Place findEntry(const std::string& entries, const std::string& key)
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
      return { begin, end - begin };
    }
  }
  return { 0, 0 };
}

void setEntry(std::string& entries, const std::string& key, const std::string& value)
{
  const Place place = findEntry(entries, key);
  if (place.length > 0)
  {
    entries.replace(place.at, place.length, value);
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
  if (word.size() > LongestWord)
  {
    std::size_t end = LongestWord;
    while (end > 0 && (static_cast<unsigned char>(word[end]) & 0xc0) == 0x80)
    {
      --end; // not within a character of UTF-8
    }
    word.resize(end);
  }
  std::replace_if(
    word.begin(), word.end(),
    [](unsigned char c) { return c < 128 && !std::isalnum(c) && !std::strchr("_-.:", c); }, '_');
  // A word that starts like a number might be read as one.
  return word.empty() || std::strchr("-.:0123456789", word[0]) ? "_" + word : word;
}

bool isOpening(const std::string& name)
{
  return beginsWith(name, "inlet") || beginsWith(name, "outlet") || beginsWith(name, "cyclic");
}

bool isSymmetry(const std::string& name)
{
  return beginsWith(name, "symmetry");
}

BoundaryKind kindOf(const FoamPatch& patch)
{
  if (patch.type.empty() ? isSymmetry(patch.name) : patch.type.rfind("symmetry", 0) == 0)
  {
    return BoundaryKind::Symmetry;
  }
  if (patch.type == "wall" || (patch.type.empty() && !isOpening(patch.name)))
  {
    return BoundaryKind::Wall;
  }
  return beginsWith(patch.name, "inlet") ? BoundaryKind::Inlet
    : beginsWith(patch.name, "outlet")   ? BoundaryKind::Outlet
                                         : BoundaryKind::Opening;
}

bool isFluid(const std::string& region, const std::vector<FoamPatch>& patches)
{
  const bool hasOpening = std::any_of(patches.begin(), patches.end(), [](const FoamPatch& patch) {
    return patch.type.empty() ? isOpening(patch.name)
                              : patch.type == "patch" || patch.type.rfind("cyclic", 0) == 0;
  });
  return beginsWith(region, "fluid") || (hasOpening && !beginsWith(region, "solid"));
}

FoamBoundary::FoamBoundary(const std::vector<FoamPatch>& patches)
{
  patches_.reserve(patches.size());
  for (const FoamPatch& patch : patches)
  {
    patches_.push_back({ patch.name, newEntries(patch) });
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

std::vector<FoamPatch> FoamBoundary::typed(const std::vector<FoamPatch>& patches) const
{
  std::vector<FoamPatch> result = patches;
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    const Place place = findEntry(patches_[i].entries, "type");
    if (result[i].type.empty())
    {
      result[i].type = patches_[i].entries.substr(place.at, place.length);
    }
  }
  return result;
}

std::string FoamBoundary::text(const std::vector<FoamPatch>& patches, std::size_t start) const
{
  std::string result = std::to_string(patches_.size()) + "\n(\n";
  for (std::size_t i = 0; i < patches_.size(); ++i)
  {
    const bool isPeriodic = !patches[i].type.empty() && !patches[i].partner.empty();
    std::string entries = isPeriodic ? newEntries(patches[i]) : patches_[i].entries;
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

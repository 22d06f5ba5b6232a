// SPDX-License-Identifier: BSD-3-Clause
#include "CadNames.h"

#include "CadEdges.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// What SolidWorks calls a face without a name.
bool isNone(const std::string& name)
{
  return name.empty() || name == "NONE" || name == "None" || name == "none";
}

// F1, F2 and the like, by which I-DEAS and others count faces.
bool isCounter(const std::string& name)
{
  const auto digits =
    std::find_if(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  const bool isNumber = digits != name.end() &&
    std::all_of(digits, name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  std::string word(name.begin(), digits);
  std::transform(
    word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  word.erase(word.find_last_not_of(" _-#") + 1);
  return isNumber && (word.empty() || word == "f" || word == "face");
}

std::set<std::string> distinct(
  const std::vector<CadPart>& parts, std::string FaceAttributes::*which)
{
  std::set<std::string> values;
  for (const CadPart& part : parts)
  {
    for (const FaceAttributes& face : part.faces)
    {
      values.insert(face.*which);
    }
  }
  return values;
}

CadNames chosenFor(const std::vector<CadPart>& parts)
{
  const std::set<std::string> names = distinct(parts, &FaceAttributes::name);
  const auto tells = [](const std::string& name) { return !isNone(name) && !isCounter(name); };
  if (names.size() > 1 && std::any_of(names.begin(), names.end(), tells))
  {
    return CadNames::Faces;
  }
  return distinct(parts, &FaceAttributes::color).size() > 1 ? CadNames::Colors
                                                            : CadNames::TangentGroups;
}

// Names of faces, in order of the parts. A face that two of them share has the name that it has in the first.
class Namer
{
public:
  explicit Namer(const std::vector<CadPart>& parts)
    : parts_(parts)
  {
    for (const CadPart& part : parts)
    {
      faces_.push_back(facesOf(part.shape));
    }
  }

  // `nameOf`: of a part's face, by their numbers.
  CadBoundaries named(const std::function<std::string(std::size_t, std::size_t)>& nameOf)
  {
    CadBoundaries boundaries;
    std::map<std::string, std::int32_t> numbers;
    TopTools_IndexedMapOfShape known;
    std::vector<std::int32_t> ofKnown;
    for (std::size_t p = 0; p < parts_.size(); ++p)
    {
      std::vector<std::int32_t>& ofFace = boundaries.ofFace.emplace_back();
      for (std::size_t f = 0; f < parts_[p].faces.size(); ++f)
      {
        const auto face = static_cast<std::size_t>(known.Add(faces_[p](static_cast<int>(f) + 1)));
        if (face <= ofKnown.size())
        {
          ofFace.push_back(ofKnown[face - 1]);
          continue;
        }
        const std::string name = nameOf(p, f);
        const auto [place, isNew] =
          numbers.emplace(name, static_cast<std::int32_t>(numbers.size()));
        if (isNew)
        {
          boundaries.names.push_back(name);
        }
        ofFace.push_back(place->second);
        ofKnown.push_back(place->second);
      }
    }
    return boundaries;
  }

  // Parts in which faces have that name.
  std::map<std::string, std::vector<std::size_t>> partsOfNames() const
  {
    std::map<std::string, std::vector<std::size_t>> of;
    TopTools_IndexedMapOfShape known;
    for (std::size_t p = 0; p < parts_.size(); ++p)
    {
      for (std::size_t f = 0; f < parts_[p].faces.size(); ++f)
      {
        std::vector<std::size_t>& having = of[parts_[p].faces[f].name];
        const int before = known.Extent();
        const bool isNew = known.Add(faces_[p](static_cast<int>(f) + 1)) > before;
        if (isNew && (having.empty() || having.back() != p))
        {
          having.push_back(p);
        }
      }
    }
    return of;
  }

private:
  const std::vector<CadPart>& parts_;
  std::vector<TopTools_IndexedMapOfShape> faces_;
};

CadBoundaries byFaces(const std::vector<CadPart>& parts)
{
  Namer namer(parts);
  const std::map<std::string, std::vector<std::size_t>> of = namer.partsOfNames();
  return namer.named([&](std::size_t p, std::size_t f) {
    const std::string& name = parts[p].faces[f].name;
    if (isNone(name))
    {
      return parts[p].name;
    }
    const std::vector<std::size_t>& having = of.at(name);
    const auto place = std::lower_bound(having.begin(), having.end(), p) - having.begin();
    return having.size() == 1 ? name : name + "_" + std::to_string(place + 1);
  });
}

CadBoundaries byGroups(const std::vector<CadPart>& parts)
{
  std::vector<std::vector<int>> groups;
  groups.reserve(parts.size());
  for (const CadPart& part : parts)
  {
    groups.push_back(CadEdges(part.shape).tangentGroups(part.shape));
  }
  return Namer(parts).named([&](std::size_t p, std::size_t f) {
    const bool isOne = *std::max_element(groups[p].begin(), groups[p].end()) == 0;
    return isOne ? parts[p].name : parts[p].name + "_" + std::to_string(groups[p][f] + 1);
  });
}

// Whether the assembly tells instances apart, by names that no other solid has.
bool instancesDiffer(const std::vector<CadPart*>& parts, const std::set<std::string>& taken)
{
  std::set<std::string> names;
  for (const CadPart* part : parts)
  {
    if (isNumbered(part->instance) || taken.count(part->instance) > 0 ||
      !names.insert(part->instance).second)
    {
      return false;
    }
  }
  return true;
}

// Beside a solid of their name, sheets have another.
void nameSheets(std::vector<CadPart>& parts)
{
  const auto isSolid = [](const CadPart& part) { return part.shape.ShapeType() == TopAbs_SOLID; };
  std::set<std::string> ofSolids;
  for (const CadPart& part : parts)
  {
    if (isSolid(part))
    {
      ofSolids.insert(part.name);
    }
  }
  for (CadPart& part : parts)
  {
    part.name += !isSolid(part) && ofSolids.count(part.name) > 0 ? "_sheet" : "";
  }
}

}

bool isNumbered(const std::string& instance)
{
  const std::string digits = instance.rfind("NAUO", 0) == 0 ? instance.substr(4) : instance;
  return std::all_of(
    digits.begin(), digits.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

void numberAlike(std::vector<CadPart>& parts, const std::string& other)
{
  for (CadPart& part : parts)
  {
    part.name = part.name.empty() ? other : part.name;
  }
  nameSheets(parts);
  std::map<std::string, std::vector<CadPart*>> alike;
  std::set<std::string> taken;
  for (CadPart& part : parts)
  {
    alike[part.name].push_back(&part);
    taken.insert(part.name);
  }
  for (auto& [name, having] : alike)
  {
    if (having.size() == 1)
    {
      continue;
    }
    const bool areTold = instancesDiffer(having, taken);
    int number = 0;
    for (CadPart* part : having)
    {
      do
      {
        part->name = areTold ? part->instance : name + "_" + std::to_string(++number);
      } while (!taken.insert(part->name).second);
    }
  }
}

CadBoundaries boundariesOf(
  const std::vector<CadPart>& parts, CadNames from, const CadReport& report)
{
  const CadNames chosen = from == CadNames::Automatic ? chosenFor(parts) : from;
  const auto orPart = [&](const std::string& name, std::size_t p) {
    return name.empty() ? parts[p].name : name;
  };
  switch (chosen)
  {
    case CadNames::Faces:
      report.note("Boundaries: by the names of faces.");
      return byFaces(parts);
    case CadNames::Colors:
      report.note("Boundaries: by colours.");
      return Namer(parts).named(
        [&](std::size_t p, std::size_t f) { return orPart(parts[p].faces[f].color, p); });
    case CadNames::Layers:
      report.note("Boundaries: by layers.");
      return Namer(parts).named(
        [&](std::size_t p, std::size_t f) { return orPart(parts[p].faces[f].layer, p); });
    case CadNames::Solids:
      report.note("Boundaries: by solids.");
      return Namer(parts).named([&](std::size_t p, std::size_t /*f*/) { return parts[p].name; });
    default:
      report.note("Boundaries: groups of tangent faces.");
      return byGroups(parts);
  }
}

}

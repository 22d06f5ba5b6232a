// SPDX-License-Identifier: BSD-3-Clause
#include "CategoryColours.h"

#include "Base/Palette.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

namespace cartesian
{

namespace
{

// CellsLeftOut: cells left out.
std::string inWords(const std::string& name)
{
  std::string words;
  for (const char c : name)
  {
    words += std::isupper(c) != 0 && !words.empty() ? " " : "";
    words += static_cast<char>(std::tolower(c));
  }
  return words;
}

// The names of the sides of the box through which one looks at the bodies, if a source meshes the space around these: the outline
// shows the box. On ground and plane of symmetry the mesh is seen behind them.
std::set<std::string> sidesOf(vtkSMProxy* source)
{
  if (!source->GetProperty("Domain") || vtkSMPropertyHelper(source, "Domain").GetAsInt() != 1)
  {
    return {};
  }
  return vtkSMPropertyHelper(source, "SideNames").GetAsInt() == 0
    ? std::set<std::string>{ "xMin", "xMax", "yMin", "yMax", "zMin", "zMax" }
    : std::set<std::string>{ "inlet", "outlet", "sides" };
}

// That of a name RRGGBB, which a boundary has by its colour in a CAD file.
std::optional<Colour> colourCalled(const std::string& name)
{
  constexpr std::size_t Digits = 6;
  const auto isDigit = [](unsigned char c) { return std::isxdigit(c) != 0; };
  if (name.size() != Digits || !std::all_of(name.begin(), name.end(), isDigit))
  {
    return std::nullopt;
  }
  Colour rgb;
  for (std::size_t c = 0; c < rgb.size(); ++c)
  {
    rgb[c] = std::stoi(name.substr(2 * c, 2), nullptr, 16) / 255.0;
  }
  return rgb;
}

// Defects are the brightest of all.
Colour colour(std::size_t i, bool isDefect)
{
  constexpr double GoldenRatio = 0.618034;
  const double turns = GoldenRatio * static_cast<double>(i);
  return isDefect ? colourOfHue(turns - std::floor(turns), 1, 1) : colourOfBoundary(i);
}

// That of the n-th category, unless another has it since categories went: then the first that is free.
Colour newColour(const vtkSMPropertyHelper& indexed, unsigned int n, bool areDefects)
{
  constexpr double Alike = 1e-3; // ParaView rounds them
  const auto isFree = [&](const Colour& rgb) {
    bool isNew = true;
    for (unsigned int i = 0; i < n; ++i)
    {
      bool isSame = true;
      for (unsigned int c = 0; c < 3; ++c)
      {
        isSame = isSame && std::abs(indexed.GetAsDouble(3 * i + c) - rgb[c]) < Alike;
      }
      isNew = isNew && !isSame;
    }
    return isNew;
  };
  std::size_t k = isFree(colour(n, areDefects)) ? n : 0;
  while (k < n && !isFree(colour(k, areDefects)))
  {
    ++k;
  }
  return colour(k, areDefects);
}

}

std::string nameOfColours(const std::string& array)
{
  return array + ".PVLookupTable";
}

std::vector<Category> categoriesOf(vtkSMProxy* source, const std::string& array)
{
  source->UpdatePropertyInformation(source->GetProperty("LegendInfo"));
  const vtkSMPropertyHelper entries(source, "LegendInfo", true);
  std::vector<Category> categories;
  for (unsigned int i = 0; i + 1 < entries.GetNumberOfElements(); i += 2)
  {
    const std::string entry = entries.GetAsString(i);
    if (entry.compare(0, array.size() + 1, array + "/") == 0)
    {
      const std::string rest = entry.substr(array.size() + 1);
      const std::size_t slash = rest.find('/');
      const bool hasName = array == Regions && slash != std::string::npos;
      const std::string value = hasName ? rest.substr(0, slash) : rest;
      categories.push_back({ value,
        hasName              ? rest.substr(slash + 1)
          : array == Defects ? inWords(value)
                             : value });
    }
  }
  return categories;
}

void addCategories(vtkSMProxy* colours, vtkSMProxy* source, const std::string& array)
{
  const std::set<std::string> sides = sidesOf(source);
  vtkSMPropertyHelper annotations(colours, "Annotations");
  vtkSMPropertyHelper indexed(colours, "IndexedColors");
  vtkSMPropertyHelper opacities(colours, "IndexedOpacities", true);
  std::vector<std::string> known;
  for (unsigned int i = 0; i + 1 < annotations.GetNumberOfElements(); i += 2)
  {
    known.emplace_back(annotations.GetAsString(i));
  }
  for (auto n = opacities.GetNumberOfElements(); n < known.size(); ++n)
  {
    opacities.Set(n, 1); // ParaView's own have none
  }
  bool hasSides = false;
  for (const Category& category : categoriesOf(source, array))
  {
    const auto found = std::find(known.begin(), known.end(), category.value);
    if (found != known.end())
    {
      annotations.Set(
        static_cast<unsigned int>(2 * (found - known.begin()) + 1), category.name.c_str());
      continue;
    }
    const auto n = static_cast<unsigned int>(known.size());
    annotations.Set(2 * n, category.value.c_str());
    annotations.Set(2 * n + 1, category.name.c_str());
    const Colour rgb =
      colourCalled(category.name).value_or(newColour(indexed, n, array == Defects));
    for (unsigned int c = 0; c < 3; ++c)
    {
      indexed.Set(3 * n + c, rgb[c]);
    }
    const bool side = sides.count(category.value) == 1;
    hasSides = hasSides || side;
    opacities.Set(n, side ? 0 : 1);
    known.push_back(category.value);
  }
  vtkSMPropertyHelper(colours, "IndexedLookup").Set(1);
  vtkSMPropertyHelper(colours, "AnnotationsInitialized", true).Set(1);
  if (hasSides)
  {
    vtkSMPropertyHelper(colours, "EnableOpacityMapping").Set(1);
  }
  colours->UpdateVTKObjects();
}

void removeCategories(vtkSMProxy* colours, const std::set<std::string>& gone)
{
  vtkSMPropertyHelper annotations(colours, "Annotations");
  vtkSMPropertyHelper indexed(colours, "IndexedColors");
  vtkSMPropertyHelper opacities(colours, "IndexedOpacities", true);
  unsigned int kept = 0;
  const unsigned int all = annotations.GetNumberOfElements() / 2;
  for (unsigned int i = 0; i < all; ++i)
  {
    if (gone.count(annotations.GetAsString(2 * i)) == 1)
    {
      continue;
    }
    for (unsigned int k = 0; k < 2 && kept < i; ++k)
    {
      annotations.Set(2 * kept + k, std::string(annotations.GetAsString(2 * i + k)).c_str());
    }
    for (unsigned int c = 0; c < 3; ++c)
    {
      indexed.Set(3 * kept + c, indexed.GetAsDouble(3 * i + c));
    }
    opacities.Set(kept, i < opacities.GetNumberOfElements() ? opacities.GetAsDouble(i) : 1);
    ++kept;
  }
  annotations.SetNumberOfElements(2 * kept);
  indexed.SetNumberOfElements(3 * kept);
  opacities.SetNumberOfElements(kept);
  colours->UpdateVTKObjects();
}

}

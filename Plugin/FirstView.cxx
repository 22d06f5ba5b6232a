// SPDX-License-Identifier: BSD-3-Clause
#include "FirstView.h"

#include "Base/Palette.h"
#include "Base/Words.h"
#include "PortHints.h"
#include "Quality/QualityMeasures.h"
#include "Registration.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cartesian
{

namespace
{

constexpr double LineWidthOfDefects = 4;
constexpr double ColourOfEdges = 0.25;

// Of a legend: with more names than MostNames it has none, as they would hide the view.
constexpr unsigned int MostLargeNames = 8;
constexpr unsigned int MostNames = 24;
constexpr int SmallFont = 12;
constexpr double LongLegend = 0.5; // of the view

constexpr const char* Boundaries = "BoundaryName";
constexpr const char* Defects = "DefectName";
constexpr const char* Regions = "Region";
constexpr const char* Interfaces = "InterfaceName";
constexpr std::array<const char*, 4> Arrays{ Boundaries, Defects, Regions, Interfaces };

struct Category
{
  std::string value;
  std::string name;
};

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

// The entries "array/value" or "array/value/name" of a property LegendInfo.
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

// As vtkSMTransferFunctionManager names them.
constexpr const char* ColoursGroup = "lookup_tables";

std::string nameOfColours(const char* array)
{
  return std::string(array) + ".PVLookupTable";
}

vtkSMProxy* coloursOf(const std::string& array, vtkSMSessionProxyManager* proxies)
{
  return vtkNew<vtkSMTransferFunctionManager>()->GetColorTransferFunction(array.c_str(), proxies);
}

// The window's editor of colours does not survive those without an opacity function, as older states have them.
void completeColours(vtkSMProxy* colours)
{
  vtkSMSessionProxyManager* proxies = colours->GetSessionProxyManager();
  const char* name = proxies->GetProxyName(ColoursGroup, colours);
  const auto* array = std::find_if(std::begin(Arrays), std::end(Arrays),
    [&](const char* known) { return name && nameOfColours(known) == name; });
  vtkSMPropertyHelper opacity(colours, "ScalarOpacityFunction");
  if (array != std::end(Arrays) && !opacity.GetAsProxy())
  {
    opacity.Set(
      vtkNew<vtkSMTransferFunctionManager>()->GetOpacityTransferFunction(*array, proxies));
    colours->UpdateVTKObjects();
  }
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

// Two meshes share the colours of an array: those that are not there yet are added, and names are the last ones.
void addCategories(vtkSMProxy* colours, const std::vector<Category>& categories,
  const std::set<std::string>& sides = {}, bool areDefects = false)
{
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
  for (const Category& category : categories)
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
    const Colour rgb = colourCalled(category.name).value_or(newColour(indexed, n, areDefects));
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

// Values of an array that any source has now.
std::set<std::string> valuesOfAll(const std::string& array, vtkSMSessionProxyManager* proxies)
{
  std::set<std::string> values;
  vtkNew<vtkSMProxyIterator> sources;
  sources->SetSessionProxyManager(proxies);
  sources->SetModeToOneGroup();
  for (sources->Begin("sources"); !sources->IsAtEnd(); sources->Next())
  {
    if (sources->GetProxy()->GetProperty("LegendInfo"))
    {
      for (const Category& category : categoriesOf(sources->GetProxy(), array))
      {
        values.insert(category.value);
      }
    }
  }
  return values;
}

// The colours of others stay as they are.
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

void set(vtkSMProxy* representation, const char* property, double value)
{
  vtkSMPropertyHelper(representation, property, true).Set(value);
}

// In a corner, where it hides little.
void prepareText(vtkSMProxy* representation)
{
  vtkSMPropertyHelper(representation, "WindowLocation", true).Set("Upper Left Corner");
  vtkSMPropertyHelper(representation, "Justification", true).Set("Left");
  set(representation, "FontSize", SmallFont);
  representation->UpdateVTKObjects();
}

void prepareColours(vtkSMProxy* representation, vtkSMSourceProxy* source, const std::string& array)
{
  vtkSMSessionProxyManager* proxies = representation->GetSessionProxyManager();
  const std::vector<Category> regions = categoriesOf(source, Regions);
  if (regions.size() > 1)
  {
    addCategories(coloursOf(Regions, proxies), regions);
  }
  const bool areDefects = array == Defects;
  const std::vector<Category> categories = categoriesOf(source, array);
  const std::size_t fewest = array == Boundaries ? 2 : 1;
  const bool hasColours = categories.size() >= fewest;
  if (hasColours)
  {
    addCategories(coloursOf(array, proxies), categories, sidesOf(source), areDefects);
  }
  vtkSMPropertyHelper(representation, "ColorArrayName", true)
    .SetInputArrayToProcess(vtkDataObject::CELL, hasColours ? array.c_str() : "");
  const std::vector<double> edges(3, ColourOfEdges);
  vtkSMPropertyHelper(representation, "EdgeColor", true).Set(edges.data(), 3);
  if (areDefects)
  {
    set(representation, "LineWidth", LineWidthOfDefects);
  }
  representation->UpdateVTKObjects();
}

void prepare(vtkSMProxy* representation)
{
  const auto [source, port] = inputOf(representation);
  if (!source)
  {
    return;
  }
  if (vtkPVXMLElement* hint = hintOf(source, port, "Colours"))
  {
    prepareColours(representation, source, hint->GetAttribute("array"));
  }
  if (hintOf(source, port, "SmallText"))
  {
    prepareText(representation);
  }
}

bool isMeasure(const std::string& array)
{
  return array == "RefinementLevel" ||
    std::any_of(MeasureSpecs.begin(), MeasureSpecs.end(),
      [&](const MeasureSpec& spec) { return array == spec.name; });
}

// In words; BoundaryName: Boundary.
std::string titleOf(const std::string& array)
{
  return wordsOf(array.substr(0, array.rfind("Name")));
}

// A legend of names: small where there are many.
void prepareLegend(vtkSMProxy* legend)
{
  vtkSMProxy* colours = vtkSMPropertyHelper(legend, "LookupTable", true).GetAsProxy();
  vtkSMSessionProxyManager* proxies = legend->GetSessionProxyManager();
  const bool isOurs =
    colours && std::any_of(std::begin(Arrays), std::end(Arrays), [&](const char* array) {
      return proxies->GetProxy(ColoursGroup, nameOfColours(array).c_str()) == colours;
    });
  const char* const registered = colours ? proxies->GetProxyName(ColoursGroup, colours) : nullptr;
  const std::string name = registered ? registered : "";
  const std::string array = name.substr(0, name.find('.'));
  if (isOurs || isMeasure(array))
  {
    vtkSMPropertyHelper(legend, "Title").Set(titleOf(array).c_str());
    vtkSMPropertyHelper(legend, "ComponentTitle").Set("");
    legend->UpdateVTKObjects();
  }
  const unsigned int names =
    isOurs ? vtkSMPropertyHelper(colours, "Annotations").GetNumberOfElements() / 2 : 0;
  if (names > MostLargeNames)
  {
    set(legend, "LabelFontSize", SmallFont);
    set(legend, "ScalarBarLength", LongLegend);
    set(legend, "DrawAnnotations", names > MostNames ? 0 : 1);
    legend->UpdateVTKObjects();
  }
}

// Names that a source has since it was made anew, in the legends that its names are in, and none that it had and that nothing
// has any more; and what its panel tells of its output, which ParaView asks for too early.
class Renewal : public vtkCommand
{
public:
  static Renewal* New() { return new Renewal; }

  void Execute(vtkObject* caller, unsigned long /*event*/, void* /*data*/) override
  {
    auto* source = vtkSMSourceProxy::SafeDownCast(caller);
    vtkSMSessionProxyManager* proxies = source->GetSessionProxyManager();
    for (const char* array : Arrays)
    {
      const std::set<std::string> gone = this->Gone(array, source);
      if (vtkSMProxy* colours = proxies->GetProxy(ColoursGroup, nameOfColours(array).c_str()))
      {
        removeCategories(colours, gone);
        addCategories(colours, categoriesOf(source, array), sidesOf(source), array == Defects);
      }
    }
    for (const char* told : { "FoundBoundaries", "FoundSolids", "Findings", "Made" })
    {
      if (vtkSMProperty* found = source->GetProperty(told))
      {
        source->UpdatePropertyInformation(found);
      }
    }
  }

private:
  // Values that were there before the last update.
  std::set<std::string> Gone(const std::string& array, vtkSMProxy* source)
  {
    std::set<std::string> gone;
    std::swap(gone, this->Had[array]);
    for (const Category& category : categoriesOf(source, array))
    {
      this->Had[array].insert(category.value);
    }
    for (const std::string& value : valuesOfAll(array, source->GetSessionProxyManager()))
    {
      gone.erase(value);
    }
    return gone;
  }

  std::map<std::string, std::set<std::string>> Had; // values of arrays
};

void prepareNew(vtkSMProxy* proxy, const std::string& group)
{
  if (group == "sources" && proxy->GetProperty("LegendInfo"))
  {
    proxy->AddObserver(vtkCommand::UpdateDataEvent, vtkNew<Renewal>());
  }
  if (proxy->GetSessionProxyManager()->GetInLoadXMLState())
  {
    if (group == ColoursGroup)
    {
      completeColours(proxy);
    }
    return;
  }
  if (group == "representations")
  {
    prepare(proxy);
  }
  else if (group == "scalar_bars")
  {
    prepareLegend(proxy);
  }
}

}

void watchViews()
{
  onRegistered<prepareNew>();
}

}

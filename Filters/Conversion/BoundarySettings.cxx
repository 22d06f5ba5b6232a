// SPDX-License-Identifier: BSD-3-Clause
#include "BoundarySettings.h"

#include "Base/Error.h"
#include "Base/NamePatterns.h"
#include "OpenFoam/FoamBoundary.h"

#include <algorithm>

namespace cartesian
{

namespace
{

void requireOneForEachName(
  const std::vector<std::string>& rows, std::size_t values, const std::string& property)
{
  if (values != 0 && values != rows.size())
  {
    throw Error(Fault::BadParameter,
      property + " has " + std::to_string(values) + " values, but Boundary Names has " +
        std::to_string(rows.size()) + " names: there must be one for each name, or none.");
  }
  for (const std::string& name : rows)
  {
    if (std::count(rows.begin(), rows.end(), name) > 1)
    {
      throw Error(
        Fault::BadParameter, "Boundary Names has \"" + name + "\" twice: remove one of them.");
    }
  }
}

bool isSide(std::int32_t boundary, const EndBoundaries& sides)
{
  return boundary != NoBoundary && std::find(sides.begin(), sides.end(), boundary) != sides.end();
}

// The row that counts for each boundary that has one.
std::map<std::int32_t, std::size_t> rowsOfBoundaries(
  const std::vector<std::string>& rows, const BoundaryNames& names, const EndBoundaries& sides)
{
  std::map<std::int32_t, std::size_t> found;
  for (const auto& [boundary, name] : names)
  {
    auto row = std::find(rows.begin(), rows.end(), name);
    if (row == rows.end() && !isSide(boundary, sides))
    {
      row = std::find_if(rows.begin(), rows.end(),
        [&text = name](const std::string& pattern) { return isOf(text, pattern); });
    }
    if (row != rows.end())
    {
      found.emplace(boundary, static_cast<std::size_t>(row - rows.begin()));
    }
  }
  return found;
}

void requireKnown(const std::string& row, const BoundaryNames& names, const EndBoundaries& sides)
{
  bool isKnown = false;
  std::string matched; // sides of the domain
  for (const auto& [boundary, name] : names)
  {
    const bool matches = isPattern(row) && isOf(name, row);
    isKnown = isKnown || (matches && !isSide(boundary, sides));
    matched += matches ? (matched.empty() ? "" : ", ") + name : "";
  }
  if (!isKnown && !matched.empty())
  {
    throw Error(Fault::BadParameter,
      "Boundary Names has \"" + row +
        "\", which only sides of the domain match: patterns are for boundaries of the "
        "surface. Give each side a row of its own: " +
        matched + ".");
  }
  if (!isKnown)
  {
    boundaryCalled(names, row, "Boundary Names");
  }
}

// The same if the column `property` has values; else nothing.
std::map<std::int32_t, std::size_t> rowsWith(const std::vector<std::string>& rows,
  std::size_t values, const std::string& property, const BoundaryNames& names,
  const EndBoundaries& sides)
{
  requireOneForEachName(rows, values, property);
  for (const std::string& row : rows)
  {
    requireKnown(row, names, sides);
  }
  return values == 0 ? std::map<std::int32_t, std::size_t>() : rowsOfBoundaries(rows, names, sides);
}

void checkType(const std::string& type)
{
  const std::vector<std::string>& types = foamTypes();
  if (type != BaffleType && type != ZoneType &&
    std::find(types.begin(), types.end(), type) == types.end())
  {
    std::string known = AutomaticType;
    for (const std::string& one : types)
    {
      known += ", " + one;
    }
    known += std::string(", ") + BaffleType + ", " + ZoneType;
    throw Error(
      Fault::BadParameter, "Boundary Types has \"" + type + "\": choose one of " + known + ".");
  }
}

}

BoundaryNames mergedNames(const BoundarySettings& settings, const BoundaryNames& names)
{
  requireOneForEachName(settings.names, settings.mergedNames.size(), "Boundary Merged Names");
  BoundaryNames result;
  if (settings.mergedNames.empty())
  {
    return result;
  }
  for (std::size_t row = 0; row < settings.names.size(); ++row)
  {
    if (!settings.mergedNames[row].empty())
    {
      requireKnown(settings.names[row], names, NoEnds);
    }
  }
  for (const auto& [boundary, row] : rowsOfBoundaries(settings.names, names, NoEnds))
  {
    if (!settings.mergedNames[row].empty())
    {
      result[boundary] = settings.mergedNames[row];
    }
  }
  return result;
}

BoundarySettings merged(const BoundarySettings& settings)
{
  if (settings.mergedNames.empty())
  {
    return settings;
  }
  requireOneForEachName(settings.names, settings.mergedNames.size(), "Boundary Merged Names");
  const auto copyRow = [](auto& to, const auto& from, std::size_t row) {
    if (row < from.size())
    {
      to.push_back(from[row]);
    }
  };
  BoundarySettings result;
  for (std::size_t row = 0; row < settings.names.size(); ++row)
  {
    const std::string& name =
      settings.mergedNames[row].empty() ? settings.names[row] : settings.mergedNames[row];
    if (std::find(result.names.begin(), result.names.end(), name) == result.names.end())
    {
      result.names.push_back(name);
      copyRow(result.types, settings.types, row);
      copyRow(result.ratios, settings.ratios, row);
      copyRow(result.layers, settings.layers, row);
      copyRow(result.depths, settings.depths, row);
    }
  }
  return result;
}

std::map<std::int32_t, std::string> boundaryTypes(
  const BoundarySettings& settings, const BoundaryNames& names, const EndBoundaries& sides)
{
  std::map<std::int32_t, std::string> types;
  for (const auto& [boundary, row] :
    rowsWith(settings.names, settings.types.size(), "Boundary Types", names, sides))
  {
    if (settings.types[row] != AutomaticType)
    {
      checkType(settings.types[row]);
      types[boundary] = settings.types[row];
    }
  }
  return types;
}

std::vector<BoundaryRatio> boundaryRatios(const BoundarySettings& settings,
  const BoundaryNames& names, const EndBoundaries& sides, SmallCells handling)
{
  std::map<std::int32_t, double> ratios;
  const std::map<std::int32_t, std::string> types = boundaryTypes(settings, names, sides);
  for (const auto& [boundary, name] : names)
  {
    const auto type = types.find(boundary);
    const bool opens = type == types.end() ? isOpening(name) : type->second == "patch";
    if (opens && handling == SmallCells::Remove)
    {
      ratios[boundary] = OpeningRatio;
    }
  }
  for (const auto& [boundary, row] :
    rowsWith(settings.names, settings.ratios.size(), "Boundary Small Cell Ratios", names, sides))
  {
    if (settings.ratios[row] >= 0)
    {
      ratios[boundary] = settings.ratios[row];
    }
  }
  std::vector<BoundaryRatio> result;
  result.reserve(ratios.size());
  for (const auto& [boundary, ratio] : ratios)
  {
    result.push_back({ boundary, ratio });
  }
  return result;
}

std::map<std::int32_t, int> boundaryDepths(
  const BoundarySettings& settings, const BoundaryNames& names, const EndBoundaries& sides)
{
  std::map<std::int32_t, int> depths;
  for (const auto& [boundary, row] :
    rowsWith(settings.names, settings.depths.size(), "Boundary Depths", names, sides))
  {
    if (settings.depths[row] >= 0)
    {
      depths[boundary] = settings.depths[row];
    }
  }
  return depths;
}

std::set<std::int32_t> baffleBoundaries(
  const BoundarySettings& settings, const BoundaryNames& names)
{
  std::set<std::int32_t> found;
  for (const auto& [boundary, row] : rowsOfBoundaries(settings.names, names, NoEnds))
  {
    if (row < settings.types.size() && settings.types[row] == BaffleType)
    {
      found.insert(boundary);
    }
  }
  return found;
}

std::vector<std::int32_t> layerRegions(
  const std::vector<std::string>& asked, const std::vector<std::string>& regions)
{
  std::vector<std::int32_t> found;
  for (const std::string& name : asked)
  {
    const auto at = std::find(regions.begin(), regions.end(), name);
    if (at == regions.end())
    {
      std::string known;
      for (const std::string& region : regions)
      {
        known += (known.empty() ? "" : ", ") + region;
      }
      throw Error(Fault::BadParameter,
        "Layer Regions has \"" + name + "\", which is not a region: " +
          (known.empty() ? "there is only one, without a name. Leave Layer Regions empty."
                         : "choose from " + known + "."));
    }
    found.push_back(FirstRegion + static_cast<std::int32_t>(at - regions.begin()));
  }
  return found;
}

std::vector<WallLayerSpec::OfBoundary> boundaryLayers(
  const BoundarySettings& settings, const BoundaryNames& names, const EndBoundaries& sides)
{
  const std::map<std::int32_t, std::string> types = boundaryTypes(settings, names, sides);
  std::vector<WallLayerSpec::OfBoundary> result;
  for (const auto& [boundary, row] :
    rowsWith(settings.names, settings.layers.size(), "Boundary Layers Thickness", names, sides))
  {
    if (settings.layers[row] >= 0)
    {
      result.push_back({ boundary, settings.layers[row] });
    }
  }
  for (const auto& [boundary, name] : names)
  {
    const auto type = types.find(boundary);
    if (type == types.end() ? isOpening(name) || isSymmetry(name) : type->second != "wall")
    {
      result.push_back({ boundary, 0 });
    }
  }
  return result;
}

}

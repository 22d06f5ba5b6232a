// SPDX-License-Identifier: BSD-3-Clause
#include "BoundarySettings.h"

#include "Base/Error.h"
#include "OpenFoam/FoamBoundary.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// The number of the boundary in each row, if the column `property` has values; else nothing.
std::vector<std::int32_t> numbersOf(const std::vector<std::string>& rows, std::size_t values,
  const std::string& property, const BoundaryNames& names)
{
  if (values != 0 && values != rows.size())
  {
    throw Error(Fault::BadParameter,
      property + " has " + std::to_string(values) + " values, but Boundary Names has " +
        std::to_string(rows.size()) + " names: there must be one for each name, or none.");
  }
  std::vector<std::int32_t> numbers;
  for (const std::string& name : rows)
  {
    if (std::count(rows.begin(), rows.end(), name) > 1)
    {
      throw Error(Fault::BadParameter, "Boundary Names has \"" + name + "\" twice.");
    }
    numbers.push_back(boundaryCalled(names, name, "Boundary Names"));
  }
  numbers.resize(values);
  return numbers;
}

void checkType(const std::string& type)
{
  const std::vector<std::string>& types = foamTypes();
  if (type != BaffleType && std::find(types.begin(), types.end(), type) == types.end())
  {
    std::string known = AutomaticType;
    for (const std::string& one : types)
    {
      known += ", " + one;
    }
    known += std::string(", ") + BaffleType;
    throw Error(
      Fault::BadParameter, "Boundary Types has \"" + type + "\", which is none of " + known + ".");
  }
}

}

std::map<std::int32_t, std::string> boundaryTypes(
  const BoundarySettings& settings, const BoundaryNames& names)
{
  const auto numbers = numbersOf(settings.names, settings.types.size(), "Boundary Types", names);
  std::map<std::int32_t, std::string> types;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (settings.types[i] != AutomaticType)
    {
      checkType(settings.types[i]);
      types[numbers[i]] = settings.types[i];
    }
  }
  return types;
}

std::vector<BoundaryRatio> boundaryRatios(
  const BoundarySettings& settings, const BoundaryNames& names, SmallCells handling)
{
  std::map<std::int32_t, double> ratios;
  const std::map<std::int32_t, std::string> types = boundaryTypes(settings, names);
  for (const auto& [boundary, name] : names)
  {
    const auto type = types.find(boundary);
    const bool opens = type == types.end() ? isOpening(name) : type->second == "patch";
    if (opens && handling == SmallCells::Remove)
    {
      ratios[boundary] = OpeningRatio;
    }
  }
  const auto numbers =
    numbersOf(settings.names, settings.ratios.size(), "Boundary Small Cell Ratios", names);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    ratios[numbers[i]] = settings.ratios[i];
  }
  std::vector<BoundaryRatio> result;
  result.reserve(ratios.size());
  for (const auto& [boundary, ratio] : ratios)
  {
    result.push_back({ boundary, ratio });
  }
  return result;
}

std::vector<WallLayerSpec::OfBoundary> boundaryLayers(
  const BoundarySettings& settings, const BoundaryNames& names)
{
  const std::map<std::int32_t, std::string> types = boundaryTypes(settings, names);
  const auto numbers =
    numbersOf(settings.names, settings.layers.size(), "Boundary Layers Thickness", names);
  std::vector<WallLayerSpec::OfBoundary> result;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (settings.layers[i] >= 0)
    {
      result.push_back({ numbers[i], settings.layers[i] });
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

// SPDX-License-Identifier: BSD-3-Clause
#include "CaseTables.h"

#include "Base/Error.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// In the order of the enumerations in ConditionRows.h.
const std::vector<std::string> Flows{ "automatic", "speed", "volume flow", "mass flow",
  "pressure" };
const std::vector<std::string> Heats{ "automatic", "temperature", "heat flux" };
const std::vector<std::string> Materials{ "automatic", "air", "water", "aluminium", "copper",
  "steel" };

// A column's values, row by row.
template <class Value>
class Column
{
public:
  Column(const char* name, const std::vector<Value>& values, std::size_t rows)
    : name_(name)
    , values_(values)
  {
    if (!values.empty() && values.size() != rows)
    {
      throw Error(Fault::BadParameter,
        std::string(name) + " has " + std::to_string(values.size()) + " values for " +
          std::to_string(rows) + " rows: give one for each, or none.");
    }
  }

  std::string name() const { return name_; }

  void read(std::size_t row, Value& into) const
  {
    if (!values_.empty())
    {
      into = values_[row];
    }
  }

private:
  const char* name_;
  const std::vector<Value>& values_;
};

template <class Choice>
void readChoice(const Column<std::string>& column, std::size_t row,
  const std::vector<std::string>& words, Choice& into)
{
  std::string word = words.front();
  column.read(row, word);
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end())
  {
    std::string all;
    for (const std::string& each : words)
    {
      all += (all.empty() ? "" : ", ") + each;
    }
    throw Error(
      Fault::BadParameter, column.name() + ": \"" + word + "\" is not one of " + all + ".");
  }
  into = static_cast<Choice>(found - words.begin());
}

}

std::vector<Condition> readConditions(const ConditionColumns& columns)
{
  const std::size_t count = columns.boundaries.size();
  const Column<std::string> flows("Condition Flows", columns.flows, count);
  const Column<double> flowValues("Condition Flow Values", columns.flowValues, count);
  const Column<std::string> heats("Condition Heats", columns.heats, count);
  const Column<double> heatValues("Condition Heat Values", columns.heatValues, count);
  const Column<double> intensities("Condition Turbulence Intensities", columns.intensities, count);
  const Column<double> lengths("Condition Turbulence Lengths", columns.lengths, count);
  std::vector<Condition> rows(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    rows[i].boundary = columns.boundaries[i];
    readChoice(flows, i, Flows, rows[i].flow);
    flowValues.read(i, rows[i].flowValue);
    readChoice(heats, i, Heats, rows[i].heat);
    heatValues.read(i, rows[i].heatValue);
    intensities.read(i, rows[i].intensity);
    lengths.read(i, rows[i].length);
  }
  return rows;
}

std::vector<RegionMaterial> readMaterials(const MaterialColumns& columns)
{
  const std::size_t count = columns.regions.size();
  const Column<std::string> materials("Materials", columns.materials, count);
  const Column<double> densities("Material Densities", columns.densities, count);
  const Column<double> capacities("Material Heat Capacities", columns.heatCapacities, count);
  const Column<double> conductivities("Material Conductivities", columns.conductivities, count);
  const Column<double> viscosities("Material Viscosities", columns.viscosities, count);
  const Column<double> sources("Heat Sources", columns.heatSources, count);
  std::vector<RegionMaterial> rows(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    rows[i].region = columns.regions[i];
    readChoice(materials, i, Materials, rows[i].material);
    densities.read(i, rows[i].density);
    capacities.read(i, rows[i].heatCapacity);
    conductivities.read(i, rows[i].conductivity);
    viscosities.read(i, rows[i].viscosity);
    sources.read(i, rows[i].heatSource);
  }
  return rows;
}

std::vector<Rotation> readRotations(const RotationColumns& columns)
{
  const std::size_t count = columns.zones.size();
  const Column<double> speeds("Rotation Speeds", columns.speeds, count);
  const Column<std::array<double, 3>> origins("Rotation Origins", columns.origins, count);
  const Column<std::array<double, 3>> axes("Rotation Axes", columns.axes, count);
  const Column<std::string> still("Still Boundaries", columns.stillBoundaries, count);
  std::vector<Rotation> rows(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    rows[i].zone = columns.zones[i];
    speeds.read(i, rows[i].speed);
    origins.read(i, rows[i].origin);
    axes.read(i, rows[i].axis);
    still.read(i, rows[i].stillBoundaries);
  }
  return rows;
}

}

// SPDX-License-Identifier: BSD-3-Clause
// Tables of conditions, materials and rotations, as vtkPolyMeshWriter has them: a vector for each column.
#pragma once

#include "OpenFoam/ConditionRows.h"

#include <array>
#include <vector>

namespace cartesian
{

// Columns are as long as the first, or empty: then they have the values of a row that leaves them out.
struct ConditionColumns
{
  const std::vector<std::string>& boundaries;
  const std::vector<std::string>& flows;
  const std::vector<double>& flowValues;
  const std::vector<std::string>& heats;
  const std::vector<double>& heatValues;
  const std::vector<double>& intensities;
  const std::vector<double>& lengths;
};

struct MaterialColumns
{
  const std::vector<std::string>& regions;
  const std::vector<std::string>& materials;
  const std::vector<double>& densities;
  const std::vector<double>& heatCapacities;
  const std::vector<double>& conductivities;
  const std::vector<double>& viscosities;
  const std::vector<double>& heatSources;
};

struct RotationColumns
{
  const std::vector<std::string>& zones;
  const std::vector<double>& speeds;
  const std::vector<std::array<double, 3>>& origins;
  const std::vector<std::array<double, 3>>& axes;
  const std::vector<std::string>& stillBoundaries;
};

// All throw Error (BadParameter): a column of another length, or a word that is none of the choices.
std::vector<Condition> readConditions(const ConditionColumns& columns);
std::vector<RegionMaterial> readMaterials(const MaterialColumns& columns);
std::vector<Rotation> readRotations(const RotationColumns& columns);

}

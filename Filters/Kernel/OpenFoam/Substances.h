// SPDX-License-Identifier: BSD-3-Clause
// What regions consist of: properties of common materials at 20 degrees Celsius, and those that a user gives.
#pragma once

#include "OpenFoam/SolverSetup.h"

namespace cartesian
{

struct Substance
{
  std::string name;
  bool isFluid;
  double density;      // kg/m3
  double heatCapacity; // J/(kg K)
  double conductivity; // W/(m K)
  double viscosity;    // kinematic, m2/s; of a fluid
  double prandtl;      // of a fluid
};

// Of a region of the case.
Substance substanceOf(const SolverSetup& setup, const MeshOfCase& mesh);

// Heat that comes into being in a region, W.
double heatSourceOf(const SolverSetup& setup, const MeshOfCase& mesh);

// Throws Error (BadParameter): a row for no region, two for one, a solid material in a fluid region or the other way round,
// or a number out of range.
void requireSuitableMaterials(const SolverSetup& setup, const std::vector<MeshOfCase>& meshes);

}

// SPDX-License-Identifier: BSD-3-Clause
// Entries of patches by a user's rows (ConditionRows.h).
#pragma once

#include "OpenFoam/SolverSetup.h"

namespace cartesian
{

// Of what flows in.
struct InletTurbulence
{
  double k;     // m2/s2
  double omega; // 1/s
};

// Of one mesh of a case. Entries are such as "type zeroGradient;"; none: those that the patch has without a row.
class Conditions
{
public:
  // All three must outlive it.
  Conditions(
    const SolverSetup& setup, const MeshOfCase& mesh, const std::optional<FlowAround>& around);

  std::optional<std::string> velocity(const FoamPatch& patch) const;
  std::optional<std::string> pressure(const FoamPatch& patch) const; // kinematic
  std::optional<std::string> temperature(const FoamPatch& patch) const;

  // Whether a row drives the flow into the mesh there, or the patch is an inlet without a row.
  bool flowsIn(const FoamPatch& patch) const;

  InletTurbulence turbulence(const FoamPatch& patch) const;

  // To begin with: the strongest of what flows in.
  InletTurbulence startingTurbulence() const;

private:
  const Condition& rowOf(const FoamPatch& patch) const;
  double speedOf(const FoamPatch& patch) const;
  InletTurbulence turbulenceOf(const Condition& row, double speed) const;

  const SolverSetup& setup_;
  const MeshOfCase& mesh_;
  const std::optional<FlowAround>& around_;
};

// Whether any row is about the flow through a patch of this mesh.
bool hasFlowConditions(const SolverSetup& setup, const MeshOfCase& mesh);

}

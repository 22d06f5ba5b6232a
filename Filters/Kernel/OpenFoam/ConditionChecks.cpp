// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/ConditionChecks.h"

#include "Base/Range.h"
#include "OpenFoam/Conditions.h"
#include "OpenFoam/Rows.h"

#include <algorithm>

namespace cartesian
{

namespace
{

[[noreturn]] void refuse(const FoamPatch& patch, const std::string& what, const std::string& advice)
{
  throw Error(Fault::BadParameter,
    "Conditions: boundary " + patch.name + " " + what + ". Nothing is written: " + advice + ".");
}

bool isOpen(PatchRole role)
{
  return role == PatchRole::Inlet || role == PatchRole::Outlet;
}

std::string kindOf(PatchRole role, const FoamPatch& patch)
{
  switch (role)
  {
    case PatchRole::Inlet:
      return "is an inlet";
    case PatchRole::Outlet:
      return "is an outlet";
    case PatchRole::Slip:
      return "is a side of the flow domain";
    case PatchRole::Coupled:
      return "lies between two regions";
    case PatchRole::Constraint:
      return "is of type " + patch.type;
    default:
      return "is a wall";
  }
}

bool hasTurbulence(const Condition& row)
{
  return row.intensity != -1 || row.length != -1;
}

void requireNumbers(const Condition& row)
{
  const std::string of = ": of boundary " + row.boundary;
  const auto require = [&](bool isGiven, const Range& range, double value, const char* name) {
    if (isGiven)
    {
      requireInRange(range, value, name + of);
    }
  };
  constexpr double Most = 1e30;
  require(
    row.flow != FlowCondition::ByName, { -Most, Most }, row.flowValue, "Condition Flow Values");
  require(
    row.heat == HeatCondition::Temperature, moreThan(0), row.heatValue, "Condition Heat Values");
  require(
    row.heat == HeatCondition::HeatFlux, { -Most, Most }, row.heatValue, "Condition Heat Values");
  require(
    row.intensity != -1, { 0, 1, true, false }, row.intensity, "Condition Turbulence Intensities");
  require(row.length != -1, moreThan(0), row.length, "Condition Turbulence Lengths");
}

void requireFlow(const Condition& row, PatchRole role, const FoamPatch& patch)
{
  if (isOpen(role) || row.flow == FlowCondition::ByName)
  {
    return;
  }
  refuse(patch, kindOf(role, patch) + ", through which nothing flows",
    "give it the type patch, or leave the flow out of its row");
}

void requireHeat(
  const Condition& row, PatchRole role, const FoamPatch& patch, const SolverSetup& setup)
{
  if (row.heat == HeatCondition::ByName)
  {
    return;
  }
  if (setup.solver != Solver::ConjugateHeat)
  {
    refuse(patch, "has a temperature or heat flux, but no heat is solved for",
      "set Solver Setup to Conjugate Heat, or leave heat out of its row");
  }
  if (role == PatchRole::Coupled || role == PatchRole::Constraint)
  {
    refuse(patch, kindOf(role, patch) + " and has no temperature of its own",
      "leave heat out of its row");
  }
  if (row.heat == HeatCondition::HeatFlux && isOpen(role))
  {
    refuse(patch, kindOf(role, patch) + ", where only a temperature can be given",
      "give it a temperature instead of a heat flux");
  }
}

void requireTurbulence(const Condition& row, const Conditions& conditions, const FoamPatch& patch,
  const SolverSetup& setup)
{
  if (!hasTurbulence(row))
  {
    return;
  }
  if (setup.turbulence == Turbulence::Laminar)
  {
    refuse(patch, "has a turbulence intensity or length, but the flow is laminar",
      "set Turbulence to kOmegaSST, or set both to -1");
  }
  if (!conditions.flowsIn(patch))
  {
    refuse(
      patch, "has a turbulence intensity or length, but nothing flows in there", "set both to -1");
  }
}

// Else the flow is given everywhere, and what comes in must go out to the last digit.
void requirePressure(
  const SolverSetup& setup, const MeshOfCase& mesh, const std::optional<FlowAround>& around)
{
  std::vector<std::string> driven;
  for (const FoamPatch& patch : mesh.patches)
  {
    const PatchRole role = roleOf(patch, around);
    const Condition* const row = rowFor(setup.conditions, &Condition::boundary, patch.name);
    const FlowCondition flow = row ? row->flow : FlowCondition::ByName;
    if (flow == FlowCondition::Pressure ||
      (flow == FlowCondition::ByName && role == PatchRole::Outlet))
    {
      return;
    }
    if (isOpen(role))
    {
      driven.push_back(patch.name);
    }
  }
  throw Error(Fault::BadParameter,
    "Conditions: the flow is given at all openings, " + listOf(driven, ", ") +
      ", so that no pressure is. Nothing is written: leave one to its name, or give it a "
      "pressure.");
}

std::vector<std::string> patchNamesOf(const std::vector<MeshOfCase>& meshes)
{
  std::vector<std::string> names;
  for (const MeshOfCase& mesh : meshes)
  {
    for (const FoamPatch& patch : mesh.patches)
    {
      if (patch.type != "processor")
      {
        names.push_back(patch.name);
      }
    }
  }
  return names;
}

}

void requireSuitableConditions(const SolverSetup& setup, const std::vector<MeshOfCase>& meshes,
  const std::optional<FlowAround>& around)
{
  requireRowsFit(namesOf(setup.conditions, &Condition::boundary), patchNamesOf(meshes),
    "Conditions", "boundary");
  std::for_each(setup.conditions.begin(), setup.conditions.end(), requireNumbers);
  for (const MeshOfCase& mesh : meshes)
  {
    const Conditions conditions(setup, mesh, around);
    for (const FoamPatch& patch : mesh.patches)
    {
      if (const Condition* row = rowFor(setup.conditions, &Condition::boundary, patch.name))
      {
        const PatchRole role = roleOf(patch, around);
        requireFlow(*row, role, patch);
        requireHeat(*row, role, patch, setup);
        requireTurbulence(*row, conditions, patch, setup);
      }
    }
    if (mesh.isFluid && hasFlowConditions(setup, mesh))
    {
      requirePressure(setup, mesh, around);
    }
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/Conditions.h"

#include "OpenFoam/CaseFiles.h"
#include "OpenFoam/Rows.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr const char* Rest = "(0 0 0)";

const Condition* rowFor(const SolverSetup& setup, const FoamPatch& patch)
{
  return rowFor(setup.conditions, &Condition::boundary, patch.name);
}

bool isFlow(FlowCondition flow)
{
  return flow == FlowCondition::VolumeFlow || flow == FlowCondition::MassFlow;
}

bool isVelocity(FlowCondition flow)
{
  return flow == FlowCondition::Speed || isFlow(flow);
}

// Normal to the patch, outwards.
std::string normalVelocity(double speed)
{
  return "type surfaceNormalFixedValue; refValue uniform " + number(speed) + ";";
}

std::string flowRate(bool isIn, double rate)
{
  return std::string("type ") + (isIn ? "flowRateInletVelocity" : "flowRateOutletVelocity") +
    "; volumetricFlowRate constant " + number(rate) + "; value uniform " + Rest + ";";
}

std::string heatFlux(bool isFluid, double flux)
{
  return std::string("type externalWallHeatFluxTemperature; mode flux; kappaMethod ") +
    (isFluid ? "fluidThermo" : "solidThermo") + "; q uniform " + number(flux) +
    "; value $internalField;";
}

}

Conditions::Conditions(
  const SolverSetup& setup, const MeshOfCase& mesh, const std::optional<FlowAround>& around)
  : setup_(setup)
  , mesh_(mesh)
  , around_(around)
{
}

const Condition& Conditions::rowOf(const FoamPatch& patch) const
{
  static const Condition none{};
  const Condition* const row = rowFor(setup_, patch);
  return row ? *row : none;
}

bool Conditions::flowsIn(const FoamPatch& patch) const
{
  const Condition& row = rowOf(patch);
  const bool isInlet = roleOf(patch, around_) == PatchRole::Inlet;
  return isVelocity(row.flow) ? isInlet == (row.flowValue >= 0) : isInlet;
}

std::optional<std::string> Conditions::velocity(const FoamPatch& patch) const
{
  const Condition& row = rowOf(patch);
  const double size = std::abs(row.flowValue);
  switch (row.flow)
  {
    case FlowCondition::Speed:
      return normalVelocity(flowsIn(patch) ? -size : size);
    case FlowCondition::VolumeFlow:
      return flowRate(flowsIn(patch), size);
    case FlowCondition::MassFlow:
      return flowRate(flowsIn(patch), size / setup_.density);
    case FlowCondition::Pressure:
      if (roleOf(patch, around_) == PatchRole::Inlet)
      {
        return valued("pressureInletOutletVelocity", Rest);
      }
      return {};
    default:
      return {};
  }
}

std::optional<std::string> Conditions::pressure(const FoamPatch& patch) const
{
  const Condition& row = rowOf(patch);
  if (isVelocity(row.flow))
  {
    return "type zeroGradient;";
  }
  if (row.flow != FlowCondition::Pressure)
  {
    return {};
  }
  const std::string value = number(row.flowValue / setup_.density);
  return roleOf(patch, around_) == PatchRole::Inlet
    ? "type totalPressure; p0 uniform " + value + "; value uniform " + value + ";"
    : valued("fixedValue", value);
}

std::optional<std::string> Conditions::temperature(const FoamPatch& patch) const
{
  const Condition& row = rowOf(patch);
  const std::string value = number(row.heatValue);
  switch (row.heat)
  {
    case HeatCondition::Temperature:
      return roleOf(patch, around_) == PatchRole::Outlet
        ? "type inletOutlet; inletValue uniform " + value + "; value uniform " + value + ";"
        : valued("fixedValue", value);
    case HeatCondition::HeatFlux:
      return heatFlux(mesh_.isFluid, row.heatValue);
    default:
      return {};
  }
}

double Conditions::speedOf(const FoamPatch& patch) const
{
  const Condition& row = rowOf(patch);
  const double value = std::abs(row.flowValue);
  const double speed = row.flow == FlowCondition::Speed ? value
    : row.flow == FlowCondition::Pressure
    ? std::sqrt(2 * std::max(row.flowValue, 0.) / setup_.density)
    : isFlow(row.flow) && patch.area > 0
    ? value / patch.area / (row.flow == FlowCondition::MassFlow ? setup_.density : 1)
    : 0;
  return speed > 0 ? speed : setup_.speed;
}

// Turbulence is weak around bodies and stronger in ducts, with a viscosity ratio of ten.
InletTurbulence Conditions::turbulenceOf(const Condition& row, double speed) const
{
  constexpr double Viscosities = 10;
  const double fourthRootOfCmu = std::pow(0.09, 0.25);
  const double intensity = row.intensity > 0 ? row.intensity : around_ ? 0.01 : 0.05;
  const double k = 1.5 * std::pow(intensity * speed, 2);
  return { k,
    row.length > 0 ? std::sqrt(k) / (fourthRootOfCmu * row.length)
                   : k / (Viscosities * setup_.viscosity) };
}

InletTurbulence Conditions::turbulence(const FoamPatch& patch) const
{
  return turbulenceOf(rowOf(patch), speedOf(patch));
}

InletTurbulence Conditions::startingTurbulence() const
{
  std::optional<InletTurbulence> strongest;
  for (const FoamPatch& patch : mesh_.patches)
  {
    if (flowsIn(patch))
    {
      const InletTurbulence inlet = turbulence(patch);
      strongest = strongest && strongest->k >= inlet.k ? *strongest : inlet;
    }
  }
  return strongest.value_or(turbulenceOf({}, setup_.speed));
}

bool hasFlowConditions(const SolverSetup& setup, const MeshOfCase& mesh)
{
  return std::any_of(mesh.patches.begin(), mesh.patches.end(), [&](const FoamPatch& patch) {
    const Condition* const row = rowFor(setup, patch);
    return row && row->flow != FlowCondition::ByName;
  });
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/SolverSetup.h"

#include "Base/Error.h"
#include "Base/OutputFile.h"
#include "OpenFoam/ConditionChecks.h"
#include "OpenFoam/Conditions.h"
#include "OpenFoam/FlowCase.h"
#include "OpenFoam/HeatCase.h"
#include "OpenFoam/PeriodicDrive.h"
#include "OpenFoam/Rotations.h"
#include "OpenFoam/Substances.h"

#include <algorithm>
#include <utility>

namespace cartesian
{

namespace
{

constexpr std::array<const char*, 6> Sides{ "xMin", "xMax", "yMin", "yMax", "zMin", "zMax" };

// Of the box around bodies, where sides are called by axes; else 6.
int sideCalled(const std::string& name)
{
  return static_cast<int>(std::find(Sides.begin(), Sides.end(), name) - Sides.begin());
}

PatchRole roleOfSide(int side, const FlowAround& around)
{
  return side == around.direction    ? PatchRole::Inlet
    : side == (around.direction ^ 1) ? PatchRole::Outlet
                                     : PatchRole::Slip;
}

// Where a zone drives the flow, there may be outlets alone, which let it in and out.
void requireEnds(
  const SolverSetup& setup, const MeshOfCase& mesh, const std::optional<FlowAround>& around)
{
  const std::string of = mesh.region.empty() ? "" : " of region " + mesh.region;
  for (const auto& [role, name] :
    { std::pair(PatchRole::Inlet, "inlet"), std::pair(PatchRole::Outlet, "outlet") })
  {
    const bool isDriven = role == PatchRole::Inlet && !setup.rotations.empty();
    if (!isDriven && namesOf(mesh, role, around).empty())
    {
      throw Error(Fault::BadParameter,
        std::string("Solver Setup: no boundary") + of + " is an " + name +
          ". Nothing is written: give a boundary a name that begins with " + name +
          ", for example in Boundary Merged Names, or set Solver Setup to None.");
    }
  }
}

bool areRegions(const std::vector<MeshOfCase>& meshes)
{
  return !meshes.empty() && !meshes.front().region.empty();
}

}

PatchRole roleOf(const FoamPatch& patch, const std::optional<FlowAround>& around)
{
  const int side = around ? sideCalled(patch.name) : 6;
  if (patch.type == "mappedWall")
  {
    return PatchRole::Coupled;
  }
  if (patch.type == "wall")
  {
    return around && (side < 6 || patch.name == "ground") ? PatchRole::Ground : PatchRole::Wall;
  }
  if (patch.type != "patch")
  {
    return PatchRole::Constraint;
  }
  if (side < 6)
  {
    return roleOfSide(side, *around);
  }
  const BoundaryKind kind = kindOf(patch);
  return kind == BoundaryKind::Inlet  ? PatchRole::Inlet
    : around && patch.name == "sides" ? PatchRole::Slip
                                      : PatchRole::Outlet;
}

std::vector<std::string> namesOf(
  const MeshOfCase& mesh, PatchRole role, const std::optional<FlowAround>& around)
{
  std::vector<std::string> names;
  for (const FoamPatch& patch : mesh.patches)
  {
    if (roleOf(patch, around) == role)
    {
      names.push_back(patch.name);
    }
  }
  return names;
}

void requireInRange(const SolverSetup& setup)
{
  requireInRange(SolverSetup::Speeds, setup.speed, "Speed");
  requireInRange(SolverSetup::Viscosities, setup.viscosity, "Viscosity");
  requireInRange(SolverSetup::Temperatures, setup.temperature, "Inlet Temperature");
  requireInRange(SolverSetup::AllIterations, setup.iterations, "Iterations");
  requireInRange(SolverSetup::AllIterations, setup.heatIterations, "Iterations");
  requireInRange(SolverSetup::Densities, setup.density, "Density");
  requireInRange(SolverSetup::EndTimes, setup.times.end, "End Time");
  requireInRange(SolverSetup::WriteIntervals, setup.times.writeInterval, "Write Interval");
  requireInRange(SolverSetup::TimeSteps, setup.times.step, "Time Step");
  requireInRange(SolverSetup::CourantNumbers, setup.times.courant, "Courant Number");
}

void requireSuitable(const SolverSetup& setup, const std::vector<MeshOfCase>& meshes,
  const std::optional<FlowAround>& around)
{
  if (setup.solver == Solver::None || meshes.empty())
  {
    return;
  }
  if (areRegions(meshes) != (setup.solver == Solver::ConjugateHeat))
  {
    const std::string name = setup.solver == Solver::Transient ? "Transient" : "Incompressible";
    throw Error(Fault::BadParameter,
      areRegions(meshes)
        ? "Solver Setup is " + name +
          ", which needs a single mesh, but there are several "
          "regions. Nothing is written: choose Conjugate Heat, or set Regions As to Zones, or name "
          "those that are zones in Zone "
          "Regions."
        : "Solver Setup is Conjugate Heat, which needs several regions, but there is only one. "
          "Nothing is written: choose Incompressible, or set Regions From.");
  }
  requireSuitableRotations(setup, meshes);
  for (const MeshOfCase& mesh : meshes)
  {
    if (mesh.isFluid && !hasFlowConditions(setup, mesh) && !drivenAlong(mesh, around))
    {
      requireEnds(setup, mesh, around);
    }
  }
  requireSuitableConditions(setup, meshes, around);
  requireSuitableMaterials(setup, meshes);
}

std::vector<std::filesystem::path> writeSolverCase(const std::filesystem::path& folder,
  const SolverSetup& setup, const std::vector<MeshOfCase>& meshes,
  const std::optional<FlowAround>& around, int pieces)
{
  requireInRange(setup);
  requireSuitable(setup, meshes, around);
  if (setup.solver == Solver::None || meshes.empty())
  {
    return {};
  }
  const CaseTemplates templates(setup.templates);
  CaseFiles files(folder, templates, setup.overwrites, pieces);
  reportingFailures([&] {
    if (areRegions(meshes))
    {
      writeHeatCase(setup, meshes, pieces, files);
    }
    else
    {
      writeFlowCase(setup, meshes.front(), around, files);
    }
  });
  return files.kept();
}

}

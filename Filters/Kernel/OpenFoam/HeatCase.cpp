// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/HeatCase.h"

#include "Base/Error.h"
#include "OpenFoam/Conditions.h"
#include "OpenFoam/FlowCase.h"
#include "OpenFoam/HeatBalance.h"
#include "OpenFoam/LeastSystem.h"
#include "OpenFoam/Substances.h"

#include <vector>

namespace cartesian
{

namespace
{

namespace fs = std::filesystem;

constexpr double Pressure = 1e5;     // Pa
constexpr double Surroundings = 293; // K
constexpr double TurbulentPrandtl = 0.85;

std::string coupled(bool isFluid, double start)
{
  return std::string("type compressible::turbulentTemperatureCoupledBaffleMixed; Tnbr T; "
                     "kappaMethod ") +
    (isFluid ? "fluidThermo" : "solidThermo") + "; value uniform " + number(start) + ";";
}

void writeTemperature(const SolverSetup& setup, const MeshOfCase& mesh, CaseFiles& files)
{
  const double start = mesh.isFluid ? setup.temperature : Surroundings;
  const std::string value = number(start);
  const std::optional<FlowAround> none;
  const Conditions conditions(setup, mesh, none);
  files.field(mesh, { "T", false, "[0 0 0 1 0 0 0]", value }, [&](const FoamPatch& patch) {
    if (const auto given = conditions.temperature(patch))
    {
      return *given;
    }
    switch (roleOf(patch, {}))
    {
      case PatchRole::Coupled:
        return coupled(mesh.isFluid, start);
      case PatchRole::Inlet:
        return valued("fixedValue", value);
      case PatchRole::Outlet:
        return "type inletOutlet; inletValue uniform " + value + "; value uniform " + value + ";";
      default:
        return mesh.isFluid ? std::string("type zeroGradient;")
                            : "type externalWallHeatFluxTemperature; mode coefficient; kappaMethod "
                              "solidThermo; h uniform 10; Ta " +
            number(Surroundings) + "; value uniform " + value + ";";
    }
  });
}

void writePressures(const MeshOfCase& mesh, CaseFiles& files)
{
  const std::string value = number(Pressure);
  const char* const dimensions = "[1 -1 -2 0 0 0 0]";
  files.field(mesh, { "p", false, dimensions, value },
    [&](const FoamPatch&) { return valued("calculated", value); });
  if (mesh.isFluid)
  {
    files.field(mesh, { "p_rgh", false, dimensions, value }, [&](const FoamPatch& patch) {
      return valued(
        roleOf(patch, {}) == PatchRole::Outlet ? "fixedValue" : "fixedFluxPressure", value);
    });
  }
}

// Runs the flow of a fluid region as a separate case, then passes the result to the main one.
std::string flowCommands(
  const SolverSetup& setup, const std::string& region, double density, const CaseFiles& files)
{
  std::string turbulence;
  if (setup.turbulence != Turbulence::Laminar)
  {
    turbulence =
      files.text("heat/flow.turbulence", { { "diffusivity", number(density / TurbulentPrandtl) } });
    turbulence.resize(turbulence.find_last_not_of('\n') + 1);
  }
  return files.text("heat/flow",
    { { "turbulence", turbulence }, { "density", number(density) },
      { "places", files.places(".", "processor*") }, { "last", std::to_string(setup.iterations) },
      { "region", region } });
}

void writeSubstance(const Substance& substance, const fs::path& constant, CaseFiles& files)
{
  CaseTemplates::Values values = { { "material", substance.name },
    { "density", number(substance.density) }, { "heatCapacity", number(substance.heatCapacity) } };
  if (substance.isFluid)
  {
    values["viscosity"] = number(substance.density * substance.viscosity);
    values["prandtl"] = number(substance.prandtl);
  }
  else
  {
    values["conductivity"] = number(substance.conductivity);
  }
  files.dictionary(constant / "thermophysicalProperties",
    files.text(
      std::string("heat/thermophysicalProperties") + (substance.isFluid ? ".fluid" : ".solid"),
      values));
}

// A separate case of the flow through a fluid region, and the commands that run it.
std::string writeFlow(const SolverSetup& setup, const MeshOfCase& mesh, const Substance& substance,
  int pieces, CaseFiles& files)
{
  SolverSetup own = setup;
  own.density = substance.density;
  own.viscosity = substance.viscosity;
  CaseFiles flow = files.within(fs::path("flow") / mesh.region);
  writeFlowCase(own, { {}, true, mesh.patches }, {}, flow);
  if (pieces > 1)
  {
    flow.dictionary("system/decomposeParDict", decompositionOf(pieces));
  }
  files.keep(flow.kept());
  return flowCommands(setup, mesh.region, substance.density, files);
}

// Returns commands of Allrun.
std::string writeRegion(
  const SolverSetup& setup, const MeshOfCase& mesh, int pieces, CaseFiles& files)
{
  const fs::path constant = fs::path("constant") / mesh.region;
  const fs::path system = fs::path("system") / mesh.region;
  const std::string kind = mesh.isFluid ? ".fluid" : ".solid";
  const Substance substance = substanceOf(setup, mesh);
  writeTemperature(setup, mesh, files);
  writePressures(mesh, files);
  writeSubstance(substance, constant, files);
  files.dictionary(constant / "radiationProperties", files.text("heat/radiationProperties"));
  if (const double heat = heatSourceOf(setup, mesh); heat != 0)
  {
    files.dictionary(
      constant / "fvOptions", files.text("heat/fvOptions", { { "heat", number(heat) } }));
  }
  files.dictionary(system / "fvSchemes", files.text("heat/fvSchemes" + kind));
  files.dictionary(system / "fvSolution", files.text("heat/fvSolution" + kind));
  if (!mesh.isFluid)
  {
    return {};
  }
  files.dictionary(constant / "turbulenceProperties", turbulenceProperties(setup, files));
  return writeFlow(setup, mesh, substance, pieces, files);
}

}

void writeHeatCase(
  const SolverSetup& setup, const std::vector<MeshOfCase>& meshes, int pieces, CaseFiles& files)
{
  std::string commands = files.text("heat/convert");
  for (const MeshOfCase& mesh : meshes)
  {
    commands += writeRegion(setup, mesh, pieces, files);
  }
  files.dictionary("constant/g", files.text("heat/g"), "uniformDimensionedVectorField");
  files.dictionary("system/controlDict",
    files.text("heat/controlDict",
      { { "most", std::to_string(setup.heatIterations) },
        { "interval", std::to_string(heatInterval(setup)) },
        { "functions", heatFunctions(setup, meshes, files) } }));
  files.script(commands + heatCommands(setup, meshes, files));
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/HeatCase.h"

#include "Base/Error.h"
#include "OpenFoam/FlowCase.h"
#include "OpenFoam/HeatBalance.h"
#include "OpenFoam/LeastSystem.h"

#include <vector>

namespace cartesian
{

namespace
{

constexpr double Pressure = 1e5;     // Pa
constexpr double Surroundings = 293; // K
constexpr double TurbulentPrandtl = 0.85;
constexpr double AirDensity = 1.2; // kg/m3

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
  files.field(mesh, { "T", false, "[0 0 0 1 0 0 0]", value }, [&](const FoamPatch& patch) {
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
  const SolverSetup& setup, const std::string& region, const CaseFiles& files)
{
  std::string turbulence;
  if (setup.turbulence != Turbulence::Laminar)
  {
    turbulence = files.text(
      "heat/flow.turbulence", { { "diffusivity", number(AirDensity / TurbulentPrandtl) } });
    turbulence.resize(turbulence.find_last_not_of('\n') + 1);
  }
  return files.text("heat/flow",
    { { "turbulence", turbulence }, { "density", number(AirDensity) },
      { "places", files.places(".", "processor*") }, { "last", std::to_string(setup.iterations) },
      { "region", region } });
}

}

void writeHeatCase(
  const SolverSetup& setup, const std::vector<MeshOfCase>& meshes, int pieces, CaseFiles& files)
{
  std::string commands = files.text("heat/convert");
  for (const MeshOfCase& mesh : meshes)
  {
    const std::filesystem::path constant = std::filesystem::path("constant") / mesh.region;
    const std::filesystem::path system = std::filesystem::path("system") / mesh.region;
    const std::string kind = mesh.isFluid ? ".fluid" : ".solid";
    writeTemperature(setup, mesh, files);
    writePressures(mesh, files);
    const CaseTemplates::Values values = { { "density", number(AirDensity) },
      { "viscosity", number(AirDensity * setup.viscosity) } };
    files.dictionary(constant / "thermophysicalProperties",
      files.text("heat/thermophysicalProperties" + kind, values));
    files.dictionary(constant / "radiationProperties", files.text("heat/radiationProperties"));
    files.dictionary(system / "fvSchemes", files.text("heat/fvSchemes" + kind));
    files.dictionary(system / "fvSolution", files.text("heat/fvSolution" + kind));
    if (mesh.isFluid)
    {
      files.dictionary(constant / "turbulenceProperties", turbulenceProperties(setup, files));
      CaseFiles flow = files.within(std::filesystem::path("flow") / mesh.region);
      writeFlowCase(setup, { {}, true, mesh.patches }, {}, flow);
      if (pieces > 1)
      {
        flow.dictionary("system/decomposeParDict", decompositionOf(pieces));
      }
      files.keep(flow.kept());
      commands += flowCommands(setup, mesh.region, files);
    }
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

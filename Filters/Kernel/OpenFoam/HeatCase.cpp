// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/HeatCase.h"

#include "Base/Error.h"
#include "OpenFoam/FlowCase.h"
#include "OpenFoam/HeatBalance.h"
#include "OpenFoam/LeastSystem.h"
#include "OpenFoam/RunFiles.h"
#include "OpenFoam/Schemes.h"

#include <vector>

namespace cartesian
{

namespace
{

constexpr double Pressure = 1e5;     // Pa
constexpr double Surroundings = 293; // K
constexpr double TurbulentPrandtl = 0.85;
constexpr double AirDensity = 1.2;  // kg/m3
constexpr double Correction = 0.33; // Schemes::correction

// The flow is known: it carries the heat.
constexpr const char* Gradients = "    grad(h)         cellLimited Gauss linear 1;\n";
constexpr const char* Divergences = R"(    div(phi,h)      bounded Gauss linearUpwind grad(h);
    div(phi,K)      bounded Gauss linear;
    div(phi,U)      bounded Gauss linear;
    div(phi,k)      bounded Gauss linear;
    div(phi,omega)  bounded Gauss linear;
    div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;
)";

constexpr const char* FluidSolution = R"foam(solvers
{
    h
    {
        solver          PBiCGStab;
        preconditioner  DILU;
        tolerance       1e-10;
        relTol          0.05;
    }
}
SIMPLE
{
    nNonOrthogonalCorrectors 0;
    frozenFlow      true;
}
relaxationFactors { equations { h 0.95; } }
)foam";

constexpr const char* SolidSolution = R"(solvers
{
    h
    {
        solver          PCG;
        preconditioner  DIC;
        tolerance       1e-9;
        relTol          0.05;
    }
}
SIMPLE { nNonOrthogonalCorrectors 1; }
relaxationFactors { equations { h 0.95; } }
)";

constexpr const char* Steel = R"(thermoType
{
    type            heSolidThermo;
    mixture         pureMixture;
    transport       constIso;
    thermo          hConst;
    equationOfState rhoConst;
    specie          specie;
    energy          sensibleEnthalpy;
}
mixture // steel
{
    specie { molWeight 56; }
    equationOfState { rho 7850; }
    thermodynamics { Hf 0; Cp 460; }
    transport { kappa 50; }
}
)";

// Of constant density: at the temperatures of exhaust gas, give it its own, or perfectGas.
std::string air(const SolverSetup& setup)
{
  return R"(thermoType
{
    type            heRhoThermo;
    mixture         pureMixture;
    transport       const;
    thermo          hConst;
    equationOfState rhoConst;
    specie          specie;
    energy          sensibleEnthalpy;
}
mixture // air
{
    specie { molWeight 28.96; }
    equationOfState { rho )" +
    number(AirDensity) + R"(; }
    thermodynamics { Hf 0; Cp 1005; }
    transport { mu )" +
    number(AirDensity * setup.viscosity) + R"(; Pr 0.71; }
}
)";
}

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

// Converts simpleFoam's flow, of unit density, for chtMultiRegionSimpleFoam.
constexpr const char* Conversion = R"foam(
# convert FIELD FACTOR DIMENSIONS NEW_FIELD, of a place: of ascii fields.
convert()
{
  awk -v by="$2" -v dimensions="$3" -v name="$4" '
    $1 == "dimensions" { print "dimensions " dimensions ";"; next }
    $1 == "object" { print "    object " name ";"; next }
    $1 == "(" { inside = 1 }
    $1 == ")" { inside = 0 }
    inside && NF == 1 && $1 != "(" { printf "%.12g\n", by * $1; next }
    NF > 1 && $(NF - 1) == "uniform" { $NF = sprintf("%.12g;", by * $NF) }
    { sub("nutUSpaldingWallFunction", "calculated"); print }' "$flow/$1" > "$start/$4"
}
)foam";

// Runs the flow of a fluid region as a separate case, then passes the result to the main one.
constexpr const char* FlowOfRegion = R"foam(
# The flow of @region: as the density is constant, it does not depend on temperatures.
for place in @places; do
  mkdir -p "flow/@region/$place/constant"
  ln -sfn "$PWD/$place/constant/@region/polyMesh" "flow/@region/$place/constant/polyMesh"
done
flow/@region/Allrun
for place in @places; do
  flow="flow/@region/$place/@last"
  start="$place/0/@region"
  cp "$flow/U" "$start"
  convert phi @density '[1 0 -1 0 0 0 0]' phi
@turbulence
done
)foam";

constexpr const char* TurbulenceOfRegion =
  R"foam(  cp "$flow/k" "$flow/omega" "$flow/nut" "$start"
  convert nut @diffusivity '[1 -1 -1 0 0 0 0]' alphat)foam";

std::string flowCommands(
  const SolverSetup& setup, const std::string& region, const std::string& places)
{
  return filledIn(FlowOfRegion,
    { { "@turbulence", setup.turbulence == Turbulence::Laminar ? "" : TurbulenceOfRegion },
      { "@diffusivity", number(AirDensity / TurbulentPrandtl) }, { "@density", number(AirDensity) },
      { "@places", places }, { "@last", std::to_string(setup.iterations) },
      { "@region", region } });
}

}

void writeHeatCase(
  const SolverSetup& setup, const std::vector<MeshOfCase>& meshes, int pieces, CaseFiles& files)
{
  const std::string places = pieces > 1 ? "processor*" : ".";
  std::string commands = Conversion;
  for (const MeshOfCase& mesh : meshes)
  {
    const std::filesystem::path constant = std::filesystem::path("constant") / mesh.region;
    const std::filesystem::path system = std::filesystem::path("system") / mesh.region;
    writeTemperature(setup, mesh, files);
    writePressures(mesh, files);
    files.dictionary(constant / "thermophysicalProperties", mesh.isFluid ? air(setup) : Steel);
    files.dictionary(
      constant / "radiationProperties", "radiation       off;\nradiationModel  none;\n");
    files.dictionary(system / "fvSchemes",
      schemesOf(mesh.isFluid ? Schemes{ Gradients, Divergences, Correction }
                             : Schemes{ {}, {}, Correction }));
    files.dictionary(system / "fvSolution", mesh.isFluid ? FluidSolution : SolidSolution);
    if (mesh.isFluid)
    {
      files.dictionary(constant / "turbulenceProperties", turbulenceProperties(setup));
      CaseFiles flow = files.within(std::filesystem::path("flow") / mesh.region);
      writeFlowCase(setup, { {}, true, mesh.patches }, {}, pieces, flow);
      if (pieces > 1)
      {
        flow.dictionary("system/decomposeParDict", decompositionOf(pieces));
      }
      files.keep(flow.kept());
      commands += flowCommands(setup, mesh.region, places);
    }
  }
  // Of constant density, air does not rise: without gravity no pressure hides how it flows.
  files.dictionary("constant/g", "dimensions      [0 1 -2 0 0 0 0];\nvalue           (0 0 0);\n",
    "uniformDimensionedVectorField");
  files.dictionary("system/controlDict",
    controlOf({ "chtMultiRegionSimpleFoam", setup.heatIterations, heatInterval(setup), true },
      heatFunctions(setup, meshes)));
  files.script("Allrun", scriptOf(commands + heatCommands(setup, meshes, places), pieces));
}

}

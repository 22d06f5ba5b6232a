// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FlowCase.h"

#include "Base/Error.h"
#include "OpenFoam/RunFiles.h"
#include "OpenFoam/Schemes.h"

#include <cmath>

namespace cartesian
{

namespace
{

// Second order, with what keeps it bounded in cells cut by walls.
constexpr const char* Gradients = R"(    grad(U)         cellLimited Gauss linear 1;
    grad(k)         $grad(U);
    grad(omega)     $grad(U);
)";
constexpr const char* Divergences = R"(    div(phi,U)      bounded Gauss linearUpwindV grad(U);
    div(phi,k)      bounded Gauss limitedLinear 1;
    div(phi,omega)  bounded Gauss limitedLinear 1;
    div((nuEff*dev2(T(grad(U))))) Gauss linear;
    div(div(phi,U)) Gauss linear;
)";
constexpr double Correction = 0.5; // Schemes::correction

// GaussSeidel alone takes hundreds of cycles in prisms a thousand times as wide as high, until the flow diverges.
constexpr const char* Solution = R"foam(solvers
{
    p
    {
        solver          GAMG;
        smoother        DICGaussSeidel;
        tolerance       1e-8;
        relTol          0.02;
    }
    Phi { $p; }
    "(U|k|omega)"
    {
        solver          smoothSolver;
        smoother        symGaussSeidel;
        tolerance       1e-9;
        relTol          0.1;
    }
}
SIMPLE
{
    nNonOrthogonalCorrectors 0;
    consistent      yes;
}
potentialFlow { nNonOrthogonalCorrectors 5; }
relaxationFactors
{
    equations
    {
        U               0.8;
        k               0.6;
        omega           0.6;
    }
}
)foam";

std::string entryOf(const char* name, const std::string& value)
{
  return "        " + std::string(name) + " " + value + ";\n";
}

std::string listOf(const std::vector<std::string>& names)
{
  std::string text = "(";
  for (const std::string& name : names)
  {
    text += (text.size() > 1 ? " " : "") + name;
  }
  return text + ")";
}

std::string unitAlong(int axis)
{
  return velocityAlong(2 * axis, 1);
}

std::string forcesOn(
  const std::vector<std::string>& bodies, const SolverSetup& setup, const FlowAround& around)
{
  const int flow = around.direction / 2;
  const int up = around.up == flow ? (flow + 1) % 3 : around.up;
  std::string text = "    forceCoeffs\n    {\n";
  text += entryOf("type", "forceCoeffs") + entryOf("libs", "(forces)") +
    entryOf("patches", listOf(bodies)) + entryOf("rho", "rhoInf") + entryOf("rhoInf", "1") +
    entryOf("dragDir", velocityAlong(around.direction, 1)) + entryOf("liftDir", unitAlong(up)) +
    entryOf("pitchAxis", unitAlong(3 - up - flow)) + entryOf("CofR", "(0 0 0)") +
    entryOf("magUInf", number(setup.speed));
  const bool isKnown = around.frontalArea > 0;
  const char* const what = isKnown ? "of the bodies, as seen along the flow" : "put your own here";
  text += "        lRef " + number(isKnown ? around.length : 1) + "; // " + what + "\n";
  text += "        Aref " + number(isKnown ? around.frontalArea : 1) + "; // " + what + "\n";
  return text + entryOf("writeControl", "timeStep") + entryOf("writeInterval", "1") + "    }\n";
}

// Mean pressures of what flows in, and how much flows through each end.
std::string endsOf(const MeshOfCase& mesh)
{
  std::string text;
  for (const FoamPatch& patch : mesh.patches)
  {
    const PatchRole role = roleOf(patch, {});
    const auto function = [&](const char* what, const char* operation, const char* field) {
      text += "    " + std::string(what) + "_" + patch.name + "\n    {\n" +
        entryOf("type", "surfaceFieldValue") + entryOf("libs", "(fieldFunctionObjects)") +
        entryOf("regionType", "patch") + entryOf("name", patch.name) +
        entryOf("operation", operation) + entryOf("fields", field) +
        entryOf("writeFields", "false") + entryOf("log", "false") +
        entryOf("writeControl", "timeStep") + entryOf("writeInterval", "1") + "    }\n";
    };
    if (role == PatchRole::Inlet)
    {
      function("pressure", "areaAverage", "(p)");
    }
    if (role == PatchRole::Inlet || role == PatchRole::Outlet)
    {
      function("flux", "sum", "(phi)");
    }
  }
  return text;
}

// At walls, whenever fields are written.
std::string wallDistance()
{
  return "    yPlus\n    {\n" + entryOf("type", "yPlus") +
    entryOf("libs", "(fieldFunctionObjects)") + entryOf("writeControl", "writeTime") + "    }\n";
}

void writePressure(
  const MeshOfCase& mesh, const std::optional<FlowAround>& around, CaseFiles& files)
{
  files.field(mesh, { "p", false, "[0 2 -2 0 0 0 0]", "0" }, [&](const FoamPatch& patch) {
    switch (roleOf(patch, around))
    {
      case PatchRole::Outlet:
        return valued("fixedValue", "0");
      case PatchRole::Slip:
        return std::string("type slip;");
      default:
        return std::string("type zeroGradient;");
    }
  });
}

// Inflow: turbulence is weak around bodies and stronger in ducts, with a viscosity ratio of ten.
struct InletTurbulence
{
  double k;     // m2/s2
  double omega; // 1/s
};

InletTurbulence inletTurbulence(const SolverSetup& setup, bool isAround)
{
  constexpr double Viscosities = 10;
  const double intensity = isAround ? 0.01 : 0.05;
  const double k = 1.5 * std::pow(intensity * setup.speed, 2);
  return { k, k / (Viscosities * setup.viscosity) };
}

// It starts at rest: potentialFoam's velocity passes through walls, a bad start for thin cells.
void writeVelocity(const SolverSetup& setup, const MeshOfCase& mesh,
  const std::optional<FlowAround>& around, CaseFiles& files)
{
  const std::string rest = "(0 0 0)";
  const std::string flow = around ? velocityAlong(around->direction, setup.speed) : rest;
  files.field(mesh, { "U", true, "[0 1 -1 0 0 0 0]", rest }, [&](const FoamPatch& patch) {
    switch (roleOf(patch, around))
    {
      case PatchRole::Inlet:
        return around
          ? valued("fixedValue", flow)
          : "type surfaceNormalFixedValue; refValue uniform " + number(-setup.speed) + ";";
      case PatchRole::Outlet:
        return "type inletOutlet; inletValue uniform " + rest + "; value uniform " + flow + ";";
      case PatchRole::Ground:
        return valued("fixedValue", flow);
      case PatchRole::Slip:
        return std::string("type slip;");
      default:
        return std::string("type noSlip;");
    }
  });
}

void writeTurbulence(const SolverSetup& setup, const MeshOfCase& mesh,
  const std::optional<FlowAround>& around, CaseFiles& files)
{
  const InletTurbulence inlet = inletTurbulence(setup, around.has_value());
  const auto put = [&](const char* name, const char* dimensions, double start,
                     const std::string& wall, const std::string& elsewhere) {
    const std::string value = number(start);
    files.field(mesh, { name, false, dimensions, value }, [&](const FoamPatch& patch) {
      switch (roleOf(patch, around))
      {
        case PatchRole::Inlet:
          return valued(elsewhere.empty() ? "fixedValue" : elsewhere, value);
        case PatchRole::Outlet:
          return elsewhere.empty()
            ? "type inletOutlet; inletValue uniform " + value + "; value uniform " + value + ";"
            : valued(elsewhere, value);
        case PatchRole::Slip:
          return elsewhere.empty() ? std::string("type slip;") : valued(elsewhere, value);
        default:
          return valued(wall, value);
      }
    });
  };
  put("k", "[0 2 -2 0 0 0 0]", inlet.k, "kqRWallFunction", "");
  put("omega", "[0 0 -1 0 0 0 0]", inlet.omega, "omegaWallFunction", "");
  // By the wall's friction, at any y+: nutkWallFunction's y+ is of k, a tenth of that where walls are resolved.
  put("nut", "[0 2 -1 0 0 0 0]", inlet.k / inlet.omega, "nutUSpaldingWallFunction", "calculated");
}

}

std::string turbulenceProperties(const SolverSetup& setup)
{
  return setup.turbulence == Turbulence::Laminar
    ? "simulationType  laminar;\n"
    : "simulationType  RAS;\nRAS\n{\n    RASModel        kOmegaSST;\n    turbulence      on;\n"
      "    printCoeffs     off;\n}\n";
}

void writeFlowCase(const SolverSetup& setup, const MeshOfCase& mesh,
  const std::optional<FlowAround>& around, int pieces, CaseFiles& files)
{
  writeVelocity(setup, mesh, around, files);
  writePressure(mesh, around, files);
  if (setup.turbulence != Turbulence::Laminar)
  {
    writeTurbulence(setup, mesh, around, files);
  }
  files.dictionary("constant/transportProperties",
    "transportModel  Newtonian;\nnu              [0 2 -1 0 0 0 0] " + number(setup.viscosity) +
      ";\n");
  files.dictionary("constant/turbulenceProperties", turbulenceProperties(setup));
  files.dictionary("system/controlDict",
    controlOf({ "simpleFoam", setup.iterations, setup.iterations },
      (around ? forcesOn(namesOf(mesh, PatchRole::Wall, around), setup, *around) : endsOf(mesh)) +
        (setup.turbulence == Turbulence::Laminar ? "" : wallDistance())));
  files.dictionary("system/fvSchemes", schemesOf({ Gradients, Divergences, Correction }));
  files.dictionary("system/fvSolution", Solution);
  // Debian's potentialFoam finds the flux, but a wrong velocity in small cells (see the guide's page openfoam).
  const std::string places = pieces > 1 ? "processor*/0" : "0";
  files.script("Allrun",
    scriptOf("for start in " + places +
        "; do cp \"$start/U\" \"$start/../U.rest\"; done\n"
        "run potentialFoam -writephi\n"
        "for start in " +
        places + "; do mv \"$start/../U.rest\" \"$start/U\"; done\nrun simpleFoam\n",
      pieces));
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FlowCase.h"

#include "Base/Error.h"

#include <cmath>

namespace cartesian
{

namespace
{

std::string listOf(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : " ") + name;
  }
  return text;
}

std::string unitAlong(int axis)
{
  return velocityAlong(2 * axis, 1);
}

std::string forcesOn(const std::vector<std::string>& bodies, const SolverSetup& setup,
  const FlowAround& around, const CaseFiles& files)
{
  const int flow = around.direction / 2;
  const int up = around.up == flow ? (flow + 1) % 3 : around.up;
  const bool isKnown = around.frontalArea > 0;
  return files.text("flow/forceCoeffs",
    { { "bodies", listOf(bodies) }, { "drag", velocityAlong(around.direction, 1) },
      { "lift", unitAlong(up) }, { "pitch", unitAlong(3 - up - flow) },
      { "speed", number(setup.speed) }, { "length", number(isKnown ? around.length : 1) },
      { "area", number(isKnown ? around.frontalArea : 1) },
      { "source", isKnown ? "of the bodies, as seen along the flow" : "put your own here" } });
}

// Mean pressures of what flows in, and how much flows through each end.
std::string endsOf(const MeshOfCase& mesh, const CaseFiles& files)
{
  std::string text;
  for (const FoamPatch& patch : mesh.patches)
  {
    const PatchRole role = roleOf(patch, {});
    if (role == PatchRole::Inlet)
    {
      text += files.text("flow/pressure", { { "patch", patch.name } });
    }
    if (role == PatchRole::Inlet || role == PatchRole::Outlet)
    {
      text += files.text("flow/flux", { { "patch", patch.name } });
    }
  }
  return text;
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

std::string turbulenceProperties(const SolverSetup& setup, const CaseFiles& files)
{
  return files.text(setup.turbulence == Turbulence::Laminar
      ? "flow/turbulenceProperties.laminar"
      : "flow/turbulenceProperties.kOmegaSST");
}

void writeFlowCase(const SolverSetup& setup, const MeshOfCase& mesh,
  const std::optional<FlowAround>& around, CaseFiles& files)
{
  const bool isLaminar = setup.turbulence == Turbulence::Laminar;
  writeVelocity(setup, mesh, around, files);
  writePressure(mesh, around, files);
  if (!isLaminar)
  {
    writeTurbulence(setup, mesh, around, files);
  }
  files.dictionary("constant/transportProperties",
    files.text("flow/transportProperties", { { "viscosity", number(setup.viscosity) } }));
  files.dictionary("constant/turbulenceProperties", turbulenceProperties(setup, files));
  const std::string functions =
    (around ? forcesOn(namesOf(mesh, PatchRole::Wall, around), setup, *around, files)
            : endsOf(mesh, files)) +
    (isLaminar ? "" : files.text("flow/yPlus"));
  files.dictionary("system/controlDict",
    files.text("flow/controlDict",
      { { "iterations", std::to_string(setup.iterations) }, { "functions", functions } }));
  files.dictionary("system/fvSchemes", files.text("flow/fvSchemes"));
  files.dictionary("system/fvSolution", files.text("flow/fvSolution"));
  files.script(files.text("flow/commands", { { "places", files.places("0", "processor*/0") } }));
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FlowCase.h"

#include "Base/Error.h"
#include "OpenFoam/Conditions.h"
#include "OpenFoam/PeriodicDrive.h"
#include "OpenFoam/Rotations.h"
#include "OpenFoam/Rows.h"

namespace cartesian
{

namespace
{

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
    { { "bodies", listOf(bodies, " ") }, { "drag", velocityAlong(around.direction, 1) },
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

// Of one mesh: what every patch is.
struct Flow
{
  const SolverSetup& setup;
  const MeshOfCase& mesh;
  const std::optional<FlowAround>& around;
  Conditions conditions;
  std::vector<TurningZone> turning;
};

void writePressure(const Flow& flow, CaseFiles& files)
{
  files.field(flow.mesh, { "p", false, "[0 2 -2 0 0 0 0]", "0" }, [&](const FoamPatch& patch) {
    if (const auto given = flow.conditions.pressure(patch))
    {
      return *given;
    }
    switch (roleOf(patch, flow.around))
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

// It starts at rest: potentialFoam's velocity passes through walls, a bad start for thin cells.
void writeVelocity(const Flow& flow, CaseFiles& files)
{
  const std::string rest = "(0 0 0)";
  const double speed = flow.setup.speed;
  const std::string along = flow.around ? velocityAlong(flow.around->direction, speed) : rest;
  files.field(flow.mesh, { "U", true, "[0 1 -1 0 0 0 0]", rest }, [&](const FoamPatch& patch) {
    if (const auto given = flow.conditions.velocity(patch))
    {
      return *given;
    }
    if (const auto turning = velocityOutside(flow.turning, patch))
    {
      return *turning;
    }
    switch (roleOf(patch, flow.around))
    {
      case PatchRole::Inlet:
        return flow.around
          ? valued("fixedValue", along)
          : "type surfaceNormalFixedValue; refValue uniform " + number(-speed) + ";";
      case PatchRole::Outlet:
        return "type inletOutlet; inletValue uniform " + rest + "; value uniform " + along + ";";
      case PatchRole::Ground:
        return valued("fixedValue", along);
      case PatchRole::Slip:
        return std::string("type slip;");
      default:
        return std::string("type noSlip;");
    }
  });
}

// A field of turbulence; `elsewhere`: what it is where there is no wall, or empty: its value flows in.
struct TurbulenceField
{
  const char* name;
  const char* dimensions;
  double (*of)(const InletTurbulence&);
  const char* wall;
  std::string elsewhere;
};

void writeTurbulenceField(const Flow& flow, const TurbulenceField& field, CaseFiles& files)
{
  const std::string start = number(field.of(flow.conditions.startingTurbulence()));
  files.field(
    flow.mesh, { field.name, false, field.dimensions, start }, [&](const FoamPatch& patch) {
      const PatchRole role = roleOf(patch, flow.around);
      const bool flowsIn = flow.conditions.flowsIn(patch);
      const std::string value =
        flowsIn ? number(field.of(flow.conditions.turbulence(patch))) : start;
      if (role == PatchRole::Wall || role == PatchRole::Ground || role == PatchRole::Coupled)
      {
        return valued(field.wall, value);
      }
      if (!field.elsewhere.empty())
      {
        return valued(field.elsewhere, value);
      }
      return role == PatchRole::Slip ? std::string("type slip;")
        : flow.conditions.flowsIn(patch)
        ? valued("fixedValue", value)
        : "type inletOutlet; inletValue uniform " + value + "; value uniform " + value + ";";
    });
}

void writeTurbulence(const Flow& flow, CaseFiles& files)
{
  using Inlet = const InletTurbulence&;
  writeTurbulenceField(flow,
    { "k", "[0 2 -2 0 0 0 0]", [](Inlet inlet) { return inlet.k; }, "kqRWallFunction", "" }, files);
  writeTurbulenceField(flow,
    { "omega", "[0 0 -1 0 0 0 0]", [](Inlet inlet) { return inlet.omega; }, "omegaWallFunction",
      "" },
    files);
  // By the wall's friction, at any y+: nutkWallFunction's y+ is of k, a tenth of that where walls are resolved.
  writeTurbulenceField(flow,
    { "nut", "[0 2 -1 0 0 0 0]", [](Inlet inlet) { return inlet.k / inlet.omega; },
      "nutUSpaldingWallFunction", "calculated" },
    files);
}

std::string timesOf(const SolverSetup& setup, const std::string& functions, const CaseFiles& files)
{
  if (setup.solver != Solver::Transient)
  {
    return files.text("flow/controlDict",
      { { "iterations", std::to_string(setup.iterations) }, { "functions", functions } });
  }
  constexpr double Intervals = 10;
  constexpr double FirstSteps = 100; // in an interval, until the Courant number is known
  const FlowTimes& times = setup.times;
  const double interval = times.writeInterval > 0 ? times.writeInterval : times.end / Intervals;
  return files.text("flow/controlDict.transient",
    { { "end", number(times.end) }, { "interval", number(interval) },
      { "step", number(times.step > 0 ? times.step : interval / FirstSteps) },
      { "adjusts", times.step > 0 ? "no" : "yes" }, { "courant", number(times.courant) },
      { "functions", functions } });
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
  const bool isTransient = setup.solver == Solver::Transient;
  const Flow flow{ setup, mesh, around, { setup, mesh, around },
    turningZones(setup, mesh, around) };
  writeVelocity(flow, files);
  writePressure(flow, files);
  if (!isLaminar)
  {
    writeTurbulence(flow, files);
  }
  files.dictionary("constant/transportProperties",
    files.text("flow/transportProperties", { { "viscosity", number(setup.viscosity) } }));
  writeRotations(flow.turning, files);
  writeDrive(setup, mesh, around, files);
  files.dictionary("constant/turbulenceProperties", turbulenceProperties(setup, files));
  const std::string functions =
    (around ? forcesOn(namesOf(mesh, PatchRole::Wall, around), setup, *around, files)
            : endsOf(mesh, files)) +
    (isLaminar ? "" : files.text("flow/yPlus"));
  files.dictionary("system/controlDict", timesOf(setup, functions, files));
  const std::string kind = isTransient ? ".transient" : "";
  files.dictionary("system/fvSchemes", files.text("flow/fvSchemes" + kind));
  files.dictionary("system/fvSolution", files.text("flow/fvSolution" + kind));
  files.script(files.text("flow/commands",
    { { "places", files.places("0", "processor*/0") },
      { "solver", isTransient ? "pimpleFoam" : "simpleFoam" } }));
}

}

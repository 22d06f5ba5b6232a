// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/PeriodicDrive.h"

#include "Base/Error.h"

namespace cartesian
{

std::optional<Vector> drivenAlong(const MeshOfCase& mesh, const std::optional<FlowAround>& around)
{
  if (!namesOf(mesh, PatchRole::Inlet, around).empty())
  {
    return {};
  }
  for (const FoamPatch& patch : mesh.patches)
  {
    if (patch.pair == 1 && patch.motion.angle == 0)
    {
      return unit(patch.motion.translation);
    }
  }
  return {};
}

void writeDrive(const SolverSetup& setup, const MeshOfCase& mesh,
  const std::optional<FlowAround>& around, CaseFiles& files)
{
  if (const std::optional<Vector> along = drivenAlong(mesh, around))
  {
    const Vector mean = scaled(*along, setup.speed);
    files.dictionary("constant/fvOptions",
      files.text("flow/fvOptions",
        { { "velocity",
          "(" + number(mean[0]) + " " + number(mean[1]) + " " + number(mean[2]) + ")" } }));
  }
}

}

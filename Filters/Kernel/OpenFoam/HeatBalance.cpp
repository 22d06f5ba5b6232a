// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/HeatBalance.h"

#include "Base/Error.h"
#include "OpenFoam/Substances.h"

#include <algorithm>
#include <set>

namespace cartesian
{

namespace
{

constexpr double Agreement = 1e-3; // of heat, in parts of what passes through a region

std::string joined(const std::string& list, const std::string& word)
{
  return list + (list.empty() ? "" : " ") + word;
}

// Whether all heat passes through walls.
bool isClosed(const MeshOfCase& mesh)
{
  return namesOf(mesh, PatchRole::Inlet, {}).empty() &&
    namesOf(mesh, PatchRole::Outlet, {}).empty();
}

}

int heatInterval(const SolverSetup& setup)
{
  constexpr int Usual = 100;
  return std::min(Usual, setup.heatIterations);
}

std::string heatFunctions(
  const SolverSetup& setup, const std::vector<MeshOfCase>& meshes, const CaseFiles& files)
{
  std::string text;
  for (const MeshOfCase& mesh : meshes)
  {
    text += files.text("heat/wallHeatFlux",
      { { "region", mesh.region }, { "interval", std::to_string(heatInterval(setup)) } });
  }
  return text;
}

std::string heatCommands(
  const SolverSetup& setup, const std::vector<MeshOfCase>& meshes, const CaseFiles& files)
{
  std::string solids;
  std::string sources;        // of heat, in these
  std::string sides;          // of interfaces, each once
  std::set<std::string> done; // regions
  for (const MeshOfCase& mesh : meshes)
  {
    if (!mesh.isFluid && isClosed(mesh))
    {
      solids = joined(solids, mesh.region);
      sources = joined(sources, number(heatSourceOf(setup, mesh)));
    }
    for (const FoamPatch& patch : mesh.patches)
    {
      if (roleOf(patch, {}) == PatchRole::Coupled && done.count(patch.sample.region) == 0)
      {
        sides = joined(sides,
          mesh.region + "/" + patch.name + "/" + patch.sample.region + "/" + patch.sample.patch);
      }
    }
    done.insert(mesh.region);
  }
  return files.text("heat/commands",
    { { "solids", solids }, { "sides", sides }, { "sources", sources },
      { "agreement", number(Agreement) }, { "places", files.places(".", "processor*") },
      { "first", meshes.front().region }, { "interval", std::to_string(heatInterval(setup)) },
      { "most", std::to_string(setup.heatIterations) } });
}

}

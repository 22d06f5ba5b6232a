// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/HeatBalance.h"

#include "Base/Error.h"
#include "OpenFoam/RunFiles.h"

#include <algorithm>
#include <set>

namespace cartesian
{

namespace
{

constexpr double Agreement = 1e-3; // of heat, in parts of what passes through a region

// Debian's OpenFOAM lets the administrator make no system calls, so no function object can compare: each run ends at an
// interval, and the script looks.
constexpr const char* Commands = R"foam(
# Heat into each region through each of its walls, W: iteration, region, patch, heat.
table=postProcessing/heat.dat
record()
{
  for file in postProcessing/*/heat_*/*/wallHeatFlux.dat; do
    if [ -f "$file" ]; then
      region="${file#postProcessing/}"
      awk -v region="${region%%/*}" '$1 !~ /#/ { print $1, region, $2, $5 }' "$file" >> "$table"
      rm -r "${file%/*}"
    fi
  done
}

# Says which regions are out of balance after the last iteration, and fails if there are any.
balanced()
{
  if [ ! -s "$table" ]; then
    echo "  unknown: no heat was recorded"
    return 1
  fi
  awk -v solids="@solids" -v sides="@sides" -v agreement=@agreement '
    function size(x) { return x < 0 ? -x : x }
    function passes(region) { return (into[region] + from[region]) / (isSolid[region] ? 2 : 1) }
    $1 != last { split("", heat); last = $1 }
    { heat[$2 "/" $3] = $4 }
    END {
      for (key in heat) {
        split(key, at, "/")
        into[at[1]] += heat[key] > 0 ? heat[key] : 0
        from[at[1]] += heat[key] < 0 ? -heat[key] : 0
      }
      count = split(solids, names, " ")
      for (i = 1; i <= count; ++i) {
        r = names[i]
        isSolid[r] = 1
        if (size(into[r] - from[r]) > agreement * passes(r)) {
          printf "  %s takes in %.6g W and gives off %.6g W\n", r, into[r], from[r]
          bad = 1
        }
      }
      count = split(sides, pairs, " ")
      for (i = 1; i <= count; ++i) {
        split(pairs[i], at, "/")
        leaves = -heat[at[1] "/" at[2]]
        enters = heat[at[3] "/" at[4]]
        least = passes(at[1]) < passes(at[3]) ? passes(at[1]) : passes(at[3])
        if (size(leaves - enters) > agreement * least) {
          printf "  %s: %.6g W leave %s, %.6g W enter %s\n", at[2], leaves, at[1], enters, at[3]
          bad = 1
        }
      }
      exit bad
    }' "$table"
}

# Of an earlier run.
for place in @places; do
  for time in "$place"/[1-9]*; do
    if [ -d "$time/@first" ]; then rm -r "$time"; fi
  done
done
rm -rf postProcessing/*/heat_* "$table"
mkdir -p postProcessing

# In runs of @interval iterations, each from where the one before ended.
last=@interval
run chtMultiRegionSimpleFoam
record
until balanced > /dev/null || [ $((last + @interval)) -gt @most ]; do
  more chtMultiRegionSimpleFoam
  record
  for place in @places; do
    if [ -d "$place/$((last + @interval))" ]; then rm -rf "$place/$last"; fi
  done
  last=$((last + @interval))
done
if balanced > /dev/null; then
  echo "heat in and out of each solid agree to @agreement after $last iterations"
else
  echo "NOT CONVERGED: after $last iterations, heat in and out do not agree to @agreement:"
  balanced || true
  echo "  Save the case with more Iterations and Overwrite Setup, and run it again."
fi
)foam";

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

std::string heatFunctions(const SolverSetup& setup, const std::vector<MeshOfCase>& meshes)
{
  const std::string interval = std::to_string(heatInterval(setup));
  std::string text;
  for (const MeshOfCase& mesh : meshes)
  {
    text += "    heat_" + mesh.region + "\n    {\n        type wallHeatFlux;\n" +
      "        libs (fieldFunctionObjects);\n        region " + mesh.region +
      ";\n        log false;\n        executeControl timeStep;\n        executeInterval " +
      interval + ";\n        writeControl timeStep;\n        writeInterval " + interval +
      ";\n    }\n";
  }
  return text;
}

std::string heatCommands(
  const SolverSetup& setup, const std::vector<MeshOfCase>& meshes, const std::string& places)
{
  std::string solids;
  std::string sides;          // of interfaces, each once
  std::set<std::string> done; // regions
  for (const MeshOfCase& mesh : meshes)
  {
    if (!mesh.isFluid && isClosed(mesh))
    {
      solids = joined(solids, mesh.region);
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
  return filledIn(Commands,
    { { "@solids", solids }, { "@sides", sides }, { "@agreement", number(Agreement) },
      { "@places", places }, { "@first", meshes.front().region },
      { "@interval", std::to_string(heatInterval(setup)) },
      { "@most", std::to_string(setup.heatIterations) } });
}

}

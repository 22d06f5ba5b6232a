// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/LeastSystem.h"

#include "OpenFoam/FoamFile.h"

#include <array>
#include <fstream>
#include <iterator>

namespace cartesian
{

namespace
{

namespace fs = std::filesystem;

struct SystemFile
{
  const char* name;
  const char* text;
};

// With OpenFOAM's own 6 digits (transformPoints: 10), what its programs write anew loses the points' digits:
// the smallest faces become none.
constexpr std::array<SystemFile, 3> SystemFiles = { {
  { "controlDict",
    "application     potentialFoam;\nstartFrom       startTime;\nstartTime       0;\n"
    "stopAt          endTime;\nendTime         1;\ndeltaT          1;\n"
    "writeControl    timeStep;\nwriteInterval   1;\nwritePrecision  17;\n" },
  { "fvSchemes",
    "ddtSchemes { default steadyState; }\ngradSchemes { default Gauss linear; }\n"
    "divSchemes { default none; }\nlaplacianSchemes { default Gauss linear corrected; }\n"
    "interpolationSchemes { default linear; }\nsnGradSchemes { default corrected; }\n" },
  { "fvSolution", "solvers { }\n" },
} };

std::string textOf(const SystemFile& file)
{
  return std::string("// The least that checkMesh wants: adapt it to your solver.\n\n") + file.text;
}

}

void writeLeastSystem(const fs::path& folder, const std::string& region)
{
  const fs::path place = folder / "system" / region;
  fs::create_directories(place);
  for (const SystemFile& missing : SystemFiles)
  {
    // Those of a region are what a mesh needs, not a run.
    const bool isOfCase = std::string(missing.name) == "controlDict";
    if ((region.empty() || !isOfCase) && !fs::exists(place / missing.name))
    {
      FoamFile file(place / missing.name, FoamFormat::Ascii,
        { "dictionary", (fs::path("system") / region).lexically_normal().string(), {} });
      file.text(textOf(missing));
      file.close();
    }
  }
}

std::string decompositionOf(int pieces)
{
  return "numberOfSubdomains " + std::to_string(pieces) + ";\nmethod          scotch;\n";
}

bool isLeast(const fs::path& path)
{
  std::ifstream stream(path);
  const std::string text(
    (std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const std::string_view afterHeader =
    std::string_view(text).substr(std::min(text.find("}\n\n"), text.size()));
  for (const SystemFile& file : SystemFiles)
  {
    if (path.filename() == file.name && afterHeader == "}\n\n" + textOf(file))
    {
      return FoamFile::isOurs(path);
    }
  }
  return false;
}

}

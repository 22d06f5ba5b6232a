// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/PolyMeshFiles.h"

#include "Base/Error.h"

#include <algorithm>
#include <array>
#include <limits>

namespace cartesian
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* Location = "constant/polyMesh";
constexpr std::array<const char*, 5> MeshFiles = { "points", "faces", "owner", "neighbour",
  "boundary" };

constexpr const char* Zones = "cellZones";

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

// Whether the folder holds a mesh that we wrote, with these patches.
bool isReplaceable(const fs::path& polyMesh, const std::vector<FoamPatch>& patches)
{
  return std::all_of(MeshFiles.begin(), MeshFiles.end(),
           [&](const char* name) { return FoamFile::isOurs(polyMesh / name); }) &&
    FoamBoundary(polyMesh / "boundary").hasNamesOf(patches);
}

void writeBoundary(const FoamBoundary& boundary, const FoamMesh& mesh, const fs::path& folder)
{
  FoamFile file(folder / "boundary", FoamFormat::Ascii, { "polyBoundaryMesh", Location, {} });
  file.text(boundary.text(mesh.patches, mesh.faces.neighbour.size()));
  file.close();
}

void writeFaces(const FoamMesh& mesh, const fs::path& folder, FoamFormat format)
{
  const CellFaces& cells = mesh.cells;
  std::vector<std::size_t> start = { 0 };
  std::vector<std::uint32_t> corners;
  start.reserve(mesh.faces.face.size() + 1);
  for (const std::uint32_t face : mesh.faces.face)
  {
    const std::uint32_t* const begin = cells.corners.data() + cells.firstCorner[face];
    const std::uint32_t* const end = cells.corners.data() + cells.firstCorner[face + 1];
    corners.insert(corners.end(), begin, end);
    start.push_back(corners.size());
  }
  if (corners.size() > std::numeric_limits<std::int32_t>::max())
  {
    throw Error(Fault::BadMesh,
      "The mesh has more corners of faces than OpenFOAM can number in 32 bits: make it coarser.");
  }
  FoamFile file(folder / "faces", format,
    { format == FoamFormat::Binary ? "faceCompactList" : "faceList", Location, {} });
  file.labelLists(start, corners);
  file.close();
}

void writeLabels(const fs::path& path, const std::vector<std::uint32_t>& labels,
  const std::string& note, FoamFormat format)
{
  FoamFile file(path, format, { "labelList", Location, note });
  file.labels(labels.size(), [&](std::size_t i) { return labels[i]; });
  file.close();
}

void writeZones(const std::vector<FoamZone>& zones, const fs::path& folder)
{
  FoamFile file(folder / Zones, FoamFormat::Ascii, { "regIOobject", Location, {} });
  file.text(std::to_string(zones.size()) + "\n(\n");
  for (const FoamZone& zone : zones)
  {
    file.text(zone.name + "\n{\n    type cellZone;\n    cellLabels List<label> ");
    file.labels(zone.cells.size(), [&](std::size_t i) { return zone.cells[i]; });
    file.text(";\n}\n");
  }
  file.text(")\n");
  file.close();
}

void writeFiles(
  const FoamMesh& mesh, const FoamBoundary& boundary, const fs::path& folder, FoamFormat format)
{
  FoamFile points(folder / "points", format, { "vectorField", Location, {} });
  points.vectors(mesh.points);
  points.close();
  writeFaces(mesh, folder, format);
  const std::string note = "nPoints:" + std::to_string(mesh.points.size() / 3) +
    " nCells:" + std::to_string(mesh.cells.cellCount()) +
    " nFaces:" + std::to_string(mesh.faces.face.size()) +
    " nInternalFaces:" + std::to_string(mesh.faces.neighbour.size());
  writeLabels(folder / "owner", mesh.faces.owner, note, format);
  writeLabels(folder / "neighbour", mesh.faces.neighbour, note, format);
  writeBoundary(boundary, mesh, folder);
  if (!mesh.zones.empty())
  {
    writeZones(mesh.zones, folder);
  }
}

void writeSystem(const fs::path& folder)
{
  fs::create_directories(folder);
  for (const SystemFile& missing : SystemFiles)
  {
    if (!fs::exists(folder / missing.name))
    {
      FoamFile file(folder / missing.name, FoamFormat::Ascii, { "dictionary", "system", {} });
      file.text(std::string("// The least that checkMesh wants: adapt it to your solver.\n\n") +
        missing.text);
      file.close();
    }
  }
}

fs::path freeName(const fs::path& polyMesh)
{
  fs::path name = polyMesh;
  name += ".old";
  for (int i = 2; fs::exists(name); ++i)
  {
    name = polyMesh;
    name += ".old" + std::to_string(i);
  }
  return name;
}

// Renames the old folder, if there is one; the new name, or an empty one.
fs::path setAside(const fs::path& polyMesh)
{
  if (!fs::exists(polyMesh))
  {
    return {};
  }
  fs::path kept = freeName(polyMesh);
  fs::rename(polyMesh, kept);
  return kept;
}

// Removes the files of a mesh, and the folder if nothing else was in it: then the path is empty.
fs::path withoutMesh(const fs::path& kept)
{
  for (const char* name : MeshFiles)
  {
    fs::remove(kept / name);
  }
  if (FoamFile::isOurs(kept / Zones))
  {
    fs::remove(kept / Zones);
  }
  return fs::is_empty(kept) && fs::remove(kept) ? fs::path() : kept;
}

}

std::filesystem::path writePolyMesh(
  const FoamMesh& mesh, const std::filesystem::path& folder, FoamFormat format)
{
  const fs::path polyMesh = folder / Location;
  fs::path unfinished = polyMesh;
  unfinished += ".unfinished";
  try
  {
    writeSystem(folder / "system");
    const bool replaced = fs::exists(polyMesh) && isReplaceable(polyMesh, mesh.patches);
    fs::remove_all(unfinished);
    fs::create_directories(unfinished);
    writeFiles(mesh, replaced ? FoamBoundary(polyMesh / "boundary") : FoamBoundary(mesh.patches),
      unfinished, format);
    // The old mesh goes when the new one is there: whenever the program is killed, there is one of them.
    const fs::path kept = setAside(polyMesh);
    fs::rename(unfinished, polyMesh);
    return replaced ? withoutMesh(kept) : kept;
  }
  catch (const fs::filesystem_error& error)
  {
    throw Error(
      Fault::CannotWrite, std::string(error.what()) + ": choose another folder, or make room.");
  }
}

void createMarker(const std::filesystem::path& path)
{
  if (!std::ofstream(path, std::ios::app))
  {
    throw Error(Fault::CannotWrite, "Cannot write " + path.string() + ": choose another folder.");
  }
}

}

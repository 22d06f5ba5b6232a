// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/PolyMeshFiles.h"

#include "Base/Error.h"
#include "Base/Sorting.h"
#include "OpenFoam/FaceAreas.h"
#include "OpenFoam/LeastSystem.h"
#include "OpenFoam/RefinementLevels.h"
#include "OpenFoam/SymmetryPlanes.h"
#include "OpenFoam/ZoneFaces.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>

namespace cartesian
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t FacesAChunk = 1 << 14;

constexpr std::array<const char*, 5> MeshFiles = { "points", "faces", "owner", "neighbour",
  "boundary" };

// Those that not all meshes have.
constexpr const char* Zones = "cellZones";
constexpr const char* FaceZones = "faceZones";
constexpr std::array<const char*, 4> Addressing = { "pointProcAddressing", "faceProcAddressing",
  "cellProcAddressing", "boundaryProcAddressing" };
constexpr std::array<const char*, 3> Levels = { "cellLevel", "pointLevel", "level0Edge" };

// Whether the folder holds a mesh that we wrote, with these patches.
bool isReplaceable(const fs::path& polyMesh, const std::vector<FoamPatch>& patches)
{
  return std::all_of(MeshFiles.begin(), MeshFiles.end(),
           [&](const char* name) { return FoamFile::isOurs(polyMesh / name); }) &&
    FoamBoundary(polyMesh / "boundary").hasNamesOf(patches);
}

// A folder of mesh files.
struct Folder
{
  fs::path path;        // where they are written
  std::string location; // as they say
  FoamFormat format;
};

void writeBoundary(const FoamBoundary& boundary, const FoamMesh& mesh, const Folder& to)
{
  FoamFile file(to.path / "boundary", FoamFormat::Ascii, { "polyBoundaryMesh", to.location, {} });
  file.text(boundary.text(mesh.patches, mesh.neighbour.size()));
  file.close();
}

void writeFaces(const FoamMesh& mesh, const Folder& to)
{
  FoamFile file(to.path / "faces", to.format,
    { to.format == FoamFormat::Binary ? "faceCompactList" : "faceList", to.location, {} });
  file.labelLists(mesh.start, mesh.corners);
  file.close();
}

template <class Label>
void writeLabels(
  const char* name, const std::vector<Label>& labels, const std::string& note, const Folder& to)
{
  FoamFile file(to.path / name, to.format, { "labelList", to.location, note });
  file.labels(labels.size(), [&](std::size_t i) { return static_cast<std::int32_t>(labels[i]); });
  file.close();
}

void writeZones(const std::vector<FoamZone>& zones, const Folder& to)
{
  FoamFile file(to.path / Zones, FoamFormat::Ascii, { "regIOobject", to.location, {} });
  file.text(std::to_string(zones.size()) + "\n(\n");
  for (const FoamZone& zone : zones)
  {
    file.text(zone.name + "\n{\n    type cellZone;\n    cellLabels List<label> ");
    file.labels(
      zone.cells.size(), [&](std::size_t i) { return static_cast<std::int32_t>(zone.cells[i]); });
    file.text(";\n}\n");
  }
  file.text(")\n");
  file.close();
}

void writeFaceZones(const std::vector<FoamFaceZone>& zones, const Folder& to)
{
  FoamFile file(to.path / FaceZones, FoamFormat::Ascii, { "regIOobject", to.location, {} });
  file.text(std::to_string(zones.size()) + "\n(\n");
  for (const FoamFaceZone& zone : zones)
  {
    file.text(zone.name + "\n{\n    type faceZone;\n    faceLabels List<label> ");
    file.labels(
      zone.faces.size(), [&](std::size_t i) { return static_cast<std::int32_t>(zone.faces[i]); });
    file.text(";\n    flipMap List<bool> ");
    file.labels(zone.faces.size(), [&](std::size_t i) { return zone.isTurned[i] ? 1 : 0; });
    file.text(";\n}\n");
  }
  file.text(")\n");
  file.close();
}

void writePoints(const FoamMesh& mesh, const Folder& to)
{
  FoamFile points(to.path / "points", to.format, { "vectorField", to.location, {} });
  points.vectors(mesh.points);
  points.close();
}

void writeLevels(const RefinementLevels& levels, const Folder& to)
{
  writeLabels(Levels[0], levels.ofCells, {}, to);
  writeLabels(Levels[1], levels.ofPoints, {}, to);
  FoamFile file(
    to.path / Levels[2], FoamFormat::Ascii, { "uniformDimensionedScalarField", to.location, {} });
  file.text("dimensions      [0 1 0 0 0 0 0];\nvalue           ");
  file.decimal(levels.edge);
  file.text(";\n");
  file.close();
}

// Those that not all meshes have.
void writeExtras(const FoamMesh& mesh, const Folder& to)
{
  if (!mesh.zones.empty())
  {
    writeZones(mesh.zones, to);
  }
  if (!mesh.faceZones.empty())
  {
    writeFaceZones(mesh.faceZones, to);
  }
  if (mesh.addressing)
  {
    const FoamAddressing& addressing = *mesh.addressing;
    writeLabels(Addressing[0], addressing.points, {}, to);
    writeLabels(Addressing[1], addressing.faces, {}, to);
    writeLabels(Addressing[2], addressing.cells, {}, to);
    writeLabels(Addressing[3], addressing.patches, {}, to);
  }
  if (const std::optional<RefinementLevels> levels = refinementLevels(mesh))
  {
    writeLevels(*levels, to);
  }
}

void writeFiles(
  const FoamMesh& mesh, const FoamBoundary& boundary, const Folder& to, Execution& execution)
{
  const std::string note = "nPoints:" + std::to_string(mesh.points.size() / 3) +
    " nCells:" + std::to_string(mesh.cellCount) + " nFaces:" + std::to_string(mesh.owner.size()) +
    " nInternalFaces:" + std::to_string(mesh.neighbour.size());
  writeBoundary(boundary, mesh, to);
  const std::array<std::function<void()>, 5> files{ // the longest first
    [&] { writeFaces(mesh, to); }, [&] { writePoints(mesh, to); },
    [&] { writeLabels("owner", mesh.owner, note, to); },
    [&] { writeLabels("neighbour", mesh.neighbour, note, to); }, [&] { writeExtras(mesh, to); }
  };
  execution.forEach(files.size(), 1, [&](std::size_t i, std::size_t) { files[i](); });
}

void writeDecomposition(const fs::path& folder, int pieces)
{
  const fs::path path = folder / "system" / "decomposeParDict";
  if (!fs::exists(path))
  {
    FoamFile file(path, FoamFormat::Ascii, { "dictionary", "system", {} });
    file.text(decompositionOf(pieces));
    file.close();
  }
}

fs::path freeName(const fs::path& path)
{
  fs::path name = path;
  name += ".old";
  for (int i = 2; fs::exists(name); ++i)
  {
    name = path;
    name += ".old" + std::to_string(i);
  }
  return name;
}

// Renames the old file, if any; returns the new name, or an empty one.
fs::path setAside(const fs::path& path)
{
  if (!fs::exists(path))
  {
    return {};
  }
  fs::path kept = freeName(path);
  fs::rename(path, kept);
  return kept;
}

// Removes the files of a mesh, and the folder if nothing else was in it: then the path is empty.
fs::path withoutMesh(const fs::path& kept)
{
  for (const char* name : MeshFiles)
  {
    fs::remove(kept / name);
  }
  for (const char* name : { Zones, FaceZones, Addressing[0], Addressing[1], Addressing[2],
         Addressing[3], Levels[0], Levels[1], Levels[2] })
  {
    if (FoamFile::isOurs(kept / name))
    {
      fs::remove(kept / name);
    }
  }
  return fs::is_empty(kept) && fs::remove(kept) ? fs::path() : kept;
}

// Of a whole mesh.
std::vector<FoamPatch> withAreas(const FoamMesh& mesh, std::vector<FoamPatch> patches)
{
  std::size_t first = mesh.neighbour.size();
  for (FoamPatch& patch : patches)
  {
    patch.area = mesh.addressing ? 0 : areaOfFaces(mesh, first, patch.count);
    first += patch.count;
  }
  return patches;
}

fs::path unfinished(fs::path polyMesh)
{
  return polyMesh += ".unfinished";
}

// Whether a file of regions names all of these.
bool namesAll(const fs::path& file, const std::set<std::string>& regions)
{
  std::ifstream stream(file);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ';'; }, ' ');
  std::istringstream words(text);
  const std::set<std::string> found{ std::istream_iterator<std::string>(words), {} };
  return std::includes(found.begin(), found.end(), regions.begin(), regions.end());
}

}

FoamMesh foamMesh(std::vector<double> points, const CellFaces& cells, FaceList faces,
  std::vector<FoamPatch> patches, Execution& execution)
{
  FoamMesh mesh{ std::move(points), {}, {}, std::move(faces.owner), std::move(faces.neighbour),
    cells.cellCount(), std::move(patches) };
  const std::size_t count = faces.face.size();
  mesh.start.resize(count + 1);
  execution.forEach(count, FacesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
    {
      mesh.start[f] = cells.firstCorner[faces.face[f] + 1UL] - cells.firstCorner[faces.face[f]];
    }
  });
  mesh.corners.resize(scan(mesh.start));
  if (mesh.corners.size() > std::numeric_limits<std::int32_t>::max())
  {
    throw Error(Fault::BadMesh,
      "The mesh has more face corners than OpenFOAM can number in 32 bits: make it coarser.");
  }
  execution.forEach(count, FacesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
    {
      std::copy_n(cells.corners.data() + cells.firstCorner[faces.face[f]],
        mesh.start[f + 1] - mesh.start[f], mesh.corners.data() + mesh.start[f]);
    }
  });
  return mesh;
}

PolyMeshFiles::PolyMeshFiles(std::filesystem::path folder, FoamFormat format, FoamPlace place)
  : case_(std::move(folder))
  , folder_(place.pieces == 1 ? case_ : folderOfProcess(case_, place.piece))
  , format_(format)
  , place_(place)
{
}

PolyMeshFiles::~PolyMeshFiles()
{
  for (const Written& written : written_)
  {
    std::error_code ignored;
    fs::remove_all(unfinished(written.polyMesh), ignored);
    fs::path folder = written.polyMesh.parent_path();
    while (folder != case_ && fs::remove(folder, ignored)) // if it is empty
    {
      folder = folder.parent_path();
    }
  }
}

void PolyMeshFiles::write(const FoamMesh& mesh, const std::string& region, Execution& execution)
{
  reportingFailures([&] {
    const fs::path location = fs::path("constant") / region / "polyMesh";
    const fs::path polyMesh = folder_ / location;
    const bool replaces = fs::exists(polyMesh) && isReplaceable(polyMesh, mesh.patches);
    fs::remove_all(unfinished(polyMesh));
    fs::create_directories(unfinished(polyMesh));
    const FoamBoundary boundary =
      replaces ? FoamBoundary(polyMesh / "boundary") : FoamBoundary(withSymmetries(mesh));
    written_.push_back({ polyMesh, replaces, region, withAreas(mesh, boundary.typed(mesh.patches)),
      facesOfZones(mesh) });
    writeFiles(mesh, boundary, { unfinished(polyMesh), location.string(), format_ }, execution);
  });
}

void PolyMeshFiles::writeSystemOf(const std::string& region) const
{
  writeLeastSystem(case_, {});
  if (!region.empty())
  {
    writeLeastSystem(case_, region);
  }
  if (place_.pieces > 1)
  {
    writeDecomposition(case_, place_.pieces);
  }
}

std::vector<std::filesystem::path> PolyMeshFiles::replace()
{
  std::vector<fs::path> kept;
  reportingFailures([&] {
    for (const Written& written : written_)
    {
      if (place_.piece == 0)
      {
        writeSystemOf(written.region);
      }
      // The old mesh is removed once the new one is in place: whenever the program is killed, one of them exists.
      const fs::path old = setAside(written.polyMesh);
      fs::rename(unfinished(written.polyMesh), written.polyMesh);
      kept.push_back(written.replaces ? withoutMesh(old) : old);
    }
    if (!written_.empty() && !written_.front().region.empty() && place_.piece == 0)
    {
      writeRegionProperties(kept);
    }
  });
  kept.erase(std::remove(kept.begin(), kept.end(), fs::path()), kept.end());
  return kept;
}

std::vector<MeshOfCase> PolyMeshFiles::meshes() const
{
  std::vector<MeshOfCase> result;
  for (const Written& written : written_)
  {
    const bool flows = written.region.empty() || isFluid(written.region, written.patches);
    result.push_back({ written.region, flows, written.patches, written.zones });
  }
  return result;
}

void PolyMeshFiles::writeRegionProperties(std::vector<std::filesystem::path>& kept) const
{
  std::string fluid;
  std::string solid;
  std::set<std::string> regions;
  for (const Written& written : written_)
  {
    (isFluid(written.region, written.patches) ? fluid : solid) += " " + written.region;
    regions.insert(written.region);
  }
  const fs::path path = case_ / "constant" / "regionProperties";
  fs::create_directories(path.parent_path());
  if (fs::exists(path) && namesAll(path, regions))
  {
    return;
  }
  kept.push_back(setAside(path));
  FoamFile file(path, FoamFormat::Ascii, { "dictionary", "constant", {} });
  file.text("// fluid: regions whose names begin with fluid, or that flow passes "
            "through.\n\nregions\n(\n    fluid (" +
    fluid + " )\n    solid (" + solid + " )\n);\n");
  file.close();
}

std::filesystem::path folderOfProcess(const std::filesystem::path& folder, int process)
{
  return folder / ("processor" + std::to_string(process));
}

void createMarker(const std::filesystem::path& path)
{
  if (!std::ofstream(path, std::ios::app))
  {
    throw Error(Fault::CannotWrite, "Cannot write " + path.string() + ": choose another folder.");
  }
}

}

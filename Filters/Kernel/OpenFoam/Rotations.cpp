// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/Rotations.h"

#include "Base/Range.h"
#include "OpenFoam/Rows.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cartesian
{

namespace
{

constexpr const char* Automatic = "automatic";
constexpr const char* NoneStill = "none";

double radiansPerSecond(double rpm)
{
  constexpr double Pi = 3.14159265358979323846;
  return rpm * 2 * Pi / 60;
}

std::string pointOf(const std::array<double, 3>& at)
{
  return "(" + number(at[0]) + " " + number(at[1]) + " " + number(at[2]) + ")";
}

std::vector<std::string> wordsOf(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

// As the user wrote; none, if the choice is not the user's.
std::vector<std::string> namedStill(const Rotation& row)
{
  const bool isWord = row.stillBoundaries == Automatic || row.stillBoundaries == NoneStill;
  return isWord ? std::vector<std::string>() : wordsOf(row.stillBoundaries);
}

bool isStill(const FoamPatch& patch, const Rotation& row, std::size_t facesInside)
{
  const std::vector<std::string> named = namedStill(row);
  return row.stillBoundaries == Automatic
    ? facesInside < patch.count
    : std::any_of(named.begin(), named.end(),
        [&](const std::string& name) { return isOf(patch.name, name); });
}

TurningZone turningZone(const ZoneOfMesh& zone, const Rotation& row, const MeshOfCase& mesh,
  const std::optional<FlowAround>& around)
{
  TurningZone result{ zone.name, row, {}, {}, {} };
  for (std::size_t i = 0; i < mesh.patches.size(); ++i)
  {
    const FoamPatch& patch = mesh.patches[i];
    const PatchRole role = roleOf(patch, around);
    if (zone.faces[i] == 0 || role == PatchRole::Constraint)
    {
      continue;
    }
    if (role != PatchRole::Wall || isStill(patch, row, zone.faces[i]))
    {
      result.still.push_back(patch.name);
      continue;
    }
    result.turning.push_back(patch.name);
    if (zone.faces[i] < patch.count)
    {
      result.outside.push_back(patch.name);
    }
  }
  return result;
}

std::vector<std::string> zoneNamesOf(const std::vector<MeshOfCase>& meshes)
{
  std::vector<std::string> names;
  for (const MeshOfCase& mesh : meshes)
  {
    const std::vector<std::string> more = namesOf(mesh.zones, &ZoneOfMesh::name);
    names.insert(names.end(), more.begin(), more.end());
  }
  return names;
}

[[noreturn]] void refuse(const std::string& what)
{
  throw Error(Fault::BadParameter, "Rotating Zones: " + what);
}

void requireNumbers(const Rotation& row)
{
  constexpr double Most = 1e30;
  const std::string of = ": of zone " + row.zone;
  requireInRange(Range{ -Most, Most }, row.speed, "Rotation Speeds" + of);
  for (int axis = 0; axis < 3; ++axis)
  {
    requireInRange(Range{ -Most, Most }, row.origin[axis], "Rotation Origins" + of);
    requireInRange(Range{ -Most, Most }, row.axis[axis], "Rotation Axes" + of);
  }
  if (row.speed == 0)
  {
    refuse("zone " + row.zone +
      " has a speed of 0. Nothing is written: give its speed in rpm, or remove the row.");
  }
  if (row.axis == std::array<double, 3>{ 0, 0, 0 })
  {
    refuse("zone " + row.zone +
      " has an axis of length 0. Nothing is written: give it a direction, such as 0 0 1.");
  }
}

void requireBoundaries(const Rotation& row, const std::vector<MeshOfCase>& meshes)
{
  std::vector<std::string> names;
  for (const MeshOfCase& mesh : meshes)
  {
    const std::vector<std::string> more = namesOf(mesh.patches, &FoamPatch::name);
    names.insert(names.end(), more.begin(), more.end());
  }
  for (const std::string& still : namedStill(row))
  {
    if (std::none_of(
          names.begin(), names.end(), [&](const std::string& name) { return isOf(name, still); }))
    {
      refuse("zone " + row.zone + ": no boundary is called \"" + still + "\", only " +
        listOf(names, ", ") +
        ". Nothing is written: correct the name, or set Still Boundaries to automatic or none.");
    }
  }
}

std::string inWords(const TurningZone& zone)
{
  const auto orNothing = [](const std::vector<std::string>& names) {
    return names.empty() ? std::string("nothing") : listOf(names, ", ");
  };
  return "Zone " + zone.name + " turns at " + number(zone.row.speed) + " rpm (" +
    number(radiansPerSecond(zone.row.speed)) +
    " rad/s). Boundaries in it that turn along: " + orNothing(zone.turning) +
    "; that stay still: " + orNothing(zone.still) + ". Still Boundaries changes that.\n";
}

}

std::vector<TurningZone> turningZones(
  const SolverSetup& setup, const MeshOfCase& mesh, const std::optional<FlowAround>& around)
{
  std::vector<TurningZone> zones;
  for (const ZoneOfMesh& zone : mesh.zones)
  {
    if (const Rotation* const row = rowFor(setup.rotations, &Rotation::zone, zone.name))
    {
      zones.push_back(turningZone(zone, *row, mesh, around));
    }
  }
  return zones;
}

std::optional<std::string> velocityOutside(
  const std::vector<TurningZone>& zones, const FoamPatch& patch)
{
  const auto found = std::find_if(zones.begin(), zones.end(), [&](const TurningZone& zone) {
    return std::find(zone.outside.begin(), zone.outside.end(), patch.name) != zone.outside.end();
  });
  if (found == zones.end())
  {
    return {};
  }
  return "type rotatingWallVelocity; origin " + pointOf(found->row.origin) + "; axis " +
    pointOf(found->row.axis) + "; omega " + number(radiansPerSecond(found->row.speed)) +
    "; value uniform (0 0 0);";
}

void writeRotations(const std::vector<TurningZone>& zones, CaseFiles& files)
{
  const std::filesystem::path path = "constant/MRFProperties";
  if (zones.empty() && !files.has(path))
  {
    return;
  }
  std::string text;
  for (const TurningZone& zone : zones)
  {
    text += files.text("flow/MRFProperties",
      { { "zone", zone.name }, { "still", listOf(zone.still, " ") },
        { "origin", pointOf(zone.row.origin) }, { "axis", pointOf(zone.row.axis) },
        { "omega", number(radiansPerSecond(zone.row.speed)) },
        { "speed", number(zone.row.speed) } });
  }
  files.dictionary(path, text);
}

std::string rotationsInWords(const SolverSetup& setup, const std::vector<MeshOfCase>& meshes,
  const std::optional<FlowAround>& around)
{
  std::string text;
  for (const MeshOfCase& mesh : meshes)
  {
    for (const TurningZone& zone : turningZones(setup, mesh, around))
    {
      text += inWords(zone);
    }
  }
  return text;
}

void requireSuitableRotations(const SolverSetup& setup, const std::vector<MeshOfCase>& meshes)
{
  if (setup.rotations.empty())
  {
    return;
  }
  if (setup.solver == Solver::ConjugateHeat)
  {
    refuse("zones turn in Incompressible and Transient only. Nothing is written: remove the rows, "
           "or choose one of these.");
  }
  const std::vector<std::string> names = zoneNamesOf(meshes);
  if (names.empty())
  {
    refuse("the mesh has no zones. Nothing is written: give the boundary around what turns the "
           "type zone, and name it in Zone Regions.");
  }
  requireRowsFit(namesOf(setup.rotations, &Rotation::zone), names, "Rotating Zones", "zone");
  for (const Rotation& row : setup.rotations)
  {
    requireNumbers(row);
    requireBoundaries(row, meshes);
  }
}

}

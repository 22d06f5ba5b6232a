// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Regions.h"

#include "Base/Error.h"
#include "Repair/Arrangement.h"
#include "Repair/SheetRims.h"
#include "Repair/SurfaceRepair.h"
#include "Repair/WallsOfBodies.h"
#include "Surface/Places.h"

#include <algorithm>

namespace cartesian
{

namespace
{

std::string nameOf(std::int32_t region, const std::vector<std::string>& names)
{
  const auto n = static_cast<std::size_t>(region - FirstRegion);
  return n < names.size() ? "\"" + names[n] + "\"" : std::to_string(region);
}

// The surface of one region, oriented.
Surface surfaceOf(const Surface& all, std::int32_t region, const Meshlines& planes,
  const RegionSpec& spec, Execution& execution)
{
  Surface own;
  own.lattice = all.lattice;
  own.vertices = all.vertices;
  for (std::size_t t = 0; t < all.triangles.size(); ++t)
  {
    if (all.region[t] == region && !namesAVertexTwice(all.triangles[t]))
    {
      own.triangles.push_back(all.triangles[t]);
      own.boundary.push_back(all.boundary[t]);
      own.given.push_back(all.given[t]);
      own.region.push_back(region);
    }
  }
  const std::string name = "The surface of region " + nameOf(region, spec.names);
  if (own.triangles.empty())
  {
    throw Error(
      Fault::FlawedSurface, name + " has no triangles: give it a closed surface, or leave it out.");
  }
  const SurfaceRepair repaired =
    closeAndOrient(own, planes, { SheetHandling::LeaveOut }, execution);
  if (!repaired.check.oriented())
  {
    const auto& flaw = repaired.check.places.front();
    throw Error(Fault::FlawedSurface,
      name + " is not closed at " + placeOf(own, middleOf(own, flaw.triangle)) +
        ": with several regions, each needs a closed surface. Close it there.");
  }
  return own;
}

void append(const Surface& from, Surface& to)
{
  for (std::size_t t = 0; t < from.triangles.size(); ++t)
  {
    if (!namesAVertexTwice(from.triangles[t]))
    {
      to.append(from, t);
    }
  }
}

std::vector<SheetPair> sheetsOf(const Surface& all, SheetHandling handling, Execution& execution)
{
  const SurfaceEdges edges(all, execution);
  std::vector<SheetPair> sheets =
    findSheets(all, handling, edges, findDuplicates(all, edges, execution));
  sheets.erase(std::remove_if(sheets.begin(), sheets.end(),
                 [&](const SheetPair& pair) { return all.region[pair[0]] != all.region[pair[1]]; }),
    sheets.end());
  return sheets;
}

// The sheets of all regions, out of their surfaces.
Surface takeSheets(Surface& all, SheetHandling handling, Execution& execution)
{
  std::vector<SheetPair> found = sheetsOf(all, handling, execution);
  if (!found.empty() && joinRimsOfSheets(all, found, execution))
  {
    found = sheetsOf(all, handling, execution);
  }
  Surface sheets;
  for (const SheetPair& pair : found)
  {
    for (const std::uint32_t t : pair)
    {
      sheets.append(all, t);
      all.triangles[t].fill(0);
    }
  }
  return sheets;
}

std::vector<std::string> namesOfParts(
  const std::vector<std::int32_t>& given, const std::vector<std::string>& names)
{
  std::vector<std::string> result;
  for (const std::int32_t region : given)
  {
    const auto n = static_cast<std::size_t>(region - FirstRegion);
    result.push_back(n < names.size() ? names[n] : std::to_string(region));
  }
  return result;
}

// The walls of all regions, which are cut along each other; in other ways where some then still cross, or where that
// costs volume and others do not.
Surface arrangedWalls(
  Surface& all, const Bodies& bodies, std::vector<std::uint32_t>& crossing, Execution& execution)
{
  const Surface given = all;
  const bool isArranged = arrange(all, execution);
  Surface walls = wallsOf(all, bodies, crossing, execution);
  bool isRight = crossing.empty() && (!isArranged || keepsVolume(given, all, placingOf(given)));
  const std::array<Placing, 4> others = otherPlacingsOf(given);
  for (std::size_t i = 0; i < others.size() && !isRight; ++i)
  {
    Surface arranged = given;
    if (!arrange(arranged, others[i], execution) || !keepsVolume(given, arranged, others[i]))
    {
      continue;
    }
    std::vector<std::uint32_t> stillCrossing;
    Surface found = wallsOf(arranged, bodies, stillCrossing, execution);
    if (stillCrossing.empty())
    {
      walls = std::move(found);
      crossing.clear();
      isRight = true;
    }
  }
  return walls;
}

}

std::optional<std::vector<ClosedContact>> separateRegions(
  Surface& surface, const Meshlines& planes, const RegionSpec& spec, Execution& execution)
{
  requireInRange(RegionSpec::ContactTolerances, spec.contactTolerance, "Contact Tolerance");
  std::vector<std::string> names = spec.names;
  std::int32_t regions = *std::max_element(surface.region.begin(), surface.region.end());
  Surface given = surface;
  const Surface sheets = takeBaffles(given, spec.baffles);
  Surface found = takeSheets(given, spec.sheets, execution);
  Surface all;
  all.lattice = surface.lattice;
  all.rounding = surface.rounding;
  all.vertices = given.vertices;
  for (std::int32_t region = FirstRegion; region <= regions; ++region)
  {
    append(surfaceOf(given, region, planes, spec, execution), all);
  }
  const double tolerance = spec.contactTolerance / surface.lattice.step();
  std::vector<std::int32_t> regionsOfParts;
  if (!sheets.triangles.empty())
  {
    const std::optional<RegionParts> parts =
      divideByBaffles(all, sheets, spec.baffles, regions, tolerance, names, execution);
    if (!parts)
    {
      return std::nullopt;
    }
    regionsOfParts = parts->given;
    regions = static_cast<std::int32_t>(regionsOfParts.size());
    names = namesOfParts(regionsOfParts, names);
  }
  for (std::int32_t& region : found.region)
  {
    region = regionOfSheets(region, regions);
  }
  const Bodies bodies{ regions, regionsOfParts };
  std::vector<ClosedContact> contacts;
  std::vector<std::uint32_t> crossing;
  Surface walls;
  if (tolerance > 0)
  {
    Surface arranged;
    walls =
      wallsWithContacts(all, found, bodies, { tolerance }, contacts, arranged, crossing, execution);
    if (!crossing.empty())
    {
      all = std::move(arranged);
    }
  }
  for (ClosedContact& contact : contacts)
  {
    contact.names = { nameOf(contact.earlier, names), nameOf(contact.later, names) };
  }
  if (contacts.empty() && crossing.empty())
  {
    append(found, all);
    walls = arrangedWalls(all, bodies, crossing, execution);
  }
  if (!crossing.empty())
  {
    throw Error(Fault::FlawedSurface,
      "The surface of region " + nameOf(all.region[crossing[0]], names) +
        " intersects others or itself near " + placeOf(all, middleOf(all, crossing[0])) +
        " in many nearly coplanar faces, so it is uncertain what lies on which side. Choose a "
        "Contact Tolerance larger than the gap between walls that should touch, or cut one body "
        "out of the other; of a CAD file, glue the solids (Glue Solids).");
  }
  std::swap(surface.vertices, walls.vertices);
  surface.triangles.swap(walls.triangles);
  surface.boundary.swap(walls.boundary);
  surface.given.swap(walls.given);
  surface.ofSheet.swap(walls.ofSheet);
  surface.region.clear();
  surface.walls = std::move(walls.walls);
  surface.walls.given = regionsOfParts;
  for (std::int32_t region = FirstRegion; region <= regions; ++region)
  {
    const auto isOf = [&](
                        const Wall& wall) { return wall.behind == region || wall.front == region; };
    if (std::none_of(surface.walls.all.begin(), surface.walls.all.end(), isOf))
    {
      throw Error(Fault::FlawedSurface,
        "Nothing is left of region " + nameOf(region, names) +
          ": it lies inside regions listed before it. List it before them, or leave it out.");
    }
  }
  return contacts;
}

}

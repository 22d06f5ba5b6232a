// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Zones.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Turns walls so that the earlier region is behind them, and the outside in front. Whether that changed its normal.
bool turnWall(Wall& wall)
{
  const bool turns =
    wall.behind == OutsideRegion || (wall.front != OutsideRegion && wall.front < wall.behind);
  if (turns)
  {
    std::swap(wall.behind, wall.front);
    std::swap(wall.boundary, wall.boundaryInFront);
  }
  if (wall.front == OutsideRegion)
  {
    wall.boundaryInFront = NoBoundary;
  }
  return turns;
}

}

std::vector<ClosedContact> separateZones(Surface& surface, const std::vector<std::int32_t>& zones,
  const Meshlines& planes, RegionSpec spec, Execution& execution)
{
  const auto isZone = [&](std::int32_t boundary) {
    return std::find(zones.begin(), zones.end(), boundary) != zones.end();
  };
  const bool hasBodies = !std::all_of(surface.boundary.begin(), surface.boundary.end(), isZone);
  const std::int32_t firstZone = FirstRegion + (hasBodies ? 1 : 0);
  for (const std::int32_t boundary : surface.boundary)
  {
    const auto zone = std::find(zones.begin(), zones.end(), boundary);
    surface.region.push_back(zone == zones.end()
        ? FirstRegion
        : firstZone + static_cast<std::int32_t>(zone - zones.begin()));
  }
  if (hasBodies)
  {
    spec.names.insert(spec.names.begin(), "bodies");
  }
  std::vector<ClosedContact> contacts =
    separateRegions(surface, planes, spec, execution).value_or(std::vector<ClosedContact>());
  const auto numberOf = [&](std::int32_t region) {
    return region == OutsideRegion ? FirstRegion
      : region < firstZone         ? OutsideRegion
                                   : FirstRegion + 1 + region - firstZone;
  };
  std::vector<std::uint8_t> turns;
  for (Wall& wall : surface.walls.all)
  {
    if (wall.front == OutsideRegion)
    {
      wall.boundaryInFront = wall.boundary;
    }
    wall.behind = numberOf(wall.behind);
    wall.front = numberOf(wall.front);
    turns.push_back(turnWall(wall) ? 1 : 0);
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (turns[static_cast<std::size_t>(surface.boundary[t])] != 0)
    {
      std::swap(surface.triangles[t][1], surface.triangles[t][2]);
    }
  }
  surface.around = Winding{ FirstRegion, false };
  return contacts;
}

}

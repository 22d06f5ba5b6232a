// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/ZoneFaces.h"

#include <algorithm>

namespace cartesian
{

namespace
{

std::vector<std::size_t> facesOf(const FoamZone& zone, const FoamMesh& mesh)
{
  std::vector<bool> isInside(mesh.cellCount, false);
  for (const std::uint32_t cell : zone.cells)
  {
    isInside[cell] = true;
  }
  std::vector<std::size_t> counts;
  counts.reserve(mesh.patches.size());
  auto owner = mesh.owner.begin() + static_cast<std::ptrdiff_t>(mesh.neighbour.size());
  for (const FoamPatch& patch : mesh.patches)
  {
    const auto end = owner + static_cast<std::ptrdiff_t>(patch.count);
    counts.push_back(static_cast<std::size_t>(
      std::count_if(owner, end, [&](std::uint32_t cell) { return isInside[cell]; })));
    owner = end;
  }
  return counts;
}

}

std::vector<ZoneOfMesh> facesOfZones(const FoamMesh& mesh)
{
  std::vector<ZoneOfMesh> zones;
  if (mesh.addressing)
  {
    return zones;
  }
  zones.reserve(mesh.zones.size());
  for (const FoamZone& zone : mesh.zones)
  {
    zones.push_back({ zone.name, facesOf(zone, mesh) });
  }
  return zones;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/SurfaceRepair.h"

#include "Repair/Arrangement.h"
#include "Repair/Orientation.h"
#include "Repair/ThinSheets.h"
#include "Repair/WallsOfBodies.h"
#include "Surface/Components.h"

#include <algorithm>

namespace cartesian
{

namespace
{

std::vector<DroppedTriangle> dropLoose(Surface& surface, const SurfaceEdges& edges)
{
  std::vector<std::uint8_t> openEdges(surface.triangles.size());
  edges.forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
    if (end - begin == 1)
    {
      ++openEdges[begin->triangle()];
    }
  });
  std::vector<DroppedTriangle> dropped;
  for (std::uint32_t t = 0; t < openEdges.size(); ++t)
  {
    if (openEdges[t] == 3)
    {
      dropped.push_back({ t, surface.triangles[t] });
      surface.triangles[t].fill(surface.triangles[t][0]);
    }
  }
  return dropped;
}

// Of the triangles that are not dropped.
std::size_t turnedSince(
  const std::vector<std::array<std::uint32_t, 3>>& before, const Surface& surface)
{
  std::size_t turned = 0;
  for (std::size_t t = 0; t < before.size(); ++t)
  {
    const auto& now = surface.triangles[t];
    turned += now[1] != now[2] && now[1] == before[t][2] && now[2] == before[t][1] ? 1 : 0;
  }
  return turned;
}

// Marks the components with an edge that more triangles use in one direction than in the other.
void findUnoriented(Surface& surface, const SurfaceEdges& edges)
{
  DisjointSets components = connectedComponents(surface);
  std::vector<std::uint8_t> unoriented(surface.vertices.size());
  edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
    const auto down = std::count_if(begin, end, [](const EdgeUse& use) { return use.down(); });
    if (2 * down != end - begin)
    {
      unoriented[components.find(lower)] = 1;
    }
  });
  if (std::count(unoriented.begin(), unoriented.end(), 1) == 0)
  {
    return;
  }
  surface.byParity.resize(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    surface.byParity[t] = unoriented[components.find(surface.triangles[t][0])];
  }
}

}

std::size_t SurfaceRepair::leaks() const
{
  return static_cast<std::size_t>(
    std::count_if(holes.begin(), holes.end(), [](const Hole& hole) { return hole.leak; }));
}

SurfaceRepair closeAndOrient(Surface& surface, const Meshlines& planes, Execution& execution)
{
  SurfaceRepair result;
  {
    const SurfaceEdges edges(surface, execution);
    result.duplicates = dropDuplicates(surface, edges, findDuplicates(surface, edges));
  }
  const std::vector<std::array<std::uint32_t, 3>> given = surface.triangles;
  result.pairs = findPairs(surface, execution);
  orient(surface, result.pairs, execution);
  const SurfaceEdges edges(surface, execution);
  result.check = check(edges, execution);
  if (!result.check.closed())
  {
    result.loose = dropLoose(surface, edges);
    result.holes = closeHoles(surface, SurfaceEdges(surface, execution), planes, execution);
    result.pairs = findPairs(surface, execution);
    orient(surface, result.pairs, execution);
    findUnoriented(surface, SurfaceEdges(surface, execution));
  }
  else if (!result.check.oriented())
  {
    findUnoriented(surface, edges);
  }
  result.turned = turnedSince(given, surface);
  return result;
}

SurfaceRepair repair(Surface& surface, const Meshlines& planes, Execution& execution)
{
  if (std::getenv("CARTESIAN_SHEETS"))
  {
    std::printf("%zu pairs of sheets\n", giveSidesToSheets(surface, execution));
  }
  SurfaceRepair result = closeAndOrient(surface, planes, execution);
  if (result.pairs.pairs.empty() || !surface.byParity.empty() || !isFinelyPlaced(surface))
  {
    return result;
  }
  Surface arranged = surface;
  arranged.region.assign(surface.triangles.size(), FirstRegion);
  arrange(arranged, execution);
  if (unite(arranged, execution))
  {
    result.crossing = std::make_shared<const Surface>(std::move(surface));
    surface = std::move(arranged);
  }
  return result;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/SurfaceRepair.h"

#include "Repair/Orientation.h"
#include "Repair/SheetRims.h"
#include "Repair/TriangleTree.h"
#include "Repair/UnitedBodies.h"
#include "Surface/Components.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Of the triangles that are not dropped, nor of sheets.
std::size_t turnedSince(
  const std::vector<std::array<std::uint32_t, 3>>& before, const Surface& surface)
{
  std::size_t turned = 0;
  for (std::size_t t = 0; t < before.size(); ++t)
  {
    const auto& now = surface.triangles[t];
    turned +=
      !surface.isOfSheet(t) && now[1] != now[2] && now[1] == before[t][2] && now[2] == before[t][1]
      ? 1
      : 0;
  }
  return turned;
}

// Shells of sheets as they were oriented out of them before, or all into them where their surroundings are meshed. So what
// lies in a shell is not, and what lies on either side of it is as it was.
void turnSheets(
  const std::vector<std::array<std::uint32_t, 3>>& before, MeshedSide meshed, Surface& surface)
{
  for (std::size_t t = 0; meshed != MeshedSide::Unknown && t < surface.ofSheet.size(); ++t)
  {
    auto& triangle = surface.triangles[t];
    if (surface.ofSheet[t] != 0 && !namesAVertexTwice(triangle))
    {
      triangle = before[t];
      if (meshed == MeshedSide::Inside)
      {
        std::swap(triangle[1], triangle[2]);
      }
    }
  }
}

// Returns the pairs of triangles that cross.
TrianglePairs orientByPairs(Surface& surface, Execution& execution)
{
  const TriangleTree tree(surface, execution);
  TrianglePairs pairs = findPairs(surface, tree, execution);
  orient(surface, pairs, tree, execution);
  return pairs;
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

// Gives sheets sides, and drops other duplicates.
void keepSheets(Surface& surface, const SurfaceEdges& edges, const std::vector<SheetPair>& sheets,
  SurfaceRepair& result, Execution& execution)
{
  for (const SheetPair& pair : sheets)
  {
    result.sheets.push_back({ pair[0], surface.triangles[pair[0]] });
    result.sheets.push_back({ pair[1], surface.triangles[pair[1]] });
  }
  giveSides(surface, edges, sheets);
  const SurfaceEdges others(surface, execution);
  result.duplicates = dropDuplicates(surface, others, findDuplicates(surface, others, execution));
}

// Drops duplicates, except sheets, which get sides.
void handleDuplicates(
  Surface& surface, const RepairSpec& spec, SurfaceRepair& result, Execution& execution)
{
  const SurfaceEdges edges(surface, execution);
  const Duplicates duplicates = findDuplicates(surface, edges, execution);
  const std::vector<SheetPair> kept = findSheets(surface, spec.sheets, edges, duplicates);
  const auto all = std::count_if(surface.triangles.begin(), surface.triangles.end(),
    [](const auto& triangle) { return !namesAVertexTwice(triangle); });
  const bool areAll = 2 * kept.size() == static_cast<std::size_t>(all); // around nothing
  if (kept.empty() || (areAll && spec.meshed == MeshedSide::Inside))
  {
    result.duplicates = dropDuplicates(surface, edges, duplicates);
    return;
  }
  if (!joinRimsOfSheets(surface, kept, execution))
  {
    keepSheets(surface, edges, kept, result, execution);
    return;
  }
  const SurfaceEdges joined(surface, execution);
  keepSheets(surface, joined,
    findSheets(surface, spec.sheets, joined, findDuplicates(surface, joined, execution)), result,
    execution);
}

}

std::size_t SurfaceRepair::leaks() const
{
  return static_cast<std::size_t>(
    std::count_if(holes.begin(), holes.end(), [](const Hole& hole) { return hole.leak; }));
}

bool SurfaceRepair::areTouching(const TrianglePair& pair) const
{
  return !touching.empty() && touching[pair.first] != 0 && touching[pair.second] != 0;
}

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

SurfaceRepair closeAndOrient(
  Surface& surface, const Meshlines& planes, const RepairSpec& spec, Execution& execution)
{
  SurfaceRepair result;
  handleDuplicates(surface, spec, result, execution);
  const std::vector<std::array<std::uint32_t, 3>> given = surface.triangles;
  result.pairs = orientByPairs(surface, execution);
  turnSheets(given, spec.meshed, surface);
  const SurfaceEdges edges(surface, execution);
  result.check = check(edges, execution);
  if (!result.check.closed())
  {
    result.loose = dropLoose(surface, edges);
    result.holes = closeHoles(surface, SurfaceEdges(surface, execution), planes, execution);
    result.pairs = orientByPairs(surface, execution);
    turnSheets(given, spec.meshed, surface);
    findUnoriented(surface, SurfaceEdges(surface, execution));
  }
  else if (!result.check.oriented())
  {
    findUnoriented(surface, edges);
  }
  result.turned = turnedSince(given, surface);
  return result;
}

SurfaceRepair repair(
  Surface& surface, const Meshlines& planes, const RepairSpec& spec, Execution& execution)
{
  SurfaceRepair result = closeAndOrient(surface, planes, spec, execution);
  if (result.pairs.pairs.empty() && result.sheets.empty())
  {
    return result;
  }
  UnitedBodies united = uniteBodies(surface, result.sheets, spec.meshed, execution);
  result.crossing = std::move(united.before);
  result.refused = std::move(united.refused);
  result.touching = std::move(united.touching);
  if (result.crossing && !result.crossing->byParity.empty())
  {
    findUnoriented(surface, SurfaceEdges(surface, execution));
  }
  return result;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/SheetRims.h"

#include "Repair/BaffleRims.h"
#include "Repair/Snapping.h"
#include "Repair/Spaces.h"

namespace cartesian
{

namespace
{

// The first triangle of each pair; Surface::given is the pair's number.
Surface takeFirsts(const Surface& surface, const std::vector<SheetPair>& sheets)
{
  Surface firsts = surface.withoutTriangles();
  for (std::uint32_t p = 0; p < sheets.size(); ++p)
  {
    firsts.append(surface, sheets[p][0]);
    firsts.given.back() = p;
  }
  return firsts;
}

// Without those of the pairs.
Surface takeOthers(const Surface& surface, const std::vector<SheetPair>& sheets)
{
  std::vector<std::uint8_t> isTaken(surface.triangles.size());
  for (const SheetPair& pair : sheets)
  {
    isTaken[pair[0]] = isTaken[pair[1]] = 1;
  }
  Surface others = surface.withoutTriangles();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (isTaken[t] == 0)
    {
      others.append(surface, t);
    }
  }
  return others;
}

}

bool joinRimsOfSheets(Surface& surface, const std::vector<SheetPair>& sheets, Execution& execution)
{
  Surface given = surface;
  given.region.resize(given.triangles.size(), FirstRegion);
  Surface firsts = takeFirsts(given, sheets);
  Surface joined = takeOthers(given, sheets);
  if (!joinRims(joined, firsts, { placingOf(surface).snap, 0 }, execution).any)
  {
    return false;
  }
  joined.ofSheet.assign(joined.triangles.size(), 0);
  for (std::size_t t = 0; t < firsts.triangles.size(); ++t)
  {
    const auto& [first, second] = sheets[firsts.given[t]];
    firsts.given[t] = given.given[first];
    joined.append(firsts, t);
    joined.append(firsts, t);
    joined.given.back() = given.given[second];
    joined.boundary.back() = given.boundary[second];
    if (!faceAlike(given.triangles[first], given.triangles[second]))
    {
      std::swap(joined.triangles.back()[1], joined.triangles.back()[2]);
    }
  }
  joined.ofSheet.resize(joined.triangles.size(), 1);
  if (surface.region.empty())
  {
    joined.region.clear();
  }
  surface.vertices.swap(joined.vertices);
  surface.takeTriangles(joined);
  surface.ofSheet.swap(joined.ofSheet);
  return true;
}

}

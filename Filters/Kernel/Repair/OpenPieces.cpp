// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/OpenPieces.h"

#include "Base/DisjointSets.h"
#include "Surface/SurfaceEdges.h"

#include <algorithm>
#include <map>

namespace cartesian
{

std::vector<OpenPiece> openPiecesOf(
  const Surface& surface, const std::vector<std::uint8_t>& isLeftOut, Execution& execution)
{
  const auto isIn = [&](std::uint32_t t) { return isLeftOut.empty() || isLeftOut[t] == 0; };
  const auto isBeside = [&](std::uint32_t t, const EdgeUse& other) {
    return isIn(other.triangle()) &&
      (surface.region.empty() || surface.region[t] == surface.region[other.triangle()]);
  };
  DisjointSets connected(surface.triangles.size());
  std::vector<std::pair<std::uint32_t, std::array<std::uint32_t, 2>>> rims; // with triangles
  SurfaceEdges(surface, execution)
    .forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      for (const EdgeUse* use = begin; use != end; ++use)
      {
        const std::uint32_t t = use->triangle();
        const auto isLike = [&](const EdgeUse& other) { return isBeside(t, other); };
        const auto uses = isIn(t) ? std::count_if(begin, end, isLike) : 0;
        if (uses == 1)
        {
          rims.push_back({ t, { lower, begin->upper } });
        }
        if (uses == 2)
        {
          connected.unite(t, std::find_if(begin, end, isLike)->triangle());
        }
      }
    });
  std::map<std::uint32_t, OpenPiece> open; // by the lowest triangle
  for (const auto& [t, edge] : rims)
  {
    open[connected.find(t)].rim.push_back(edge);
  }
  for (std::uint32_t t = 0; t < surface.triangles.size() && !open.empty(); ++t)
  {
    const auto piece = open.find(connected.find(t));
    if (piece != open.end() && !namesAVertexTwice(surface.triangles[t]))
    {
      piece->second.triangles.push_back(t);
    }
  }
  std::vector<OpenPiece> pieces;
  for (auto& [lowest, piece] : open)
  {
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}

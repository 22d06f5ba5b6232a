// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Orientation.h"

#include "Lattice/Vector.h"
#include "Repair/Nesting.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// A closed sheet with at least one vote in so many on either side passes through itself.
constexpr long long VotesPerDissent = 4;

constexpr std::size_t TrianglesAChunk = 4096;

void turn(Surface& surface, std::size_t triangle)
{
  std::swap(surface.triangles[triangle][1], surface.triangles[triangle][2]);
}

// Six times the volume between each triangle and the surface's first corner.
std::vector<double> volumesBelow(const Surface& surface, Execution& execution)
{
  const Point base = surface.corners(0)[0];
  std::vector<double> volume(surface.triangles.size());
  execution.forEach(volume.size(), TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      const Corners c = surface.corners(t);
      volume[t] = dot(minus(c[0], base), cross(minus(c[1], c[0]), minus(c[2], c[0])));
    }
  });
  return volume;
}

// Decides which sheets must be reversed.
class Verdict
{
public:
  Verdict(const Surface& surface, const ManifoldComponents& sheets,
    const std::vector<TrianglePair>& pairs, const TriangleTree& tree, Execution& execution)
    : sheets_(sheets)
    , votes_(voteOnSheets(surface, sheets, tree, execution))
    , unturned_(surface.triangles.size())
  {
    shapes_.volume.resize(unturned_.size());
    std::vector<long long> size(unturned_.size());
    const std::vector<double> volume = volumesBelow(surface, execution);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const int direction = sheets.turned(t) ? -1 : 1;
      unturned_[sheets.of(t)] += direction;
      shapes_.volume[sheets.of(t)] += direction * volume[t];
      ++size[sheets.of(t)];
    }
    for (std::uint32_t s = 0; s < unturned_.size(); ++s)
    {
      shapes_.givenWay.push_back(givenWay(s, size[s]));
    }
    depth_ =
      depthsOf(shapes_, votes_, ComponentIntersections(surface, sheets, pairs, shapes_.volume));
  }

  // A tie between the votes on a sheet that does not pass through itself.
  bool isUndecided(std::uint32_t sheet) const
  {
    return votesOn(sheet).isTie() && !passesThroughItself(sheet);
  }

  // Whether the sheet's first triangle must be reversed.
  bool turns(std::uint32_t sheet) const
  {
    if (isUndecided(sheet))
    {
      return unturned_[sheet] < 0;
    }
    const bool facesIn =
      passesThroughItself(sheet) ? shapes_.volume[sheet] < 0 : !votesOn(sheet).isOutward();
    return facesIn != (depth_[sheet] % 2 == 1);
  }

private:
  int givenWay(std::uint32_t sheet, long long size) const
  {
    const long long way = unturned_[sheet];
    const double volume = shapes_.volume[sheet];
    return !sheets_.closed(sheet) || std::abs(way) != size || volume == 0
      ? 0
      : ((volume > 0) == (way > 0) ? 1 : -1);
  }

  bool isNested(std::uint32_t sheet) const { return votes_.samples[sheet] > 0; }

  // By itself where its depth is known.
  const RayParityVotes::OfFacing& votesOn(std::uint32_t sheet) const
  {
    return isNested(sheet) ? votes_.alone[sheet] : votes_.amongAll[sheet];
  }

  bool passesThroughItself(std::uint32_t sheet) const
  {
    const RayParityVotes::OfFacing& votes = votesOn(sheet);
    const long long fewer = std::min(votes.outward, votes.inward);
    return sheets_.closed(sheet) && fewer > 0 &&
      VotesPerDissent * fewer >= votes.outward + votes.inward;
  }

  const ManifoldComponents& sheets_;
  const RayParityVotes votes_;
  SheetShapes shapes_;
  std::vector<int> depth_;
  std::vector<long long>
    unturned_; // triangles that face as the sheet's first minus those that do not
};

}

void orient(
  Surface& surface, const TrianglePairs& pairs, const TriangleTree& tree, Execution& execution)
{
  const std::size_t count = surface.triangles.size();
  const ManifoldComponents sheets(surface, SurfaceEdges(surface, execution), execution);
  const Verdict verdict(surface, sheets, pairs.pairs, tree, execution);
  for (std::size_t t = 0; t < count; ++t)
  {
    if (sheets.turned(t) != verdict.turns(sheets.of(t)))
    {
      turn(surface, t);
    }
  }
  if (volumeOf(surface) < 0)
  {
    for (std::size_t t = 0; t < count; ++t)
    {
      if (verdict.isUndecided(sheets.of(t)))
      {
        turn(surface, t);
      }
    }
  }
}

}

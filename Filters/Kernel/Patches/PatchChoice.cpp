// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/PatchChoice.h"

namespace cartesian
{

namespace
{

bool isEdge(unsigned planes)
{
  return (planes & (planes - 1)) != 0;
}

}

PatchReason PatchChooser::choose(const Box& box, const BoxSurface& piece)
{
  if (crossesAnEdgeTwice(box, piece))
  {
    return PatchReason::EdgeCrossedTwice;
  }
  const bool followed = followLoops(piece);
  if (closedPolyline_)
  {
    return PatchReason::ClosedPolyline;
  }
  if (piece.sharp || turnsTooFar(piece))
  {
    return PatchReason::SharpFeature;
  }
  if (hasSeveralBoundaries(piece))
  {
    return PatchReason::SeveralBoundaries;
  }
  // The Euler characteristic is 1 for each disc.
  const std::size_t edges = (piece.corners.size() + piece.segments.size()) / 2;
  const bool discs = piece.points.size() + piece.sizes.size() == edges + loops_;
  return followed && discs && crossingsFitCorners(box) ? PatchReason::MarchingCubes
                                                       : PatchReason::NotDiscs;
}

bool PatchChooser::crossesAnEdgeTwice(const Box& box, const BoxSurface& piece)
{
  next_.assign(piece.points.size(), None);
  planes_.resize(piece.points.size());
  crossings_.fill(0);
  simple_ = true;
  bool twice = false;
  for (const Segment& s : piece.segments)
  {
    if (next_[s.from] != None)
    {
      simple_ = false;
      continue;
    }
    next_[s.from] = s.to;
    planes_[s.from] = planesOf(box, piece.points[s.from]);
    twice = twice || (isEdge(planes_[s.from]) && ++crossings_[planes_[s.from]] > 1);
  }
  return twice;
}

// Whether edges with one end inside are crossed once, and all others not at all.
bool PatchChooser::crossingsFitCorners(const Box& box) const
{
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const unsigned u = (axis + 1) % 3;
    const unsigned v = (axis + 2) % 3;
    for (unsigned edge = 0; edge < 4; ++edge)
    {
      const unsigned corner = (edge & 1) << u | (edge >> 1) << v;
      const unsigned planes = 1u << (2 * u + (edge & 1)) | 1u << (2 * v + (edge >> 1));
      const bool changes =
        ((box.corners >> corner ^ box.corners >> (corner | 1u << axis)) & 1) != 0;
      if (crossings_[planes] != (changes ? 1 : 0))
      {
        return false;
      }
    }
  }
  return true;
}

// A rounded edge with a radius much smaller than the box counts as sharp.
bool PatchChooser::turnsTooFar(const BoxSurface& piece) const
{
  Vector sum{ 0, 0, 0 };
  for (const std::uint32_t triangle : piece.triangles)
  {
    if (!features_.isFold(triangle))
    {
      sum = plus(sum, features_.normal[triangle]);
    }
  }
  const Vector mean = unit(sum);
  return std::any_of(piece.triangles.begin(), piece.triangles.end(), [&](std::uint32_t triangle) {
    const Vector& normal = features_.normal[triangle];
    return dot(normal, normal) > 0 && !features_.isFold(triangle) &&
      dot(normal, mean) < leastCosine_;
  });
}

bool PatchChooser::hasSeveralBoundaries(const BoxSurface& piece) const
{
  return std::any_of(piece.triangles.begin(), piece.triangles.end(), [&](std::uint32_t triangle) {
    return surface_.boundary[triangle] != surface_.boundary[piece.triangles[0]];
  });
}

// Follows the segments around. Returns false unless they form simple loops, each over three or more edges
// of the box.
bool PatchChooser::followLoops(const BoxSurface& piece)
{
  loops_ = 0;
  closedPolyline_ = false;
  bool proper = simple_;
  for (const Segment& first : piece.segments)
  {
    if (next_[first.from] == None)
    {
      continue; // followed already
    }
    ++loops_;
    std::size_t edges = 0;
    std::uint32_t point = first.from;
    while (next_[point] != None)
    {
      edges += isEdge(planes_[point]) ? 1 : 0;
      const std::uint32_t to = next_[point];
      next_[point] = None;
      point = to;
    }
    proper = proper && point == first.from && edges >= 3;
    closedPolyline_ = closedPolyline_ || (point == first.from && edges == 0);
  }
  return proper;
}

}

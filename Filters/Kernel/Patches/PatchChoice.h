// SPDX-License-Identifier: BSD-3-Clause
// Choice of the patching method (section 4.7).
#pragma once

#include "Lattice/Vector.h"
#include "Patches/BoxSurface.h"

namespace cartesian
{

// The reason for a box's method. If several conditions for Exact Fit hold, the first counts.
enum class PatchReason : std::uint8_t
{
  MarchingCubes = 0,     // no condition for Exact Fit holds
  EdgeCrossedTwice = 1,  // an edge of the box is crossed more than once
  ClosedPolyline = 2,    // the surface meets a side in a closed polyline
  SharpFeature = 3,      // a sharp feature passes through, or the surface turns as far gradually
  SeveralBoundaries = 4, // triangles of more than one boundary
  NotDiscs = 5, // the surface in the box is not a set of discs: a tunnel, a closed piece, a flaw
  ExactFitChosen = 6, // by the user
};

constexpr std::size_t PatchReasons = 7;

class PatchChooser
{
public:
  // `featureAngle` in degrees. In a Marching Cubes box the surface may differ by as much from its mean
  // normal.
  PatchChooser(const Surface& surface, const Features& features, double featureAngle)
    : surface_(surface)
    , features_(features)
    , leastCosine_(std::cos(radians(featureAngle)))
  {
  }

  PatchReason choose(const Box& box, const BoxSurface& piece);

private:
  bool crossesAnEdgeTwice(const Box& box, const BoxSurface& piece);
  bool crossingsFitCorners(const Box& box) const;
  bool turnsTooFar(const BoxSurface& piece) const;
  bool hasSeveralBoundaries(const BoxSurface& piece) const;
  bool followLoops(const BoxSurface& piece);

  const Surface& surface_;
  const Features& features_;
  double leastCosine_;
  std::vector<std::uint32_t> next_;          // of each point, along the segments
  std::vector<unsigned> planes_;             // of each point
  std::array<std::uint8_t, 64> crossings_{}; // of each edge, by the bits of its planes
  std::size_t loops_ = 0;
  bool simple_ = true; // whether at most one segment leaves each point
  bool closedPolyline_ = false;
};

}

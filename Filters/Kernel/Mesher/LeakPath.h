// SPDX-License-Identifier: BSD-3-Clause
// The way through which a point to keep out is reached, and the gaps that it passes.
//
// Method: the shortest way (Dijkstra's algorithm) on a grid of points whose lines the surface blocks (PointGrid.h). Lengths
// count more next to walls, so that the way runs through the middle of gaps; its distances from the walls are small in
// these: a gap is where one is a minimum, less than two thirds of what is before and behind. Around each a finer search,
// in which walls alone count, finds its middle.
// Limits: of several gaps side by side one is found, the shortest or a wider one nearby. The grid has as many points as
// Searches says: a narrower gap than these find has no way, only the message.
#pragma once

#include "Base/Error.h"
#include "Lattice/Vector.h"
#include "Surface/KeepPoints.h"

namespace cartesian
{

struct LeakGap
{
  std::array<Vector, 2> across; // from wall to wall, through the middle
  double width = 0;             // the distance between these
};

struct LeakPath
{
  std::vector<Vector> points; // none: no way was found
  std::vector<LeakGap> gaps;  // along it
};

struct LeakSearch
{
  Point low; // where to search
  Point high;
  double spacing = 0; // of points, levels, if there may be so many; less where no way is found
  const KeepPoint* from = nullptr; // none: the ends of what is searched
  const KeepPoint* to = nullptr;

  double diagonal() const;
  double spacingOf(double points) const; // that there would be
};

// In user units.
LeakPath findLeak(const Surface& walls, const LeakSearch& search, Execution& execution);

// A point to keep out is reached.
struct Leak : Error
{
  Leak(const LeakSearch& search, LeakPath way);

  LeakPath path;
};

}

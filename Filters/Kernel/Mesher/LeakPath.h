// SPDX-License-Identifier: BSD-3-Clause
// The way through which a point to keep out is reached (LeakWay.h), and the gaps that it passes (LeakGaps.h).
//
// Limits: of several gaps side by side one is found, the shortest or a wider one nearby. The grid has as many points as
// Searches says, and as the memory limit allows: a narrower gap than these find has no way, only the message.
#pragma once

#include "Base/Error.h"
#include "Lattice/Meshlines.h"
#include "Lattice/Vector.h"
#include "Surface/KeepPoints.h"

namespace cartesian
{

struct LeakGap
{
  std::array<Vector, 2> across; // from wall to wall, through the middle
  double width = 0;             // the distance between these

  Vector middle() const { return scaled(plus(across[0], across[1]), 0.5); }
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
  double spacing; // of points, levels, if there may be so many; less where no way is found
  double memory;  // of the grid of points, at most; bytes
  const KeepPoint* from = nullptr; // none: the ends of what is searched
  const KeepPoint* to = nullptr;

  // Between the outer planes, and so many levels around, for gaps as narrow as half a box's side.
  LeakSearch(const Meshlines& planes, Level around, double side, double most);

  double diagonal() const;
  double spacingOf(double points) const; // that there would be
};

// In user units. Reports progress.
LeakPath findLeak(const Surface& walls, const LeakSearch& search, Execution& execution);

// A point to keep out is reached.
struct Leak : Error
{
  Leak(const LeakSearch& search, LeakPath way);

  LeakPath path;
};

// Throws it.
[[noreturn]] void tellLeak(const Surface& walls, const LeakSearch& search, Execution& execution);

}

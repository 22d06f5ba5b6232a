// SPDX-License-Identifier: BSD-3-Clause
// Where axis-parallel lines cross the surface: the rays of section 4.4.
#pragma once

#include "Base/Rings.h"
#include "Base/Sorting.h"
#include "Lattice/TriangleSlicing.h"
#include "Surface/Surface.h"

namespace cartesian
{

// Where a triangle meets a plane across axes.outer: lines along axes.along in this plane cross it
// if their level along axes.middle is in [from, to).
struct CrossedLevels
{
  Level from;
  Level to;
  bool up; // the triangle's normal points up axes.along
};

// For a plane that passes through the triangle.
inline CrossedLevels crossedLevels(const Corners& triangle, const RowAxes& axes, Level outer)
{
  Level rising = 0; // where the triangle's outline passes up through the plane
  Level falling = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Point& p = triangle[i];
    const Point& q = following(triangle, i);
    if ((p[axes.outer] < outer) != (q[axes.outer] < outer))
    {
      const Level at = crossPlane(p, q, axes.outer, outer, axes.middle);
      (p[axes.outer] < outer ? rising : falling) = at;
    }
  }
  const bool rightHanded = (axes.along + 1) % 3 == axes.middle;
  return { std::min(rising, falling), std::max(rising, falling),
    (rising > falling) == rightHanded };
}

// Calls visit(middle, outer, point, up) for the crossings of a triangle with the lines along
// axes.along in which the planes middles[middle] and outers[outer] meet. `up`: the triangle's
// normal points up axes.along.
template <class Visitor>
void forEachLineCrossing(const Corners& triangle, const RowAxes& axes,
  const std::vector<Level>& middles, const std::vector<Level>& outers, Visitor&& visit)
{
  const auto [least, most] =
    std::minmax({ triangle[0][axes.outer], triangle[1][axes.outer], triangle[2][axes.outer] });
  for (auto o = std::lower_bound(outers.begin(), outers.end(), least);
       o != outers.end() && *o < most; ++o)
  {
    const auto [from, to, up] = crossedLevels(triangle, axes, *o);
    for (auto m = std::lower_bound(middles.begin(), middles.end(), from);
         m != middles.end() && *m < to; ++m)
    {
      Point at{};
      at[axes.outer] = *o;
      at[axes.middle] = *m;
      visit(static_cast<std::size_t>(m - middles.begin()),
        static_cast<std::size_t>(o - outers.begin()), crossLine(triangle, axes.along, at), up);
    }
  }
}

// Crossings of the surface with the mesh lines along one axis.
class LineCrossings
{
public:
  LineCrossings(const Surface& surface, const Meshlines& planes, int along, Execution& execution);

  const RowAxes& axes() const { return axes_; }

  // How the surface winds around the point where the line through planes `middle` and `outer` meets
  // the plane of axes().along with the index `plane`.
  Winding at(std::size_t middle, std::size_t outer, std::uint32_t plane) const
  {
    const LineCrossing* const first = begin(middle, outer);
    const LineCrossing* const above =
      std::upper_bound(first, end(middle, outer), LineCrossing{ 0, plane, {} });
    Winding winding = around_;
    return above == first ? winding : winding.add(above[-1].winding);
  }

private:
  struct LineCrossing
  {
    std::uint32_t line;        // middle + outer * planes of middle
    std::uint32_t planesBelow; // planes of axes.along below the crossing
    Winding winding;           // beyond it

    bool operator<(const LineCrossing& other) const { return planesBelow < other.planesBelow; }
  };

  const LineCrossing* begin(std::size_t middle, std::size_t outer) const
  {
    return crossings_.begin(middle + outer * linesOfMiddle_);
  }
  const LineCrossing* end(std::size_t middle, std::size_t outer) const
  {
    return crossings_.end(middle + outer * linesOfMiddle_);
  }

  RowAxes axes_;
  Winding around_;
  std::size_t linesOfMiddle_;
  Buckets<LineCrossing> crossings_; // by line
};

}

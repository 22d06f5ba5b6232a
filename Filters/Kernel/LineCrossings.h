// Where axis-parallel lines cross the surface (section 4.4: rays).
#pragma once

#include "Rows.h"
#include "Sorting.h"
#include "Surface.h"

namespace cartesian
{

// The levels along axes.middle between which a triangle meets the plane axes.outer = `outer`, which
// passes through it: lines along axes.along in this plane cross it from the first on, up to the
// second, which is left out.
inline std::pair<Level, Level> crossedLevels(
  const Corners& triangle, const RowAxes& axes, Level outer)
{
  std::array<Level, 2> ends{};
  int found = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Point& p = triangle[i];
    const Point& q = triangle[(i + 1) % 3];
    if ((p[axes.outer] < outer) != (q[axes.outer] < outer))
    {
      ends[found++] = crossPlane(p, q, axes.outer, outer)[axes.middle];
    }
  }
  return std::minmax(ends[0], ends[1]);
}

// Calls visit(middle, outer, point) for the crossings of a triangle with those lines along
// axes.along where middles[middle] meets outers[outer]: planes of the other two axes.
template <class Visitor>
void forEachLineCrossing(const Corners& triangle, const RowAxes& axes,
  const std::vector<Level>& middles, const std::vector<Level>& outers, Visitor&& visit)
{
  const auto [least, most] =
    std::minmax({ triangle[0][axes.outer], triangle[1][axes.outer], triangle[2][axes.outer] });
  for (auto o = std::lower_bound(outers.begin(), outers.end(), least);
       o != outers.end() && *o < most; ++o)
  {
    const auto [from, to] = crossedLevels(triangle, axes, *o);
    for (auto m = std::lower_bound(middles.begin(), middles.end(), from);
         m != middles.end() && *m < to; ++m)
    {
      Point at{};
      at[axes.outer] = *o;
      at[axes.middle] = *m;
      visit(static_cast<std::size_t>(m - middles.begin()),
        static_cast<std::size_t>(o - outers.begin()), crossLine(triangle, axes.along, at));
    }
  }
}

// Crossings of the surface with the mesh lines along one axis.
class LineCrossings
{
public:
  LineCrossings(const Surface& surface, const Meshlines& planes, int along, Execution& execution);

  const RowAxes& axes() const { return axes_; }

  // How often the line at these planes crosses the surface below the plane of axes().along with this
  // index.
  std::size_t below(std::size_t middle, std::size_t outer, std::uint32_t plane) const
  {
    return static_cast<std::size_t>(
      std::upper_bound(begin(middle, outer), end(middle, outer), Crossing{ 0, plane }) -
      begin(middle, outer));
  }

private:
  struct Crossing
  {
    std::uint32_t line;        // middle + outer * planes of middle
    std::uint32_t planesBelow; // planes of axes.along below the crossing

    bool operator<(const Crossing& other) const { return planesBelow < other.planesBelow; }
  };

  const Crossing* begin(std::size_t middle, std::size_t outer) const
  {
    return crossings_.begin(middle + outer * linesOfMiddle_);
  }
  const Crossing* end(std::size_t middle, std::size_t outer) const
  {
    return crossings_.end(middle + outer * linesOfMiddle_);
  }

  RowAxes axes_;
  std::size_t linesOfMiddle_;
  Buckets<Crossing> crossings_; // by line
};

}

// SPDX-License-Identifier: BSD-3-Clause
// The surface in one box: what all methods of patch generation (section 4.7) start from.
//
// The polygons are those of Exact Fit. The segments are their edges on the sides of the box, without
// those that cancel each other. The two boxes of a side have the same segments there, in opposite
// directions.
#pragma once

#include "Boxes/Boxes.h"
#include "Boxes/PlaneClearance.h"
#include "Lattice/ExactFit.h"
#include "Lattice/Numbering.h"
#include "Surface/Features.h"

namespace cartesian
{

struct Segment
{
  std::uint32_t from; // local points
  std::uint32_t to;
  std::uint32_t triangle;
  std::uint8_t side;    // 2 * axis, plus 1 for the upper
  std::uint8_t quarter; // of the side: bits 0 and 1 for the upper half along the next two axes
};

struct BoxSurface
{
  std::vector<Point> points;
  std::vector<PointKind> kinds;     // of points, or empty: all are merely on the surface
  std::vector<std::uint32_t> sizes; // of polygons
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> triangles; // of each polygon
  std::vector<Segment> segments;
  bool sharp = false; // a sharp feature passes through

  void clear();
};

// Bits of the box's planes that a point lies on: 2 * axis, plus 1 for the upper.
inline unsigned planesOf(const Box& box, const Point& p)
{
  unsigned bits = 0;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    bits |= (p[axis] == box.low[axis] ? 1u : 0u) << (2 * axis);
    bits |= (p[axis] == box.high[axis] ? 2u : 0u) << (2 * axis);
  }
  return bits;
}

// The number of cutting planes that a point lies on. With two or three it is a crossing of the surface
// and an edge of a box, and belongs to all boxes around it.
inline int planeCount(const Point& p)
{
  return int(onPlane(p[0])) + int(onPlane(p[1])) + int(onPlane(p[2]));
}

// The lines along which finer neighbours divide the sides of a box.
class SideLines
{
public:
  void find(const Boxes& boxes, const Box& box);

  // Whether any side is divided.
  bool any() const { return any_; }

  const Point& middle() const { return middle_; }

  // If the i-th side of a fragment lies on a side of the box, calls visit(point) where it crosses the
  // lines there, in order.
  template <class Visitor>
  void forEachCrossing(
    const Corners& triangle, const Fragment& fragment, int i, Visitor&& visit) const;

private:
  // The two middle lines of a side, and whether neighbours meet along each half of them.
  struct Cross
  {
    Level plane = 0;
    std::array<bool, 2> u{}; // the line across u: its lower and upper half along v
    std::array<bool, 2> v{};
  };

  bool crossing(const Corners& triangle, const Point& p, const Point& q, std::size_t u,
    std::size_t v, const std::array<bool, 2>& halves, Point& at) const;

  std::array<Cross, 6> crosses_; // low x, high x, low y, ...
  Point middle_{};
  bool any_ = false;
};

// Cuts the surface at the sides of one box after the other.
class SurfaceCutter
{
public:
  // `clearance`: how far points keep away from planes that they are not on; null: points stay exact.
  SurfaceCutter(const Surface& surface, const Features& features, const Boxes& boxes,
    const PlaneClearance* clearance);

  // Gives the part of the triangles [begin, end) that lies in the box.
  void cut(
    const Box& box, const std::uint32_t* begin, const std::uint32_t* end, BoxSurface& result);

private:
  void addPolygons(
    const Corners& corners, const Fragment& fragment, std::uint32_t triangle, BoxSurface& result);
  void raiseKind(std::uint32_t point, PointKind kind);
  void addSegment(std::uint32_t from, std::uint32_t to, std::uint32_t triangle, std::uint8_t side);
  void keepNetSegments(BoxSurface& result);
  void keepUsedPoints(BoxSurface& result);
  std::uint32_t addPoint(const Point& exact);

  // The global box along one axis.
  struct Interval
  {
    Level low;
    Level high;
    Level clearance;
  };

  const Surface& surface_;
  const Features& features_;
  const Boxes& boxes_;
  const PlaneClearance* clearance_;
  const Box* box_ = nullptr;
  std::array<Interval, 3> intervals_{};
  SideLines lines_;
  LocalPoints points_;
  std::vector<PointKind> kinds_; // of the first points; the others are no more than on the surface
  std::vector<Segment> segments_;
  std::vector<std::uint32_t> walk_;
  std::vector<std::uint32_t> next_;
};

}

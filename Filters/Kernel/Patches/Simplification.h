// SPDX-License-Identifier: BSD-3-Clause
// Polygon Simplification (section 6, A2) of the patches of one box.
//
// Nodes inside smooth parts are removed, triangles with similar normals become convex polygons, and
// slivers are merged with a neighbour. Sharp edges, corners and borders between boundaries stay, and so
// do the nodes on the sides of the box, on which both boxes of a side have agreed (SideTying.h).
#pragma once

#include "Patches/NodeRemoval.h"
#include "Patches/PolygonMerging.h"

namespace cartesian
{

// Simplifies one box after the other.
class Simplification
{
public:
  Simplification(const Surface& surface, const Boxes& boxes, const PlaneClearance& clearance,
    const PatchSpec& spec);

  Simplification(const Simplification&) = delete;
  Simplification& operator=(const Simplification&) = delete;

  // Starts with another box.
  void begin(const Box& box, const BoxSurface& piece);

  // Adds a polygon, whose corners are indices of points; `normal` of length 1, or 0 where it has no area.
  void add(const std::uint32_t* begin, const std::uint32_t* end, std::uint32_t triangle,
    const Vector& normal);

  // See NodeRemoval.h.
  void removeTied(const SideTying& tying) { removal_.removeTied(tying); }
  void removeInner() { removal_.removeInner(); }

  // See PolygonMerging.h.
  void merge() { merging_.merge(); }

  // Of points, or empty (BoxSurface): those onto which others collapsed are of the highest kind of all these.
  const std::vector<PointKind>& kinds() const { return box_.kinds; }

  // Calls visit(first corner, last, triangle) for all polygons.
  template <class Visitor>
  void forEach(Visitor&& visit) const
  {
    for (const Polygon& p : box_.polygons)
    {
      if (p.alive)
      {
        visit(box_.cornersOf(p), box_.cornersOf(p) + p.size, p.triangle);
      }
    }
  }

private:
  const Boxes& boxes_;
  const PlaneClearance& clearance_;
  BoxPolygons box_;
  NodeRemoval removal_;
  PolygonMerging merging_;
};

}

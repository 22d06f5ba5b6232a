// SPDX-License-Identifier: BSD-3-Clause
// The patches of one box, out of the surface in it.
#pragma once

#include "Patches/ChordLoops.h"
#include "Patches/Simplification.h"

namespace cartesian
{

// The polygons of a chunk of boxes. Corners are slots: points of this chunk, one for each box and place.
struct PatchChunk
{
  // A point that is more than on the surface.
  struct Feature
  {
    std::uint32_t slot;
    PointKind kind;
  };

  std::vector<PointUse> uses;
  std::vector<Feature> features;
  std::vector<std::uint32_t> sizes;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> polygonsOfBox;
};

// Appends the patches of one box after the other to a chunk.
class PatchBuilder
{
public:
  // `reasons`: of all boxes, by their index.
  PatchBuilder(const Surface& surface, const Features& features, const Boxes& boxes,
    const PlaneClearance& clearance, const std::vector<PatchReason>& reasons, const PatchSpec& spec,
    PatchChunk& chunk);

  // Points of `piece` may move.
  void addBox(std::uint32_t b, BoxSurface& piece);

private:
  void addPolygon(const std::uint32_t* begin, const std::uint32_t* end, std::uint32_t triangle);
  void copyPolygons(const BoxSurface& piece);
  void simplifyPolygons(const BoxSurface& piece);
  void listLoopNodes(const Box& box, const BoxSurface& piece);
  void addTriangles(const Box& box, const BoxSurface& piece);
  std::uint32_t mostAlike(const std::array<std::uint32_t, 3>& points, const Vector& normal) const;
  void giveSlots(const PackedBox& box, const std::vector<Point>& points,
    const std::vector<PointKind>& kinds, std::size_t firstCorner);

  const Features& features_;
  const Boxes& boxes_;
  const std::vector<PatchReason>& reasons_;
  SideTying tying_;
  Simplification simplification_;
  ChordLoops loops_;
  PatchChunk& chunk_;
  std::vector<std::uint32_t> triangleAt_; // of the surface, at each point that a chord leaves
  std::vector<std::uint32_t> slot_;       // of each point of the box, or None
};

}

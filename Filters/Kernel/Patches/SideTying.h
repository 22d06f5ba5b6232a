// SPDX-License-Identifier: BSD-3-Clause
// Tying of Patches (section 4.8): the common lines of two boxes' patches on the side between them.
//
// On each part of a side that two boxes share, the surface leaves polylines. Both boxes see the same ones, and the
// result depends only on them and on the methods of the two boxes. So each box ties them separately, in any order,
// and both agree.
// - Between two Marching Cubes boxes only the ends of a polyline stay: crossings on edges of boxes. The
//   loop of a coarse box thus runs through the crossings on the lines between its finer neighbours.
// - Where one or both are Exact Fit boxes, nodes that the polyline does not need are dropped (A2): those
//   between segments whose directions and whose triangles' normals differ by no more than Merge Angle,
//   unless the new chord would pass over another polyline. For the nodes that stay between boxes of
//   different methods, see enum Tying.
#pragma once

#include "Lattice/Plane.h"
#include "Patches/BoxSurface.h"
#include "Patches/CrossingPairs.h"
#include "Patches/PatchChoice.h"
#include "Patches/PatchSpec.h"

namespace cartesian
{

// A straight piece of a tied polyline.
struct Chord
{
  std::uint32_t from; // local points
  std::uint32_t to;
  std::uint32_t firstTriangle; // that the surface has at `from`, and
  std::uint32_t lastTriangle;  // at `to`
};

class SideTying
{
public:
  // `reasons`: of all boxes, by their index.
  SideTying(const Surface& surface, const Features& features, const Boxes& boxes,
    const PlaneClearance& clearance, const std::vector<PatchReason>& reasons,
    const PatchSpec& spec);

  // Ties all sides of a box. Points that move are moved in `piece`.
  void tie(std::uint32_t box, BoxSurface& piece);

  // The chords that bound the box's patches, as these run.
  const std::vector<Chord>& chords() const { return chords_; }

  // For each point: itself, or if it was dropped, the nearer one of its neighbours on the polyline that
  // were not.
  const std::vector<std::uint32_t>& onto() const { return onto_; }

  // Whether a point was dropped because its edge would have been too short.
  bool wentForShortness(std::uint32_t point) const { return short_[point] != 0; }

private:
  struct Polyline
  {
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint32_t> triangles; // one a segment
    std::vector<std::uint8_t> keep;       // one a node
  };

  struct FlatNode
  {
    PlanePoint at;
    std::uint32_t node;
  };

  void tiePart(
    BoxSurface& piece, const Segment* begin, const Segment* end, bool exactHere, bool exactThere);
  bool isFixed(const BoxSurface& piece, std::uint32_t node) const;
  void followPolyline(BoxSurface& piece, const Segment* begin, std::uint32_t first);
  void finishPolyline(BoxSurface& piece, bool upper);
  void keepFarthest(const BoxSurface& piece);
  void addChords(const BoxSurface& piece, bool upper);
  void dropShort(const BoxSurface& piece);
  void dropSimilar(const BoxSurface& piece);
  bool mayReplace(const BoxSurface& piece, std::size_t i, std::size_t before, std::size_t j);
  bool isFeature(const BoxSurface& piece, std::size_t node) const;
  bool isSharp(const BoxSurface& piece, std::size_t node) const;
  bool isNextToFeature(const Point& p, std::uint32_t triangle) const;
  bool passesOver(const BoxSurface& piece, std::size_t i, std::size_t before, std::size_t j);
  void listFlatNodes(const BoxSurface& piece);
  void moveOntoChord(const BoxSurface& piece);
  void startAtFirstTriangle();
  void sortByPart();
  double shortestEdge(const Box& box, int axis) const;
  bool endsShareLine(const BoxSurface& piece) const;
  PlanePoint flat(const BoxSurface& piece, std::uint32_t node) const
  {
    return flatten(piece.points[node], axis_);
  }

  const Surface& surface_;
  const Features& features_;
  const Boxes& boxes_;
  const PlaneClearance& clearance_;
  const std::vector<PatchReason>& reasons_;
  PatchSpec spec_;
  double mergeCosine_;
  double featureCosine_;

  std::vector<Chord> chords_;
  std::vector<std::uint32_t> onto_;
  std::vector<std::uint8_t> short_;
  CrossingPairs pairs_;

  // Of the part of a side that is being tied:
  int axis_ = 0;
  double shortest_ = 0; // levels
  bool exactHere_ = false;
  bool exactThere_ = false;
  std::vector<Segment> segments_;
  std::vector<Segment> sorted_;
  std::vector<std::uint32_t> leaving_; // of each point, the segment that leaves it (of the part)
  std::vector<std::uint8_t> arrivals_;
  std::vector<std::uint8_t> departures_;
  std::vector<std::uint8_t> done_; // segments
  std::vector<std::uint32_t> partNodes_;
  std::vector<FlatNode> flatNodes_; // partNodes_ by their first level; empty until needed
  Polyline line_;
  std::vector<std::pair<std::uint32_t, Point>> moved_; // nodes, and where to
};

}

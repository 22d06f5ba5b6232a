// SPDX-License-Identifier: BSD-3-Clause
// Polygon Simplification (section 6, A2) of the patches of one box.
//
// Nodes inside smooth parts go, triangles of similar normal become convex polygons, slivers join a
// neighbour. Sharp edges, corners and borders between boundaries stay, and so do the nodes on the
// sides of the box, on which both boxes of a side have agreed (Tying.h).
#pragma once

#include "Lattice/MarchingCubes.h"
#include "Patches/BoxSurface.h"
#include "Patches/PatchSpec.h"
#include "Patches/Tying.h"

namespace cartesian
{

// The polygons of one box. Keeps its storage from box to box.
class Simplification
{
public:
  Simplification(
    const Surface& surface, const Boxes& boxes, const Clearance& clearance, const PatchSpec& spec);

  // Starts anew.
  void begin(const Box& box, const std::vector<Point>& points);

  // A polygon whose corners are indices of points; `normal` of length 1, or 0 where it has no area.
  void add(const std::uint32_t* begin, const std::uint32_t* end, std::uint32_t triangle,
    const Vector& normal);

  // Removes the points that tying has dropped.
  void removeTied(const SideTying& tying);

  // Removes nodes inside the box where the surface turns by no more than Merge Angle.
  void removeInner();

  // Merges polygons of similar normal while they are convex, and slivers with a neighbour.
  void merge();

  // Calls visit(first corner, last, triangle) for all polygons.
  template <class Visitor>
  void forEach(Visitor&& visit) const
  {
    for (const Polygon& p : polygons_)
    {
      if (p.alive)
      {
        visit(corners_.data() + p.first, corners_.data() + p.first + p.size, p.triangle);
      }
    }
  }

private:
  struct Polygon
  {
    std::size_t first; // in corners_
    std::uint32_t size;
    std::uint32_t triangle; // of the surface
    double area;            // of the part of it that the polygon comes from
    Vector axis;            // of the cone that holds the normals of all it comes from
    double spread;          // the cone's half angle, radians
    bool alive;
  };

  struct Cone
  {
    Vector axis;
    double spread;
  };

  // A polygon's use of an edge.
  struct Use
  {
    std::uint32_t lower;
    std::uint32_t upper;
    std::uint32_t polygon;
    bool down;

    bool sameEdge(const Use& other) const { return lower == other.lower && upper == other.upper; }
  };

  struct Candidate
  {
    double length;
    bool sliver;
    std::uint32_t left; // its polygon runs from `from` to `to`
    std::uint32_t right;
    std::uint32_t from;
    std::uint32_t to;
  };

  void listUses();
  void markFeatures();
  bool isFeature(const Polygon& p, const Polygon& q) const;
  bool gatherFan(std::uint32_t node);
  bool removeNode(std::uint32_t node, bool forced);
  void collapse(std::uint32_t node, std::uint32_t onto);
  void append(
    const std::uint32_t* begin, const std::uint32_t* end, const Polygon& like, const Cone& cone);
  static Cone around(const Cone& a, const Cone& b);
  void listCandidates();
  bool joinAcross(const Candidate& candidate);
  bool isSliver(const Polygon& p) const;
  bool unite(const Polygon& left, const Polygon& right, std::uint32_t from, std::uint32_t to);
  bool isConvex(const std::vector<std::uint32_t>& ring, double mostConcave) const;
  void splitTurned();
  std::uint32_t current(std::uint32_t polygon);

  const Surface& surface_;
  const Boxes& boxes_;
  const Clearance& clearance_;
  double mergeRadius_;  // radians
  double featureAngle_; // radians
  double featureCosine_;
  double shortest_ = 0; // levels

  std::vector<Vector> at_;
  std::vector<unsigned> planes_;
  std::vector<std::uint8_t> feature_;
  std::vector<Cone> cones_; // of the surface around each point
  std::vector<Polygon> polygons_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::vector<std::uint32_t>> of_; // polygons of each point, dead ones too
  std::vector<Use> uses_;
  std::vector<std::uint32_t> fan_;
  std::vector<std::uint32_t> loop_;
  std::vector<LoopNode> nodes_;
  std::vector<Candidate> candidates_;
  std::vector<std::uint32_t> joined_; // what each polygon has become part of
  std::vector<std::uint32_t> ring_;
  LoopTriangulation triangulation_;
};

}

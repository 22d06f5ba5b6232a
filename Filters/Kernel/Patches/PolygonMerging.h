// SPDX-License-Identifier: BSD-3-Clause
// Merges polygons of a box into fewer, convex ones (section 6, A2).
#pragma once

#include "Lattice/MarchingCubes.h"
#include "Patches/BoxPolygons.h"
#include "Patches/PatchSpec.h"

namespace cartesian
{

// Keeps its storage from box to box.
class PolygonMerging
{
public:
  PolygonMerging(const Surface& surface, const PatchSpec& spec, BoxPolygons& box);

  // Merges polygons of similar normal while they are convex, and slivers with a neighbour.
  void merge();

private:
  // An edge between two polygons.
  struct MergeCandidate
  {
    double length;
    bool sliver;
    std::uint32_t left; // its polygon runs from `from` to `to`
    std::uint32_t right;
    std::uint32_t from;
    std::uint32_t to;
  };

  void listCandidates();
  void joinAcross(const MergeCandidate& candidate);
  bool unite(const Polygon& left, const Polygon& right, std::uint32_t from, std::uint32_t to);
  void removeSpikes();
  bool isConvex(const std::vector<std::uint32_t>& ring, double mostConcave) const;
  void splitTurned();
  std::uint32_t current(std::uint32_t polygon) const;

  const Surface& surface_;
  BoxPolygons& box_;
  double mergeRadius_; // radians
  double featureCosine_;
  std::vector<PolygonEdge> edges_;
  std::vector<MergeCandidate> candidates_;
  std::vector<std::uint32_t> joined_; // what each polygon has become part of
  std::vector<std::uint32_t> ring_;
  std::vector<std::uint32_t> sorted_;
  std::vector<LoopNode> nodes_;
  LoopTriangulation triangulation_;
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Removal of nodes from the polygons of a box (section 6, A2).
#pragma once

#include "Lattice/MarchingCubes.h"
#include "Patches/PatchSpec.h"
#include "Patches/RimNodeRemoval.h"
#include "Patches/SideTying.h"

namespace cartesian
{

// Keeps its storage from box to box.
class NodeRemoval
{
public:
  NodeRemoval(const Surface& surface, const PatchSpec& spec, BoxPolygons& box);

  // Removes the points that tying has dropped.
  void removeTied(const SideTying& tying);

  // Removes nodes inside the box where the surface turns by no more than Merge Angle, and along the rims of sheets.
  void removeInner();

private:
  void markFeatures();
  bool isFeature(const PolygonEdge& a, const PolygonEdge& b) const;
  bool isOfSheet(std::uint32_t polygon) const;
  std::uint32_t neighbourOf(std::uint32_t node, std::uint32_t polygon, bool next) const;
  void startFan(std::uint32_t node);
  bool gatherFan(std::uint32_t node);
  NormalCone coneOfFan() const;
  Polygon largestOfFan() const;
  bool removeNode(std::uint32_t node, bool forced);
  bool fits(const LoopTriangulation::Triangle& triangle, const Vector& axis) const;
  void collapse(std::uint32_t node, std::uint32_t onto);

  const Surface& surface_;
  BoxPolygons& box_;
  double mergeRadius_;  // radians
  double featureAngle_; // radians
  double featureCosine_;
  std::vector<std::uint8_t> feature_; // 1 for points on features
  std::vector<NormalCone> cones_;     // of the surface around each point
  std::vector<PolygonEdge> edges_;
  std::vector<std::uint32_t> fan_;  // polygons
  std::vector<std::uint32_t> loop_; // points around the fan
  std::vector<std::uint32_t> sorted_;
  std::vector<LoopNode> nodes_; // of the loop
  LoopTriangulation triangulation_;
  std::vector<PolygonEdge> rims_; // each once
  RimNodeRemoval alongRims_;
};

}

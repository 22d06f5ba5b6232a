// SPDX-License-Identifier: BSD-3-Clause
// Patches of flawed boxes: triangles between the loops of the chords on a box's sides, which close by
// construction.
#pragma once

#include "Faces/InnerFaces.h"
#include "Faces/SideChords.h"
#include "Lattice/MarchingCubes.h"

namespace cartesian
{

// Makes the patches of one box after the other. Borrows all it is given.
class LoopPatches
{
public:
  // `added`: points numbered after the nodes. `newChordsOf`: of each side, which of `newChords` are on it,
  // or None: those of its patches.
  LoopPatches(const Boxes& boxes, const Patches& patches, const Sides& sides, const Nodes& nodes,
    const std::vector<Point>& added, const std::vector<std::uint32_t>& newChordsOf,
    const std::vector<std::vector<SideEdge>>& newChords);

  // Appends those of the n-th polyhedral box; added points are numbered after those of the patches.
  void add(std::uint32_t n, Patches& result);

private:
  struct Source
  {
    std::size_t patch;
    Vector normal;
  };

  const Point& at(std::uint32_t node) const
  {
    return node < nodes_.at.size() ? nodes_.at[node] : added_[node - nodes_.at.size()];
  }

  void gatherChords(std::size_t n);
  void listBoxNodes();
  void linkChords();
  std::uint32_t local(std::uint32_t node) const;
  void listLoopNodes(const Box& box);
  void triangulate(const std::uint32_t* begin, const std::uint32_t* end, Patches& result);
  std::uint32_t numberOf(std::uint32_t node) const;
  void listSources(std::uint32_t n);
  Vector areaOf(std::size_t patch) const;
  std::size_t mostAlike(const Vector& normal) const;

  const Boxes& boxes_;
  const Patches& patches_;
  const Sides& sides_;
  const Nodes& nodes_;
  const std::vector<Point>& added_;
  const std::vector<std::uint32_t>& newChordsOf_;
  const std::vector<std::vector<SideEdge>>& newChords_;
  SideChords sideChords_;

  std::vector<SideEdge> chords_;
  std::vector<std::uint8_t> scratch_;
  std::vector<SideEdge> boxChords_;
  std::vector<Vector> normals_;
  std::vector<std::uint32_t> boxNodes_;
  std::vector<LoopNode> loopNodes_;
  std::vector<LoopNode> loop_;
  std::vector<Source> sources_;         // patches that new ones may come from
  std::vector<std::uint32_t> leaving_;  // first chord that leaves each node, and
  std::vector<std::uint32_t> sameFrom_; // the next one that leaves the same node
  std::vector<std::uint32_t> walk_;
  LoopTriangulation triangulation_;
};

}

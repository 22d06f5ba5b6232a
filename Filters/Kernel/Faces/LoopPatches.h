// SPDX-License-Identifier: BSD-3-Clause
// New patches for a flawed box: triangles over the loops that the chords on its sides form, which close by
// construction.
#pragma once

#include "Faces/InnerFaces.h"
#include "Faces/SideChords.h"
#include "Patches/ChordLoops.h"

namespace cartesian
{

// Makes the patches of one box after the other. Borrows its arguments.
class LoopPatches
{
public:
  // `added`: points numbered after the nodes. `newChordsOf`: for each side the index in `newChords`, or
  // None if it keeps the chords of its patches.
  LoopPatches(const Boxes& boxes, const Patches& patches, const Sides& sides, const Nodes& nodes,
    const std::vector<Point>& added, const std::vector<std::uint32_t>& newChordsOf,
    const std::vector<std::vector<SideEdge>>& newChords);

  // Appends the patches of the n-th polyhedral box. In `result`, added points come after those of patches.
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
  std::uint32_t local(std::uint32_t node) const;
  void listLoopNodes(const Box& box);
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
  std::vector<SideEdge> boxChords_;     // between nodes of loops_
  std::vector<Vector> normals_;         // of the patches along the chords
  std::vector<std::uint32_t> boxNodes_; // in order
  std::vector<Source> sources_;         // patches that new ones may come from
  ChordLoops loops_;
};

}

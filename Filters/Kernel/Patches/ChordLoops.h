// SPDX-License-Identifier: BSD-3-Clause
// The loops that chords form on the sides of a box, made triangles (section 4.7).
#pragma once

#include "Base/Loops.h"
#include "Boxes/Boxes.h"
#include "Lattice/MarchingCubes.h"

namespace cartesian
{

// Keeps its storage from box to box.
class ChordLoops
{
public:
  // The ends of chords; filled by the caller.
  std::vector<LoopNode> nodes;

  // Calls visit(corners, normal) for each triangle: three indices of nodes, and the unit normal.
  // `chords` run from nodes[chord.from] to nodes[chord.to]; as many arrive at each node as leave it.
  template <class Chord, class Visitor>
  void forEachTriangle(const std::vector<Chord>& chords, Visitor&& visit)
  {
    leaving_.assign(nodes.size(), None);
    sameFrom_.resize(chords.size());
    for (std::uint32_t c = 0; c < chords.size(); ++c)
    {
      sameFrom_[c] = leaving_[chords[c].from];
      leaving_[chords[c].from] = c;
    }
    for (const Chord& first : chords)
    {
      walk_.clear();
      for (std::uint32_t at = first.from; leaving_[at] != None;)
      {
        walk_.push_back(at);
        const std::uint32_t c = leaving_[at];
        leaving_[at] = sameFrom_[c];
        at = chords[c].to;
      }
      forEachSimpleLoop(walk_, [&](const std::uint32_t* begin, const std::uint32_t* end) {
        triangulate(begin, end, visit);
      });
    }
  }

private:
  template <class Visitor>
  void triangulate(const std::uint32_t* begin, const std::uint32_t* end, Visitor&& visit)
  {
    loop_.clear();
    for (const std::uint32_t* node = begin; node != end; ++node)
    {
      loop_.push_back(nodes[*node]);
    }
    for (const auto& t : triangulation_.triangulate(loop_))
    {
      const Vector normal =
        unit(cross(minus(loop_[t[1]].at, loop_[t[0]].at), minus(loop_[t[2]].at, loop_[t[0]].at)));
      visit(std::array<std::uint32_t, 3>{ begin[t[0]], begin[t[1]], begin[t[2]] }, normal);
    }
  }

  std::vector<std::uint32_t> leaving_;  // first chord that leaves each node, and
  std::vector<std::uint32_t> sameFrom_; // the next one that leaves the same node
  std::vector<std::uint32_t> walk_;
  std::vector<LoopNode> loop_;
  LoopTriangulation triangulation_;
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Which rims of a surface face each other, edge by edge.
//
// An end of an open edge looks away from the edge's triangle, within a cone, at the nearest rim that looks back: what lies behind its own
// triangle is hidden. If that is its own loop, it is the other side of a hole. Each edge looks by itself, so at a corner where three
// sheets meet its vertex faces both others.
// Limits: rims side by side that look the same way, such as flanges, face nothing.
#pragma once

#include "Lattice/Vector.h"
#include "Repair/RimLoops.h"

#include <optional>

namespace cartesian
{

// Where an end of an edge looks at.
struct RimFoot
{
  std::size_t edge; // of another loop
  double along;     // that edge, from 0 to 1
  double across;    // levels: from one edge to the other's line
};

// Borrows the surface. Edges are numbered loop by loop; each has its lower end, 0, where the loop comes from.
class FacingRims
{
public:
  // Rims at most `widest` levels apart.
  FacingRims(const Surface& surface, double widest, Execution& execution);

  std::size_t edges() const { return edges_.size(); }
  const RimEdge& edge(std::size_t e) const { return edges_[e]; }
  std::size_t loopOf(std::size_t e) const { return loops_[e]; }
  std::size_t next(std::size_t e) const { return e + 1 == endOf(e) ? firstOf(e) : e + 1; }
  std::size_t before(std::size_t e) const { return e == firstOf(e) ? endOf(e) - 1 : e - 1; }

  Vector from(std::size_t e) const { return toVector(surface_.vertices[edges_[e].from]); }
  Vector way(std::size_t e) const
  {
    return minus(toVector(surface_.vertices[edges_[e].to]), from(e));
  }

  const std::optional<RimFoot>& foot(std::size_t e, std::size_t end) const
  {
    return feet_[2 * e + end];
  }

  // Whether an end of an edge, or both, face a loop.
  bool faces(std::size_t e, std::size_t end, std::size_t loop) const
  {
    return foot(e, end) && loops_[foot(e, end)->edge] == loop;
  }
  bool faces(std::size_t e, std::size_t loop) const
  {
    return faces(e, 0, loop) && faces(e, 1, loop);
  }

  // Levels along the loop from where `e` starts to a place on it.
  double lengthTo(std::size_t e, const RimFoot& foot) const;

  // Of a whole loop, levels.
  double lengthOf(std::size_t loop) const
  {
    return lengths_[starts_[loop + 1]] - lengths_[starts_[loop]];
  }

private:
  void look(double widest, Execution& execution);

  // What looks at nothing, at the flank of a tooth, faces what the next edge does.
  void followNeighbours();

  std::size_t firstOf(std::size_t e) const { return starts_[loops_[e]]; }
  std::size_t endOf(std::size_t e) const { return starts_[loops_[e] + 1]; }

  const Surface& surface_;
  std::vector<RimEdge> edges_;
  std::vector<std::size_t> loops_;  // of each edge
  std::vector<std::size_t> starts_; // first edge of each loop, and the end
  std::vector<double> lengths_;     // of all edges before each, levels
  std::vector<std::optional<RimFoot>> feet_;
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Reduces the chords of a side where they show more detail than boxes of this size can resolve (4.11, IP patches: the
// polylines on the sides of a box are what its patches are made from).
#pragma once

#include "Faces/SideChords.h"

namespace cartesian
{

// Nodes this close to the polyline without them are dropped; relative to the side's shorter edge.
constexpr double ChordTolerance = 0.1;

// Closed polylines narrower than this are dropped: a finger too thin for the boxes.
constexpr double NarrowestLoop = 0.15;

// Keeps the nodes on the border of the side, and those where not just one chord comes and one leaves. Simplified
// chords do not cross each other; where they would, none is simplified.
class ChordSimplifier
{
public:
  // place(node): where it is.
  template <class Place>
  void simplify(Place&& place, const Rectangle& r, std::vector<SideEdge>& chords)
  {
    nodes_.clear();
    for (const SideEdge& chord : chords)
    {
      nodes_.push_back(chord.from);
      nodes_.push_back(chord.to);
    }
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    places_.clear();
    for (const std::uint32_t node : nodes_)
    {
      places_.push_back(flatten(place(node), r.axis));
    }
    run(r, chords);
  }

private:
  void run(const Rectangle& r, std::vector<SideEdge>& chords);
  void link(const Rectangle& r, const std::vector<SideEdge>& chords);
  void trace(std::uint32_t node);
  void addPolyline();
  void addLoop();
  void thin(std::size_t first, std::size_t last);
  std::size_t farthest(std::size_t first, std::size_t last, double& distance) const;
  bool sharesBorder(std::uint32_t a, std::uint32_t b) const;
  bool anyCross() const;
  std::uint32_t local(std::uint32_t node) const;

  std::vector<std::uint32_t> nodes_; // ends of chords, in order; below, indices into these
  std::vector<PlanePoint> places_;
  std::vector<std::uint32_t> next_; // of each node, or None: fixed, passed, or nothing leaves
  std::vector<std::uint8_t> fixed_;
  std::vector<std::uint8_t> borders_; // bits of the side's borders that a node lies on
  std::vector<std::uint32_t> line_;   // the polyline at hand
  std::vector<std::uint8_t> keeps_;   // of its nodes
  std::vector<SideEdge> result_;      // local nodes
  double tolerance_ = 0;
  double narrowest_ = 0;
};

}

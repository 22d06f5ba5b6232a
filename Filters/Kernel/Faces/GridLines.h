// SPDX-License-Identifier: BSD-3-Clause
// The lines between neighbouring grid nodes near flawed boxes: which keep their crossings with the
// surface, and what the others get (BoxRebuilding.h).
#pragma once

#include "Faces/InnerFaces.h"
#include "Faces/NewPoints.h"
#include "Faces/SideChords.h"

namespace cartesian
{

// A crossing of a line with the surface.
struct StatusChange
{
  std::uint32_t node;
  int change; // of the status, upward

  bool operator==(const StatusChange& other) const
  {
    return node == other.node && change == other.change;
  }
};

// A line that does not keep its crossings.
struct NewLine
{
  std::uint32_t low; // grid nodes
  std::uint32_t high;
  StatusChange crossing; // its node is None if there is none

  bool operator<(const NewLine& other) const
  {
    return std::tie(low, high) < std::tie(other.low, other.high);
  }
};

// One side after the other as its patches have it.
struct SideView
{
  std::vector<SideEdge> chords; // net
  std::vector<BorderNode> border;
  std::vector<std::uint8_t> scratch;

  void look(std::uint32_t side, const SideChords& sideChords, const std::vector<Point>& nodes);
};

class GridLines
{
public:
  GridLines(const Sides& sides, const Nodes& nodes, const SideChords& sideChords,
    const std::vector<std::uint8_t>& flawed)
    : sides_(sides)
    , nodes_(nodes)
    , sideChords_(sideChords)
    , flawed_(flawed)
  {
  }

  // Looks at the lines around all sides that touch a flawed box, and decides on each. `keepsSeveral`:
  // whether a line may keep more than one crossing.
  void judge(bool keepsSeveral, NewPoints& points, Execution& execution);

  // The sides that touch a flawed box, and whether a line around a side is new.
  const std::vector<std::uint32_t>& nearSides() const { return nearSides_; }
  bool changes(std::uint32_t side) const { return sideChanges_[side] != 0; }

  // Whether the side is one of a flawed box.
  bool isOfFlawed(std::uint32_t side) const;

  // Status of a grid node near flawed boxes: 0 outside, 1 inside.
  int status(std::uint32_t node) const { return status_[node]; }

  // The change of the line between two nodes, or null: it keeps its crossings.
  const NewLine* find(std::uint32_t low, std::uint32_t high) const;

  // The index of the grid node that follows border[i], or the border's size.
  std::size_t nextGridNode(const std::vector<BorderNode>& border, std::size_t i) const;

private:
  // A line as one side sees it, with its crossings [first, end), upward.
  struct LineObservation
  {
    std::uint32_t low; // grid nodes
    std::uint32_t high;
    std::uint32_t side;
    std::uint32_t first;
    std::uint32_t end;

    bool sameLine(const LineObservation& other) const
    {
      return low == other.low && high == other.high;
    }
    bool operator<(const LineObservation& other) const
    {
      return std::tie(low, high, side) < std::tie(other.low, other.high, other.side);
    }
  };

  // The lines around a chunk of sides.
  struct SeenLines
  {
    std::vector<LineObservation> sights;
    std::vector<StatusChange> crossings;
    std::vector<std::pair<std::uint32_t, KnownStatus>> statuses; // of grid nodes
  };

  bool isGrid(std::uint32_t node) const
  {
    return node >= nodes_.patchPoints && node < nodes_.at.size();
  }
  template <class Visitor>
  void forEachBorderNode(std::uint32_t side, Visitor&& visit) const;
  void findNearSides(Execution& execution);
  void lookAtLines(Execution& execution);
  void lookAround(std::uint32_t side, SideView& view, SeenLines& seen) const;
  static void addSight(std::uint32_t side, const std::vector<BorderNode>& border, std::size_t i,
    std::size_t next, SeenLines& seen);
  int changeAlong(const LineObservation& sight) const;
  void inferStatuses();
  bool leadsOn(const LineObservation& sight) const;
  bool seesTheSame(const LineObservation& a, const LineObservation& b) const;
  StatusChange newCrossing(
    const LineObservation* begin, const LineObservation* end, NewPoints& points) const;

  const Sides& sides_;
  const Nodes& nodes_;
  const SideChords& sideChords_;
  const std::vector<std::uint8_t>& flawed_;
  std::vector<std::uint32_t> nearSides_;
  std::vector<std::int8_t> status_;     // of grid nodes near flawed boxes, or KnownStatus::Unknown
  std::vector<LineObservation> sights_; // line by line
  std::vector<StatusChange> crossings_;
  std::vector<NewLine> newLines_; // in order
  std::vector<std::uint8_t> sideChanges_;
};

}

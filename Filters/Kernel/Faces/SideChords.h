// SPDX-License-Identifier: BSD-3-Clause
// The boundary of the inside region of a common side (section 4.9): chords, which are edges of patches, and the border
// of the side, with the status of its corners.
#pragma once

#include "Boxes/Sides.h"
#include "Faces/Nodes.h"
#include "Lattice/Plane.h"
#include "Patches/Patches.h"

namespace cartesian
{

// A directed edge of a side's inside region, which lies to its left.
struct SideEdge
{
  std::uint32_t from;
  std::uint32_t to;

  bool operator<(const SideEdge& other) const
  {
    return from != other.from ? from < other.from : to < other.to;
  }
};

// Status of a node, as far as the corners of boxes tell.
enum class KnownStatus : std::int8_t
{
  Unknown = -1,
  Outside = 0,
  Inside = 1,
};

// A side in its own plane.
struct Rectangle
{
  int axis;
  PlanePoint low;
  PlanePoint high;
  const std::uint32_t* border; // grid nodes, counter-clockwise from the lowest corner
  std::size_t borderSize;
  std::array<KnownStatus, 4> corner; // counter-clockwise from the lowest corner
};

// A grid node on the border, or an end of a chord.
struct BorderNode
{
  int border; // 0 to 3, counter-clockwise from the lowest corner
  std::int64_t along;
  std::uint32_t node;
  int change; // of the status at this node, counter-clockwise
  KnownStatus known;
};

// Lists the nodes counter-clockwise from the lowest corner.
void listBorder(const std::vector<Point>& nodes, const Rectangle& r,
  const std::vector<SideEdge>& chords, std::vector<BorderNode>& border);

// Drops edges that run both ways between the same nodes: they bound nothing. Sorts the rest.
void dropOpposite(std::vector<SideEdge>& edges, std::vector<std::uint8_t>& scratch);

// Gives the chords and the rectangle of any side.
class SideChords
{
public:
  SideChords(const Boxes& boxes, const Patches& patches, const Sides& sides, const Nodes& nodes)
    : boxes_(boxes)
    , patches_(patches)
    , sides_(sides)
    , nodes_(nodes)
  {
  }

  // Inside is where this region is.
  Rectangle rectangle(std::size_t side, std::int32_t region = FirstRegion) const;

  // Lists the edges on a side of the patches that bound a region: those of the lower box if it has patches,
  // else of the upper.
  void find(std::size_t side, const Rectangle& r, std::vector<SideEdge>& chords,
    std::int32_t region = FirstRegion) const;

  // Lists the regions that a side may show, ascending.
  void listRegions(std::size_t side, std::vector<std::int32_t>& regions) const;

private:
  // The box whose patches are taken, among the intersected ones, or None.
  std::uint32_t patchBoxOf(const Side& side, bool& isLow) const;

  const Boxes& boxes_;
  const Patches& patches_;
  const Sides& sides_;
  const Nodes& nodes_;
};

}

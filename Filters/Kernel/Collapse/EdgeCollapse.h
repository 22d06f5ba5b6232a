// SPDX-License-Identifier: BSD-3-Clause
// Collapses short edges: nodes that nearly coincide become one.
//
// Where the surface passes close to a corner or a side of a box, it leaves cells that are too thin or too
// small (4.10). Here the corner of the box moves onto the surface instead: volume and boundary hardly
// change, and the cell without volume vanishes. This is the idea of isosurface stuffing (Labelle and
// Shewchuk, 2007). Nodes of the surface only move along it.
#pragma once

#include "Faces/InnerFaces.h"
#include "Faces/Nodes.h"

namespace cartesian
{

struct EdgeCollapseSpec
{
  // As in CollapseSpec.h: edges shorter than this part of their box's shortest edge collapse, unless a face would be
  // inverted.
  double ratio;

  // In degrees. Nodes at which faces meet at a larger angle, or several boundaries meet, lie on an edge of
  // the surface, which keeps its place.
  double featureAngle;

  // Whether nodes of the surface keep their places.
  bool exact = false;

  // 1 for polyhedral boxes (Sides.h) that keep their edges.
  std::vector<std::uint8_t> keeps;

  // False: nodes on seams (Slabs.h) stay, so that what happens between two seams depends on nothing
  // beyond them. True: only nodes that all belong to boxes next to a seam move.
  bool acrossSeams = false;
};

// Returns the number of nodes that vanished. Patches and inner faces without area vanish too. The result
// depends on the places of nodes, not on their order.
std::size_t collapseShortEdges(const Boxes& boxes, const Sides& sides, const EdgeCollapseSpec& spec,
  Patches& patches, Nodes& nodes, InnerFaces& inner, Execution& execution);

}

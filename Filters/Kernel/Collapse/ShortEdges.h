// SPDX-License-Identifier: BSD-3-Clause
// Collapse of short edges: nodes that nearly coincide become one.
//
// Where the surface passes close to a corner or a side of a box it leaves cells that are too thin or
// too small (4.10). Here the box's corner moves onto the surface instead: volume and boundary
// stay as they are, and the cell that is left without volume goes. It is the idea of isosurface
// stuffing (Labelle and Shewchuk, 2007). Nodes of the surface move only along it.
#pragma once

#include "Faces/InnerFaces.h"
#include "Faces/Nodes.h"

namespace cartesian
{

struct ShortEdgeSpec
{
  // As in CollapseSpec.h, where no face turns over.
  double ratio;

  // Nodes where faces meet at more than this angle, in degrees, or several boundaries do, lie on an
  // edge of the surface, which stays where it is.
  double featureAngle;

  // Nodes of the surface stay where they are.
  bool exact = false;

  // 1 for polyhedral boxes (Sides.h) whose edges stay.
  std::vector<std::uint8_t> keeps;

  // Nodes on seams (Slabs.h) stay: so what happens between two seams depends on nothing beyond. Else
  // only nodes of boxes next to a seam move, and of no others.
  bool acrossSeams = false;
};

// Returns the number of nodes that are gone. Patches and inner faces without area are gone too.
// Results do not depend on the order of nodes but on their places.
std::size_t collapseShortEdges(const Boxes& boxes, const Sides& sides, const ShortEdgeSpec& spec,
  Patches& patches, Nodes& nodes, InnerFaces& inner, Execution& execution);

}

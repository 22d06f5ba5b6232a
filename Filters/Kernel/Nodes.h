// Nodes of faces, numbered (section 7.1); nodes that hang on the sides of coarser boxes among them.
#pragma once

#include "Patches.h"
#include "Sides.h"

namespace cartesian
{

// Nodes of faces: the points of patches, then grid nodes: corners of sides, nodes that hang on their
// borders, corners of divided hexahedra.
struct Nodes
{
  std::vector<Point> at;
  std::size_t patchPoints = 0;
  std::vector<std::size_t> rowStart; // first grid node of each row of points (Numbering.h), from 0
  std::vector<std::size_t> borderStart; // first node of each side's border, and the end
  std::vector<std::uint32_t> border;    // grid nodes counter-clockwise from the lowest corner
  std::vector<std::array<std::uint32_t, 8>> ofDivided; // corners of Sides::divided
};

Nodes findNodes(
  const Boxes& boxes, const Patches& patches, const Sides& sides, Execution& execution);

}

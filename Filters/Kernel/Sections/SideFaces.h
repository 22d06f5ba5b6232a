// SPDX-License-Identifier: BSD-3-Clause
// The faces on the flat lower side of a mesh, as a mesh of polygons: what a mesh one cell across is made of (FlatCells.h).
#pragma once

#include "Quality/FaceList.h"

namespace cartesian
{

struct SideFaces
{
  std::vector<std::size_t> firstCorner; // of each polygon, and the end
  std::vector<std::uint32_t> corners;   // points, counter-clockwise from outside the mesh
  std::vector<std::size_t>
    beside; // of each corner: the cell's face at the edge from it to the next
  std::vector<std::uint32_t> cellOf; // of each polygon

  std::size_t count() const { return cellOf.size(); }
};

// Those whose corners all have the lowest coordinate along an axis that any point has, exactly; polygons that one cell has
// beside each other are united, unless that leaves a hole. In order of cells. `cells`: with corners counter-clockwise
// from outside. `points`: three coordinates each, all of them used.
SideFaces facesOfSide(const CellFaces& cells, const std::vector<double>& points, std::size_t axis);

}

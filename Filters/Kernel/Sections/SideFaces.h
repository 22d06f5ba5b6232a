// SPDX-License-Identifier: BSD-3-Clause
// The faces on the flat lower side of a mesh, as a mesh of polygons: what a mesh one cell across is made of (FlatCells.h).
#pragma once

#include "Quality/FaceList.h"

namespace cartesian
{

struct BorderEdge
{
  std::uint32_t from;
  std::uint32_t to;
  std::size_t beside; // the cell's face there
};

struct SideFaces
{
  std::vector<std::size_t> firstCorner{ 0 }; // of each polygon, and the end
  std::vector<std::uint32_t> corners;        // points, counter-clockwise from outside the mesh
  std::vector<std::size_t>
    beside; // of each corner: the cell's face at the edge from it to the next
  std::vector<std::uint32_t> cellOf; // of each polygon

  std::size_t count() const { return cellOf.size(); }
  std::size_t size(std::size_t polygon) const
  {
    return firstCorner[polygon + 1] - firstCorner[polygon];
  }
  BorderEdge edge(std::size_t polygon, std::size_t i) const
  {
    const std::size_t first = firstCorner[polygon];
    return { corners[first + i], corners[first + (i + 1) % size(polygon)], beside[first + i] };
  }
};

// What is left of edges of polygons where those that are there in both directions are left out, in turn; empty if that is not one
// loop.
std::vector<BorderEdge> borderOf(const std::vector<BorderEdge>& edges);

void addPolygon(const std::vector<BorderEdge>& border, std::uint32_t cell, SideFaces& side);

// In `opposite`, of a face on a boundary.
constexpr std::size_t NoFace = ~std::size_t(0);

// Those whose corners all have the lowest coordinate along an axis that any point has, exactly; polygons that one cell has
// beside each other are united, unless that leaves a hole. In order of cells. Where no polygon is beyond an edge, BorderEdge::beside is the face
// on a boundary there, of whichever cell. `cells`: with corners counter-clockwise from outside. `points`: three coordinates
// each, all of them used. `opposite`: of each face, the same of another cell.
SideFaces facesOfSide(const CellFaces& cells, const std::vector<double>& points, std::size_t axis,
  const std::vector<std::size_t>& opposite);

}

// SPDX-License-Identifier: BSD-3-Clause
// The cells around nodes that may move, in one slab (Slabs.h), and around those their neighbours.
//
// Nodes come in order of their places, faces in order of their nodes: sums over them come out the same, bit for bit, in
// whatever order the surface's triangles came.
#pragma once

#include "Cells/WallMesh.h"
#include "Parts/Slabs.h"
#include "Polyhedra/CellGeometry.h"

namespace cartesian
{

struct NodeMesh
{
  // Places are in levels from `origin`.
  struct Nodes
  {
    std::vector<Vector> at;
    std::vector<std::uint32_t> number; // in cartesian::Nodes, or None: only hexahedra have it
    std::vector<std::uint8_t> mayMove; // 1: all cells at the node are here, and it is a wall cell's
  };

  struct Faces
  {
    std::vector<std::uint32_t> start; // of each face's corners, and their end
    std::vector<std::uint32_t> stop;
    std::vector<std::uint32_t> corners; // counter-clockwise seen from outside the cell below
    std::vector<std::array<std::uint32_t, 2>> cells; // below and above; None above: a boundary face
    std::vector<std::int32_t> boundary; // of boundary faces, and of those between two regions
    std::vector<std::uint32_t> number;  // in WallFaces, or None: implicit
    std::vector<std::uint8_t> isTurned; // 1: there the cells below and above change places

    // Closes the face whose corners were added last.
    void close(const std::array<std::uint32_t, 2>& of, std::int32_t wall, std::uint32_t inWall)
    {
      start.push_back(stop.empty() ? 0 : stop.back());
      stop.push_back(static_cast<std::uint32_t>(corners.size()));
      cells.push_back(of);
      boundary.push_back(wall);
      number.push_back(inWall);
      isTurned.push_back(0);
    }

    std::size_t size() const { return cells.size(); }
    std::size_t sizeOf(std::size_t f) const { return stop[f] - start[f]; } // its corners
  };

  // First those with a node that may move, whose faces are all here; then their neighbours, which keep their measures.
  struct Cells
  {
    std::size_t changing = 0;
    std::vector<std::uint32_t> firstUse; // of each changing cell's faces, and their end
    std::vector<std::uint32_t> endUse;
    std::vector<std::uint32_t> uses;
    std::vector<CellGeometry> measures;
    std::vector<double> volumeOfBox;
    std::vector<std::uint32_t> number; // in WallMesh, or None: a hexahedron
    std::vector<std::uint32_t> box;    // of hexahedra, or None
    std::vector<std::int32_t> region;
  };

  Point origin{};
  std::array<Vector, 2> ends{}; // of the grid, lowest and highest: nodes stay between them
  Nodes nodes;
  Faces faces;
  Cells cells;

  // Calls visit(node) for the corners of a face, in order.
  template <class Visitor>
  void forEachCorner(std::size_t f, Visitor&& visit) const
  {
    for (std::uint32_t i = faces.start[f]; i < faces.stop[f]; ++i)
    {
      visit(faces.corners[i]);
    }
  }

  bool isInterface(std::size_t f) const
  {
    const auto& [below, above] = faces.cells[f];
    return above != None && cells.region[below] != cells.region[above];
  }
  // Of the smaller of each face's boxes.
  std::vector<double> edgesAtFaces() const;

  bool isWall(std::size_t f) const { return faces.cells[f][1] == None || isInterface(f); }
};

NodeMesh nodeMesh(const Boxes& boxes, const Sides& sides, const Nodes& nodes, const WallMesh& wall,
  const Slab& slab);

}

// SPDX-License-Identifier: BSD-3-Clause
// A cell cut by a plane (section 4.11).
#pragma once

#include "Polyhedra/Polyhedron.h"

#include <cstddef>

namespace cartesian
{

struct CutPlane
{
  Vector at;
  Vector normal;                      // of length 1
  std::vector<std::uint32_t> through; // nodes that count as lying on the plane
};

// The parts of a cell. Faces that the plane does not cut are kept as they were.
struct CellCut
{
  // A new node on the edge between two nodes, rounded to whole numbers. The i-th has the index
  // (number of the cell's nodes) + i.
  struct NewNode
  {
    std::uint32_t low;
    std::uint32_t high;
    Vector at;
  };
  struct Face
  {
    std::size_t begin; // range in CellCut::corners
    std::size_t end;
    std::uint32_t
      source; // the cell's face that it is, or is a piece of; NoSource for a cutting face
    std::uint32_t below; // the part it belongs to; of a cutting face, the one from which it is seen
                         // counter-clockwise
    std::uint32_t above; // the other part of a cutting face
  };
  static constexpr std::uint32_t NoSource = ~std::uint32_t(0);

  // The corners of a face, in order.
  struct FaceCorners
  {
    const std::uint32_t* first;
    const std::uint32_t* last;

    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
    std::uint32_t operator[](std::size_t i) const { return first[i]; }
  };
  FaceCorners cornersOf(const Face& face) const
  {
    return { corners.data() + face.begin, corners.data() + face.end };
  }

  std::vector<NewNode> points;
  std::vector<Face> faces;
  std::vector<std::uint32_t> corners; // of all faces
  std::uint32_t parts = 0;
};

// False unless the plane cuts the cell into two or more closed parts whose faces all have star
// triangulations.
bool cutCell(const Polyhedron& cell, const CutPlane& plane, CellCut& cut);

// One part as a cell; its nodes are numbered as in the cell and the cut.
Polyhedron partOf(const Polyhedron& cell, const CellCut& cut, std::uint32_t part);

// The same, in the memory of another.
void takePart(const Polyhedron& cell, const CellCut& cut, std::uint32_t part, Polyhedron& result);

}

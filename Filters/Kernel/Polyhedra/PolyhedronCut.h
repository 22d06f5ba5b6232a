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
  std::vector<std::uint32_t> through; // nodes that count as lying on it
};

// A cell in parts. Faces that the plane leaves alone are there as they were.
struct CellCut
{
  // A new node on the edge between two nodes, rounded to whole numbers: the i-th has the index
  // (nodes of the cell) + i.
  struct NewNode
  {
    std::uint32_t low;
    std::uint32_t high;
    Vector at;
  };
  struct Face
  {
    std::size_t begin; // of its corners, in those of all
    std::size_t end;
    std::uint32_t source; // the cell's face that it is (a piece of), or NoSource: cutting face
    std::uint32_t below;  // its part; of a cutting face, the one that it is counter-clockwise from
    std::uint32_t above;  // of a cutting face, the other part
  };
  static constexpr std::uint32_t NoSource = ~std::uint32_t(0);

  // The corners of a face, one after the other.
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

// An end of an edge is taken where the cut meets the edge so close to it that the cutting polygon
// deviates from the plane by less than this (4.11): tan 5 degrees.
constexpr double SnapSlope = 0.0874886635259240;

// False where the plane does not cut the cell into two parts or more that are closed and whose faces
// have star triangulations.
bool cutCell(const Polyhedron& cell, const CutPlane& plane, CellCut& cut);

// A part by itself; nodes are numbered as in the cell and the cut.
Polyhedron partOf(const Polyhedron& cell, const CellCut& cut, std::uint32_t part);

}

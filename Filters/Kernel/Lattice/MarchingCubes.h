// SPDX-License-Identifier: BSD-3-Clause
// Marching Cubes (section 4.7): triangles between the crossings on the edges of a box.
//
// There is no table of patterns: the crossings, joined on each side of the box as the surface joins
// them, form loops, and of all triangulations of a loop the one with the least criterion is taken.
#pragma once

#include "Lattice/Lattice.h"
#include "Lattice/Vector.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

// Equation 4, of the scalar product of the unit normals of a patch and of the surface: 1 where they
// agree, 4 where they are opposite.
double criterion(double scalarProduct);

struct LoopNode
{
  std::uint32_t id;
  Vector at;
  Vector normal;   // of the surface there, of length 1
  unsigned planes; // bits of the box's planes that it lies on
};

// Triangulates loops. Keeps its storage from loop to loop.
class LoopTriangulation
{
public:
  using Triangle = std::array<std::uint32_t, 3>; // indices in the loop, running as it does

  // Of all triangulations of the loop (three nodes or more) the one with the least average of the
  // criterion over all nodes of all triangles. No triangle lies in a side of the box where that can
  // be avoided. Loops of more than MostNodes are cut apart at short diagonals first.
  const std::vector<Triangle>& triangulate(const std::vector<LoopNode>& loop);

  static constexpr std::size_t MostNodes = 32;

private:
  void cutApart(const std::vector<LoopNode>& loop, std::vector<std::uint32_t> nodes);
  void optimise(const std::vector<LoopNode>& loop, const std::vector<std::uint32_t>& nodes);
  void collect(const std::vector<std::uint32_t>& nodes, std::size_t first, std::size_t last);

  std::vector<Triangle> triangles_;
  std::vector<double> cost_;       // of the part between nodes i and j
  std::vector<std::uint8_t> apex_; // of the triangle on its chord
  std::vector<std::uint32_t> whole_;
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Marching Cubes (section 4.7): triangulates the loops through the surface's crossings with the
// edges of a box.
//
// There is no table of cases: the crossings are connected on each side of the box as the surface
// connects them, and of all triangulations of the resulting loop, the one with the least criterion
// (equation 4) is taken.
#pragma once

#include "Lattice/Lattice.h"
#include "Lattice/Vector.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

// Equation 4: a function of the scalar product of the unit normals of a patch and of the surface.
// It is 1 where they agree and 4 where they are opposite.
double criterion(double scalarProduct);

struct LoopNode
{
  std::uint32_t id;
  Vector at;
  Vector normal;   // of the surface there, of length 1
  unsigned planes; // bit set of the box's planes that the node lies on
};

// Keeps its storage from loop to loop.
class LoopTriangulation
{
public:
  using Triangle = std::array<std::uint32_t, 3>; // indices in the loop, oriented like it

  // The triangulation of a loop (of three nodes or more) with the least average criterion over all
  // nodes of all triangles. Triangles in a side of the box are avoided where possible. Loops of
  // more than MostNodes are first cut at short diagonals.
  const std::vector<Triangle>& triangulate(const std::vector<LoopNode>& loop);

  static constexpr std::size_t MostNodes = 32;

private:
  void cutApart(const std::vector<LoopNode>& loop, std::vector<std::uint32_t> nodes);
  void optimise(const std::vector<LoopNode>& loop, const std::vector<std::uint32_t>& nodes);
  void collect(const std::vector<std::uint32_t>& nodes, std::size_t first, std::size_t last);

  std::vector<Triangle> triangles_;
  std::vector<double> cost_;       // of the part of the loop from node i to node j
  std::vector<std::uint8_t> apex_; // of the triangle on the chord of that part
  std::vector<std::uint32_t> whole_;
};

}

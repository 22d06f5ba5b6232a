// SPDX-License-Identifier: BSD-3-Clause
// The points near a wall follow its nodes when these move inwards, less with distance, so that no cell is squeezed more
// than others.
#pragma once

#include "Layers/HarmonicField.h"
#include "Layers/NearCells.h"

namespace cartesian
{

// Spreads the displacements of wall nodes along the wall: components that the planes around a node do not determine
// come from neighbouring nodes, and fade over some thicknesses. So nodes near a sharp edge make room for those on it.
void spreadWays(LayeredWall& wall, Execution& execution);

// The ways of points are harmonic on the graph of the mesh's edges, whose weights are the reciprocals of their
// lengths: along a row of points they fall linearly from the wall's to 0 at points that do not move. Those on planes
// of boundaries without layers slide within them.
class NodeMotion
{
public:
  // Borrows the wall.
  NodeMotion(const NearCells& near, const LayeredWall& wall, const std::vector<double>& points,
    Execution& execution);

  // From now on a point of the mesh stays where it was. Whether it would have moved.
  bool hold(std::uint32_t point);

  // As the wall's parts are now; from the ways before.
  void run(Execution& execution);

  const std::vector<std::uint32_t>& moving() const
  {
    return moving_;
  } // points of the mesh, in order
  const Vector& way(std::size_t i) const { return field_.values()[i]; } // of each

private:
  std::vector<std::uint32_t> numbersInField(std::size_t points) const;
  void makeField(const NearCells& near, const std::vector<double>& points, Execution& execution);

  const LayeredWall& wall_;
  std::vector<std::uint32_t> moving_;
  HarmonicField field_; // of these, then of the wall's nodes
};

}

// SPDX-License-Identifier: BSD-3-Clause
// The wall of a mesh of a displaced surface: its nodes, and where each belongs on the surface as it was
// (WallLift.h).
#pragma once

#include "Displacement/WallLift.h"
#include "Mesh/OutputMesh.h"

namespace cartesian
{

struct LayeredWall
{
  BoundaryMesh faces;                 // of the mesh without layers
  std::vector<std::uint8_t> layered;  // of each face
  std::vector<std::uint8_t> isOnWall; // of each node, an index in faces.meshPoint
  std::vector<Vector> displaced;      // where the mesh has it, in user units
  std::vector<Vector> onWall;         // where it belongs

  // Of the way from the wall to its displaced place, how much layers take; the node moves to there. 0: it has
  // none.
  std::vector<double> parts;

  std::size_t corners(std::size_t face) const
  {
    return static_cast<std::size_t>(faces.start[face + 1] - faces.start[face]);
  }
  std::size_t node(std::size_t face, std::size_t i) const
  {
    return static_cast<std::size_t>(
      faces.corners[static_cast<std::size_t>(faces.start[face]) + i % corners(face)]);
  }

  // A node's place, where 0 is the wall and 1 the mesh below the layers.
  Vector at(std::size_t node, double height) const
  {
    return plus(onWall[node], scaled(minus(displaced[node], onWall[node]), height * parts[node]));
  }
  bool hasStack(std::size_t face) const;
};

// `points`: of the mesh.
LayeredWall findLayeredWall(const OutputMesh& mesh, const std::vector<double>& points,
  const Lattice& lattice, const WallLift& lift, Execution& execution);

}

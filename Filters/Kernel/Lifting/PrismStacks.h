// SPDX-License-Identifier: BSD-3-Clause
// The boundary layers of a mesh: a stack of prisms on each boundary face of a displaced wall, up to the
// surface as it was.
//
// Each node of such a face has a place on the nearest displaced triangle (of equally near ones the first),
// and is lifted to the same place on that triangle as it was; the nodes between are on the line from one to
// the other. Faces with a common edge share the side faces above it. Towards boundaries without layers the
// side faces are boundary. A node that is not lifted has none above it: its prisms become wedges there,
// and a face all of whose nodes stay has no stack.
#pragma once

#include "Displacement/Displacement.h"
#include "Mesh/OutputMesh.h"

namespace cartesian
{

struct PrismStacks
{
  // Follow those of the mesh: points and cells are numbered on.
  std::vector<double> points; // x, y, z
  std::vector<Id> offsets;    // of each cell in connectivity, and the end
  std::vector<Id> connectivity;
  std::vector<Id> faceStart;    // of each cell in faceStream
  std::vector<Id> faceStream;   // as CellArrays::faceStream
  std::vector<unsigned char> layer; // of each cell, 1 at the wall
  std::vector<Id> below;        // of each cell, the number of the mesh's cell under its stack

  // Of the mesh with its stacks, in order of their cells.
  BoundaryMesh boundaryMesh;
  std::vector<BoundaryFace> boundary;

  std::size_t cells() const { return layer.size(); }
};

// On a mesh of all of the displaced surface.
PrismStacks liftBoundary(const OutputMesh& mesh, const Surface& displaced,
  const Displacement& displacement, Execution& execution);

}

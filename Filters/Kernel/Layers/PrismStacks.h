// SPDX-License-Identifier: BSD-3-Clause
// The boundary layers of a mesh: a stack of prisms on each boundary face of a layered wall.
//
// Points of the layers are on the line from a node to its place on the wall. Faces with a common edge share the side
// faces above it (StackSides.h). Towards boundaries without layers the side faces are boundary. A node without layers
// has none above it: a stack tapers to there and is one cell, as slices of a wedge are so skew that solvers diverge
// on them. A face with only such nodes has no stack. Nodes with layers belong to a stack that does not taper.
#pragma once

#include "Layers/LayerHeights.h"
#include "Layers/LayeredWall.h"

namespace cartesian
{

struct MovedPoint
{
  Id point;
  Vector to;
};

struct PrismStacks
{
  std::vector<MovedPoint> moved; // of the mesh

  // Follow those of the mesh: points and cells are numbered on.
  std::vector<double> points;           // x, y, z
  std::vector<std::size_t> nodeOfPoint; // of the wall
  std::vector<Id> offsets;              // of each cell in connectivity, and the end
  std::vector<Id> connectivity;
  std::vector<Id> faceStart;        // of each cell in faceStream
  std::vector<Id> faceStream;       // as CellArrays::faceStream
  std::vector<unsigned char> layer; // of each cell, 1 at the wall
  std::vector<std::size_t> face;    // of each cell, that of the wall under its stack
  std::vector<std::uint8_t> tapers; // of each cell
  std::vector<Id> below;            // of each cell, the number of the mesh's cell under its stack

  std::size_t cells() const { return layer.size(); }
};

// A face between two regions, as one of them has it with its stacks.
struct LayeredInterface
{
  std::size_t face;      // of OutputMesh::interfaces()
  std::int32_t region;   // the one that has it so
  Id cell;               // there
  std::int32_t boundary; // the user's, on this side
  double area;
  double asked; // as in LayeredBoundary
  double thickness;
  int layers;
};

// The boundary of the mesh with its stacks: faces without stacks, then those of each stack's cells.
struct LayeredBoundary
{
  BoundaryMesh mesh;
  std::vector<BoundaryFace> faces;
  std::vector<double> asked;     // thickness of all layers on each, in user units; 0: none
  std::vector<double> thickness; // of the stack below each, along its normal; 0: none
  std::vector<int> layers;       // of the stack below each: one where it tapers; 0: none
  std::vector<LayeredInterface> interfaces;
};

// Of faces whose corners are the mesh's points so far.
void numberPoints(BoundaryMesh& mesh);

PrismStacks stackPrisms(
  const OutputMesh& mesh, const LayeredWall& wall, const LayerHeights& heights);

LayeredBoundary boundaryOf(
  const OutputMesh& mesh, const LayeredWall& wall, const LayerHeights& heights);

}

// SPDX-License-Identifier: BSD-3-Clause
// The boundary layers of a mesh: a stack of prisms on each boundary face of a layered wall.
//
// Points of the layers are on the line from a node to its place on the wall. Faces with a common edge share the side
// faces above it (StackSides.h). Towards boundaries without layers the side faces are boundary. A node without layers
// has none above it: a stack tapers to there and is one cell (StackCells.h). A face with only such nodes has no stack. Nodes with
// layers belong to a stack that does not taper.
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
  std::vector<std::uint8_t>
    isFilm; // of each cell, its stack: fewer layers of it would lean too much beside more
  std::vector<Id> below; // of each cell, the number of the mesh's cell under its stack

  std::size_t cells() const { return layer.size(); }
};

// What a stack on a face is like.
struct StackMeasure
{
  double asked = 0;                 // thickness of all layers, in user units; 0: none
  double thickness = 0;             // of the stack, along the wall's normal; 0: none
  int layers = 0;                   // one where it tapers; 0: none
  LayerEnd end = LayerEnd::Nowhere; // why it is not whole; Nowhere: because of a stack beside it
  bool keepsFirst = false;          // a first layer as high as requested, within FirstWithin of it
  bool isWhole = false;             // ... and all layers
  double lastByCell = 0; // volume of the last layer by that of the cell beside it; 0: not known
};

// A face between two regions, as one of them has it with its stacks.
struct LayeredInterface
{
  std::size_t face;      // of OutputMesh::interfaces()
  std::int32_t region;   // the one that has it so
  Id cell;               // there
  std::int32_t boundary; // the user's, on this side
  double area;
  StackMeasure stack;
};

// The boundary of the mesh with its stacks: faces without stacks, then those of each stack's cells.
struct LayeredBoundary
{
  BoundaryMesh mesh;
  std::vector<BoundaryFace> faces;
  std::vector<StackMeasure> stacks; // of each
  std::vector<LayeredInterface> interfaces;
};

// Of faces whose corners are the mesh's points so far.
void numberPoints(BoundaryMesh& mesh);

// Adds the cells of `more` behind those of `stacks`; their points have the same numbers.
void appendCells(PrismStacks& stacks, const PrismStacks& more);

// With all points, and the cells of all stacks, or only of those on some faces of the wall. Nothing of the mesh is moved.
// `isWanted`: of each face; empty: all.
PrismStacks stackPrisms(const OutputMesh& mesh, const LayeredWall& wall,
  const LayerHeights& heights, const std::vector<std::uint8_t>& isWanted, Execution& execution);

// `lastByCell`: StackMeasure::lastByCell of each face of the wall.
LayeredBoundary boundaryOf(const OutputMesh& mesh, const LayeredWall& wall,
  const LayerHeights& heights, const std::vector<double>& lastByCell, Execution& execution);

}

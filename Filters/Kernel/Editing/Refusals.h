// SPDX-License-Identifier: BSD-3-Clause
// What solvers refuse (checkMesh): faces that are inverted as seen from a cell, faces too skew, degenerate cells. The second
// rule by which edits are decided, beside EditDecision.h: of the last step alone (RefusalEnding.h), which asks for no gain.
#pragma once

#include "Editing/MeshEditor.h"

namespace cartesian
{

// By what edits changed since the last commit. In order of rank: what comes first decides.
struct Refusals
{
  int inverted = 0;  // sides of faces
  int skew = 0;      // faces too skew, and degenerate cells
  double volume = 0; // of the cells that have inverted sides
  int poor = 0;      // limits of section 3, and checkMesh's (EditFace::fails)

  bool operator<(const Refusals& other) const;

  // As few inverted sides, and as few others, as that; whatever else.
  bool isWithin(const Refusals& other) const
  {
    return inverted <= other.inverted && skew <= other.skew;
  }
};

// Of the mesh around some cells, in all that changed; of these cells alone, which are there, those that are degenerate.
Refusals refusalsOf(const MeshEditor& mesh, const std::vector<std::uint32_t>& cells);

// Whether a side of a face is inverted as its cell sees it, or the face as its cells see each other.
bool isInvertedFrom(const MeshView& mesh, std::uint32_t f, std::uint32_t c);
bool hasInverted(const MeshView& mesh, std::uint32_t c);

// Whether there is nothing between its walls.
bool hasNoVolume(const MeshView& mesh, std::uint32_t c);

// Of fewer faces than a polyhedron has, or too long; but not where all is as thin.
bool isDegenerate(const MeshView& mesh, std::uint32_t c);

// Whether checkMesh refuses a cell, or one of its faces.
bool isRefused(const MeshView& mesh, std::uint32_t c);

// How much of that ends if nothing else does: sides that this cell sees, its faces, itself.
Refusals refusalsIn(const MeshView& mesh, std::uint32_t c);

}

// SPDX-License-Identifier: BSD-3-Clause
// The faces of a mesh as solvers number them (section 6, step 13): each once, between two cells.
#pragma once

#include "Base/Execution.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

// The faces of each cell. Cells, faces and points are fewer than 2^32 each.
struct CellFaces
{
  std::vector<std::size_t> firstFace;   // of each cell, and the end
  std::vector<std::size_t> firstCorner; // of each face, and the end
  std::vector<std::uint32_t> corners;   // points in order around the face

  std::size_t cellCount() const { return firstFace.size() - 1; }
  std::size_t faceCount() const { return firstCorner.size() - 1; }
};

// Turns over all faces of the cells whose volume is negative: afterwards corners run
// counter-clockwise from outside the cell, if the faces of each cell agreed with each other.
// `points`: three coordinates each.
void turnOutward(CellFaces& cells, const std::vector<double>& points, Execution& execution);

struct FaceList
{
  std::vector<std::uint32_t> face;      // in CellFaces, as the owner has it
  std::vector<std::uint32_t> owner;     // of each face
  std::vector<std::uint32_t> neighbour; // of the first faces; the others are the boundary
};

// Faces of the same corners in the same order, or of more than two cells.
enum class Clashes
{
  Refused,     // Error (BadMesh)
  AreBoundary, // of each of their cells
};

// Inner faces in upper triangular order: by owner, the lower of the two cells, then by neighbour.
// Then the boundary faces, by cell and by face of the cell. Two cells share a face if it has the
// same corners in opposite order. Throws Error (BadMesh): clashes that are refused, or too many
// cells, faces or points.
FaceList listFaces(
  const CellFaces& cells, std::size_t pointCount, Clashes clashes, Execution& execution);

// Puts the boundary faces in order of their patches, below `patchCount`, and leaves those of a patch
// in their order. `patch`: of each boundary face. Returns the number of faces of each patch.
std::vector<std::size_t> sortByPatch(
  FaceList& list, const std::vector<std::uint32_t>& patch, std::size_t patchCount);

}

// SPDX-License-Identifier: BSD-3-Clause
// The faces of a mesh as solvers number them (section 6, step 13): each once, with its two cells.
#pragma once

#include "Base/Execution.h"
#include "Base/RawVector.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

// The faces of each cell. Cells, faces and points are fewer than 2^32 each.
struct CellFaces
{
  RawVector<std::size_t> firstFace;   // of each cell, and the end
  RawVector<std::size_t> firstCorner; // of each face, and the end
  RawVector<std::uint32_t> corners;   // points in order around the face

  std::size_t cellCount() const { return firstFace.size() - 1; }
  std::size_t faceCount() const { return firstCorner.size() - 1; }
};

// Reverses all faces of cells with negative volume. Afterwards corners run counter-clockwise from outside the cell,
// provided that the faces of each cell were consistently oriented. `points`: three coordinates each.
void turnOutward(CellFaces& cells, const double* points, Execution& execution);

struct FaceList
{
  std::vector<std::uint32_t> face;      // index in CellFaces, of the owner's face
  std::vector<std::uint32_t> owner;     // of each face
  std::vector<std::uint32_t> neighbour; // of the inner faces, which come first
};

// Treatment of faces that have the same corners in the same order, or belong to more than two cells.
enum class Clashes
{
  Refused,     // Error (BadMesh)
  AreBoundary, // of each of their cells
};

// Lists the inner faces in upper triangular order (by owner, the lower of the two cells, then by neighbour), then the
// boundary faces by cell and by face of the cell. Two cells share a face if each has it with the same corners in
// opposite order. Throws Error (BadMesh): clashes that are errors, or too many cells, faces or points.
FaceList listFaces(
  const CellFaces& cells, std::size_t pointCount, Clashes clashes, Execution& execution);

// Makes inner faces, given in order, boundary faces of both their cells.
void openFaces(const CellFaces& cells, const std::vector<std::size_t>& inner, FaceList& list);

// The face of another cell with the same corners: past the cell's last if there is none.
std::size_t faceBeyond(const CellFaces& cells, std::size_t face, std::uint32_t cell);

// Sorts the boundary faces by patch, and keeps the order of those of one patch. `patch`: of each boundary
// face, below `patchCount`. Returns the number of faces of each patch.
std::vector<std::size_t> sortByPatch(
  FaceList& list, const std::vector<std::uint32_t>& patch, std::size_t patchCount);

}

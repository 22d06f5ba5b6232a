// SPDX-License-Identifier: BSD-3-Clause
// The edits of which all others are made. Each changes what it must and marks the rest as dirty (EditDecision.h):
// it returns false where the mesh has no place for it, and then has to be undone, as where the result is not valid.
// None looks at quality. They stay within free cells (EditMesh.h). Asserted where assert is: numbers are of what the mesh has, faces
// are there and of the cells named with them, corners are the face's.
#pragma once

#include "Editing/MeshEditor.h"

namespace cartesian
{

// Node u becomes node v, which moves to `at`: faces lose a corner, triangles go, and so do cells of two faces.
bool collapseEdge(MeshEditor& mesh, std::uint32_t u, std::uint32_t v, const Vector& at);

// Face g becomes part of face f: both between the same two cells, or of one wall and cell; they share one row of edges,
// whose inner nodes go.
bool joinFaces(MeshEditor& mesh, std::uint32_t f, std::uint32_t g);

// Face g of cell c becomes one of the cell beyond c's inner face f, and f grows by it: they share one row of edges. As where
// a wall hangs on a cell by a flap that is folded around its rim. No place, area of walls or volume in all changes.
bool passFace(MeshEditor& mesh, std::uint32_t c, std::uint32_t f, std::uint32_t g);

// Divides a face between its corners i and j. Returns the new one, or None.
std::uint32_t splitFace(MeshEditor& mesh, std::uint32_t f, std::size_t i, std::size_t j);

// The faces between two cells go, and b becomes part of a.
bool mergeCells(MeshEditor& mesh, std::uint32_t a, std::uint32_t b);

// The inner faces of a cell become walls of its neighbours (4.10).
bool removeCell(MeshEditor& mesh, std::uint32_t c);

// A face that is about to lose its upper cell, or its lower one, as a wall out of the other.
void makeWall(MeshEditor& mesh, std::uint32_t f, std::uint32_t without, std::int32_t wall);

// A place of whole levels near to this one; where a node is held, as it is.
Vector onLattice(const MeshView& mesh, const Vector& place, std::uint8_t held);

// Where corner n is in a face, or its number of corners.
std::size_t placeOf(Items corners, std::uint32_t n);

}

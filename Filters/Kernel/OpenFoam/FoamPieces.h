// SPDX-License-Identifier: BSD-3-Clause
// A mesh in pieces, one for each OpenFOAM process: what decomposePar would make of the whole mesh. No process needs
// that: each piece needs itself, and the outlines of all.
//
//   FoamPiece --outlineOf--> FoamOutline, of all pieces --numberFaces--> FaceNumbers
//   FoamPiece, FaceNumbers --completed--> CompletePiece
//
// Cells are numbered in the order of the pieces. The faces of the whole mesh are numbered as listFaces does
// (FaceList.h), with boundary faces in order of the boundaries.
#pragma once

#include "OpenFoam/FoamRegions.h"

#include <limits>

namespace cartesian
{

struct FoamPiece
{
  FoamMesh mesh;                    // without patches
  std::vector<std::int32_t> points; // the number of each in the whole mesh
  std::size_t firstCell;            // the same of the first; the others follow
  // Boundaries that have faces here, with how many, in order of the faces. The remaining faces are open: they
  // belong to no boundary, or another piece has them too.
  std::vector<std::pair<std::int32_t, std::size_t>> boundaries;
  FoamRegions regions = {}; // of the whole mesh, and of the cells; no names: there is one
};

// What all pieces must know about one.
struct FoamOutline
{
  struct OpenFace
  {
    std::size_t owner;           // in the whole mesh, as are the corners
    std::size_t innerFacesUntil; // of the cells up to the owner
    std::size_t firstCorner;     // the others follow
    std::size_t cornerCount;
    std::uint32_t region; // of the owner
  };

  std::size_t firstCell = 0;
  std::size_t cells = 0;
  std::size_t innerFaces = 0;
  std::vector<std::pair<std::int32_t, std::size_t>> boundaries;
  std::vector<OpenFace> openFaces;
  std::vector<std::int32_t> corners; // of the open faces

  // The same as numbers that processes can exchange, and back.
  std::vector<double> toNumbers() const;
  static FoamOutline fromNumbers(const std::vector<double>& numbers);
};

// The numbers that the faces of a piece have in the whole mesh.
struct FaceNumbers
{
  static constexpr std::size_t None = std::numeric_limits<std::size_t>::max();

  struct OpenFace
  {
    std::size_t piece = None;     // the other one that has it; None: a boundary face
    std::size_t number = 0;       // if there is another
    std::int32_t firstCorner = 0; // that of the owner's face
    bool isTurned = false;        // the owner is in the other piece
    std::uint32_t region = 0;     // of the cell there
  };
  struct Boundary
  {
    std::int32_t boundary; // NoBoundary, the last: of open faces
    std::size_t first;     // number of this piece's first face
    std::size_t count;     // of this piece's faces
  };

  std::size_t firstInner = 0; // number of the first, if no open face is before it
  std::vector<OpenFace> openFaces;
  std::vector<Boundary> boundaries; // all that the whole mesh has
};

FoamOutline outlineOf(const FoamPiece& piece);

// Of each piece. Throws Error (BadMesh): cells are not in order of the pieces, cells overlap, more faces than
// OpenFOAM can number.
std::vector<FaceNumbers> numberFaces(const std::vector<FoamOutline>& outlines);

struct CompletePiece
{
  FoamMesh mesh; // with patches and addressing
  FoamRegions regions;
};

// `number`: that of the piece. `patches`: of numbers.boundaries. Those between processes follow them.
CompletePiece completed(
  FoamPiece piece, std::size_t number, const FaceNumbers& numbers, std::vector<FoamPatch> patches);

}

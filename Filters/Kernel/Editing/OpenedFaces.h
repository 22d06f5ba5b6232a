// SPDX-License-Identifier: BSD-3-Clause
// The faces of the cells that are opened (WallOpening.h), then those of all other polyhedra, each once, and the vertices
// of the global mesh among their corners: what nodes and faces are made of.
#pragma once

#include "Cells/Boundary.h"

namespace cartesian
{

// Numbers in the mesh of cells that are opened, or None.
class OpenedCells
{
public:
  OpenedCells(const MeshParts& parts, Execution& execution);

  std::uint32_t& operator[](CellKey key)
  {
    return isHexahedron(key) ? ofHexahedron_[boxOfHexahedron(key)] : ofCell_[key];
  }
  std::uint32_t operator[](CellKey key) const
  {
    return isHexahedron(key) ? ofHexahedron_[boxOfHexahedron(key)] : ofCell_[key];
  }

private:
  static constexpr std::size_t NumbersAChunk = 1 << 16;

  RawVector<std::uint32_t> ofCell_;
  RawVector<std::uint32_t> ofHexahedron_; // by box
};

// A face as the cell below has it.
struct OpenedFace
{
  std::size_t begin; // in the list's corners
  std::size_t end;
  std::uint32_t number; // in WallFaces, or None
  CellKey below;
  CellKey above; // or None
  std::int32_t wall;
};

// The faces of a chunk of cells. Vertices of the global mesh that are not in Nodes are numbered behind those.
struct OpenedFaceList
{
  std::vector<OpenedFace> faces;
  std::vector<std::uint32_t> corners;
  std::vector<VertexNode> vertices;
  std::vector<std::uint64_t> ghosts; // box and key of their cells that are not opened
};

// All lists, and the vertices of all of them: one that several lists have is there several times.
struct OpenedFaces
{
  std::vector<OpenedFaceList> lists; // in the order of cells, then of faces
  std::vector<VertexNode> vertices;  // to which the corners' numbers refer
};

// Those between two cells that are opened are of the one below. With those of hexahedra where there is no cell beyond,
// but a box.
OpenedFaces listOpenedFaces(const MeshParts& parts, const std::vector<CellKey>& cells,
  const OpenedCells& numbers, Execution& execution);

// Takes them from the lists: each once, in the order of their boxes.
std::vector<CellKey> takeGhosts(OpenedFaces& faces, Execution& execution);

// By their cells, then by their corners, which become those of the mesh (nodeOf) and begin with the lowest.
void sortFaces(OpenedFaceList& list, const RawVector<std::uint32_t>& nodeOf);

}

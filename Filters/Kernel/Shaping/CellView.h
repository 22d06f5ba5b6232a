// SPDX-License-Identifier: BSD-3-Clause
// One cell, or several as one, taken out of the mesh for trials.
#pragma once

#include "Acceptance/CellFaults.h"
#include "Cells/WallMesh.h"

namespace cartesian
{

// `nodes`, `faces` and `across` lead back to the whole.
struct CellView
{
  Polyhedron shape;
  std::vector<std::uint32_t> nodes; // of each of the shape's nodes

  // Of each of the shape's faces:
  std::vector<FaceUse> faces;
  std::vector<CellKey> across;        // the cell beyond, or None
  std::vector<std::int32_t> boundary; // that it belongs to, where nothing is beyond
  std::vector<std::uint8_t> fixed;    // 1: beyond is a cell that no other face may change
  std::vector<NeighbourCell> beyond;  // filled by CellComplex::lookBeyond

  void reserve(std::size_t ofFaces, std::size_t ofCorners)
  {
    shape.reserve(0, ofFaces, ofCorners);
    faces.reserve(ofFaces);
    across.reserve(ofFaces);
    boundary.reserve(ofFaces);
    fixed.reserve(ofFaces);
  }

  void clear()
  {
    shape.clear();
    nodes.clear();
    faces.clear();
    across.clear();
    boundary.clear();
    fixed.clear();
    beyond.clear();
  }
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Whether the faces of a cell still close it, after an edit.
#pragma once

#include "Optimisation/NodeMesh.h"

namespace cartesian
{

class ClosedCells
{
public:
  explicit ClosedCells(const NodeMesh& mesh)
    : m_(mesh)
  {
  }

  // Whether each edge of a cell is between two faces, which have others too, and the cell has enough of them.
  bool isClosed(std::uint32_t c);

private:
  // An edge of a cell, by one of its faces.
  struct Side
  {
    std::uint32_t low;
    std::uint32_t high;
    bool isUp;
    std::uint32_t face;

    bool operator<(const Side& other) const;
    bool isOpposite(const Side& other) const;
    bool hasSameEdge(const Side& other) const;
  };

  void listSides(std::uint32_t c);
  bool areFoldedTogether();

  const NodeMesh& m_;
  std::vector<Side> sides_;
  std::vector<std::array<std::uint32_t, 2>> pairs_; // of faces that share an edge
};

}

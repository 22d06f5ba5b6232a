// SPDX-License-Identifier: BSD-3-Clause
// Edits that may take apart a cell that solvers reject (Refusals.h): most wrap around the rim of something thin that ends
// within them, so that the wall of its one side is inverted as seen from a centre on the other.
#pragma once

#include "Editing/CellCut.h"
#include "Editing/Proposals.h"

#include <initializer_list>

namespace cartesian
{

// In order of likelihood.
struct RefusalEdit
{
  enum class Kind : std::uint8_t
  {
    Pass,  // face b of cell c goes to the cell beyond its face a
    Join,  // face b becomes part of a
    Cut,   // cell a by `plane`; the face between parts may look back: a pass or a join follows
    Merge, // cell b becomes part of a
  };

  Kind kind;
  std::uint32_t a;
  std::uint32_t b = 0;
  std::uint32_t c = 0;
  CutPlane plane{};
};

// Of a cell with refused faces, the most likely first.
std::vector<RefusalEdit> editsOfRefused(const MeshView& mesh, std::uint32_t c);

// Through the middle of a cell, across its longest extents first.
std::vector<CutPlane> planesThroughMiddle(const MeshView& mesh, std::uint32_t c);

// ... and at such parts of the extents from there.
std::vector<CutPlane> planesAcross(
  const MeshView& mesh, std::uint32_t c, std::initializer_list<double> places);

}

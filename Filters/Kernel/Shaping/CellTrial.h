// SPDX-License-Identifier: BSD-3-Clause
// A cell taken out of the mesh, and its quality (Verdict.h): as it is, and with some of its faces joined.
#pragma once

#include "Acceptance/Acceptance.h"
#include "Shaping/CellComplex.h"

namespace cartesian
{

// Several cells as one, measured, with their neighbours.
void takeOut(
  const CellComplex& cells, const std::vector<CellKey>& keys, CellView& view, CellShape& shape);

// Of a cell as it is; leaves the result there.
Verdict verdictOf(const CellComplex& cells, CellKey key, MeasuredCell& cell);

// Examines cells one by one; keeps its memory.
struct CellTrial
{
  explicit CellTrial(const CellComplex& cells)
    : joiner(cells.featureCosine())
  {
  }

  void look(const CellComplex& cells, CellKey cell);

  // With the faces joined.
  Verdict joined();

  // Whether the joined faces have star triangulations, and are not there already.
  bool isSound(const CellComplex& cells) const;

  // The place of a face that another cell has too.
  std::uint32_t find(const FaceUse& face) const;

  // A ring of another cell, `way` from here to its origin, from this side; gets the nodes that it lacks.
  std::vector<std::uint32_t> seen(
    const std::vector<std::uint32_t>& ring, const CellView& from, const Vector& way);

  // Adds a group to the joined faces.
  void join(std::vector<std::uint32_t> members, std::vector<std::uint32_t> ring, bool recut);

  CellKey key = 0;
  CellView view;
  CellShape shape;
  Verdict now;
  JoinedFaces faces; // none at first
  FaceJoiner joiner;
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Faces of a cell made one where that mends it: the paper's IP patches (section 4.11).
#pragma once

#include "Shaping/CellComplex.h"

namespace cartesian
{

// Cells one after the other; keeps its memory. What it does leaves the cell at least 0.8 of its volume, four
// faces, and no face that its neighbours have too.
class FaceMender
{
public:
  explicit FaceMender(CellComplex& complex)
    : complex_(complex)
  {
  }

  // Joins faces that meet at no less than this cosine of the angle between their normals (FaceJoining.h)
  // where that helps; returns whether it did.
  bool joinFaces(CellKey key, double leastCosine);

  // Of a cell at fault: joins boundary faces at fault with one neighbour each, then faces that meet at
  // wider and wider angles; returns whether anything helped.
  bool mend(CellKey key);

private:
  void look(CellKey key);
  CellFaults tryOut(const JoinedFaces& joined);
  bool keepsCell() const;
  bool mendFace(CellKey key);

  CellComplex& complex_;
  CellView view_; // of the cell at hand
  CellShape shape_;
  Polyhedron trial_; // what is tried out
  CellShape after_;
  std::vector<NeighbourCell> beyond_;
};

}

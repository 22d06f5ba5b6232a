// SPDX-License-Identifier: BSD-3-Clause
// One cell, or several as one, with some of its faces joined: what that would cost, and the paper's IP
// patches (section 4.11) where solvers would refuse it.
#pragma once

#include "Shaping/CellTrial.h"

namespace cartesian
{

struct CellUnion
{
  std::vector<CellKey> keys; // the first takes the others in
  CellView view;
  JoinedFaces joined;
  Verdict verdict; // of its faces; its cost is that of the cell in all
  double gain = 0; // by how much the sum of all costs falls
};

// Looks at unions, one after the other; keeps its memory.
class UnionTrial
{
public:
  explicit UnionTrial(const CellComplex& cells)
    : cells_(cells)
    , joiner_(cells.featureCosine())
    , beyond_(cells)
  {
  }

  // Walls are joined across edges that turn by less: at first, than Feature Angle.
  void joinAcross(double leastCosine) { joiner_ = FaceJoiner(leastCosine); }

  // Of cells that have faces, joined as far as `joins` allows. The cost is that of its faces, of its volume as
  // a share of the first one's box, of volume that joined faces add or take; or Never, where it would have too
  // few faces, keep too little of its volume, or its faces cost more than `most` before any is joined.
  void tryOut(CellUnion& cells, const JoinSpec& joins, double most);

  // The same of cells that the view shows already.
  void tryOutView(CellUnion& cells, const JoinSpec& joins, double most = Never);

  // Of the union tried out last: as long as solvers refuse a face, or are strained by one, joins that which
  // costs most with the neighbour that helps most: the first at any angle, the second up to a bit more
  // than a right angle.
  void simplify(CellUnion& cells);

  // That can be merged: no two of its faces have the same nodes, nor a face near by.
  bool isSound(const CellUnion& cells) const;

  // By how much the costs of cells of other regions rise with the faces that are joined between them; Never or more,
  // where that is not accepted.
  double costBeyond(const CellUnion& cells);

private:
  Verdict joined(const CellUnion& cells, const JoinedFaces& faces, double most);
  double costBeyond(const CellUnion& cells, CellKey other);
  double volumeMoved(
    const CellView& view, const JoinedFaces& joined, const JoinedShape& result) const;

  const CellComplex& cells_;
  CellShape shape_; // of the view
  FaceJoiner joiner_;
  CellTrial beyond_; // of a cell of another region
};

}

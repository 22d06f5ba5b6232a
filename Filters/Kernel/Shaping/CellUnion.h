// SPDX-License-Identifier: BSD-3-Clause
// One cell, or several as one, with some of its faces joined: the cost, and the paper's IP patches (section 4.11) if it
// fails.
#pragma once

#include "Shaping/CellTrial.h"

#include <optional>

namespace cartesian
{

// Cells as one, taken out of the mesh, with their measures.
struct UnionView
{
  // As far as `spec` allows.
  struct Joined
  {
    JoinSpec spec;
    JoinedFaces faces;
    Verdict verdict;
  };

  std::vector<CellKey> keys; // the first takes the others in
  CellView view;
  CellShape shape;
  std::optional<Verdict> verdict; // of all faces, before any is joined
  std::optional<Joined> joined;   // as last requested
  FaceJoiner joiner;
};

struct CellUnion
{
  UnionView* of = nullptr; // borrowed
  JoinedFaces joined;
  Verdict verdict; // of its faces; its cost is that of the cell in all
  double gain = 0; // by how much the sum of all costs falls
};

// Examines unions one by one; keeps its memory.
class UnionTrial
{
public:
  explicit UnionTrial(const CellComplex& cells)
    : cells_(cells)
    , leastCosine_(cells.featureCosine())
    , beyond_(cells)
  {
  }

  // From now on walls are joined across edges that turn by less than this; initially Feature Angle.
  void joinAcross(double leastCosine) { leastCosine_ = leastCosine; }

  // Takes its cells, which have faces, out of the whole.
  void look(UnionView& cells) const;

  // With faces joined as far as `joins` allows. The cost is that of its faces, of its volume as
  // a share of the first one's box, of volume that joined faces add or take; or Never, where it would have too
  // few faces, keep too little of its volume, or its faces cost more than `most` before any is joined.
  void tryOut(CellUnion& cells, const JoinSpec& joins, double most = Never);

  // Of the last union tried: as long as a face fails or strains solvers, joins the costliest one with the neighbour
  // that helps most: the first at any angle, the second up to a bit more than a right angle.
  void simplify(CellUnion& cells);

  // That can be merged: no two of its faces have the same nodes, nor a face near by.
  bool isSound(const CellUnion& cells) const;

  // By how much the costs of cells of other regions rise with the faces that are joined between them; Never or more,
  // where that is not accepted.
  double costBeyond(const CellUnion& cells);

private:
  bool evaluate(UnionView& of, double most) const;
  UnionView::Joined joinAll(UnionView& of, const JoinSpec& joins) const;
  Verdict joined(UnionView& of, const JoinedFaces& faces, double most) const;
  double costBeyond(const CellUnion& cells, CellKey other);

  const CellComplex& cells_;
  double leastCosine_;
  CellTrial beyond_; // of a cell of another region
};

}

// SPDX-License-Identifier: BSD-3-Clause
// One cell, or several as one, with some of its faces joined: what that would cost, and the paper's IP
// patches (section 4.11) where solvers would refuse it.
#pragma once

#include "Shaping/CellComplex.h"

namespace cartesian
{

// The cost of what must not be.
constexpr double Never = 1e30;

// From here on a face strains solvers: skewness 2.4.
constexpr double StrainedCost = 5;

// What solvers think of faces.
struct FaceCosts
{
  double sum = 0;           // CellCost.h
  double worst = 0;         // of one face
  std::size_t refused = 0;  // faces that solvers refuse, or may refuse (CellFaults.h)
  std::size_t invalid = 0;  // of these, those that are turned over
  std::uint32_t toMend = 0; // of those, or else of all, the one that costs most

  FaceCosts& operator+=(const FaceCosts& other);
};

// Faces for which counts[face] is 0 are left out; if it is empty, all count. Ends where the sum is larger
// than `most`.
FaceCosts costsOf(const Polyhedron& cell, const CellShape& shape,
  const std::vector<NeighbourCell>& beyond, const std::vector<std::uint8_t>& counts = {},
  double most = Never);

struct CellUnion
{
  std::vector<CellKey> keys; // the first takes the others in
  CellView view;
  JoinedFaces joined;
  FaceCosts costs;
  double gain = 0; // by how much the sum of all costs falls; less than nothing: no such cell
};

// Looks at unions, one after the other; keeps its memory.
class UnionTrial
{
public:
  explicit UnionTrial(const CellComplex& cells)
    : cells_(cells)
    , joiner_(cells.featureCosine())
    , joinerBeyond_(cells.featureCosine())
  {
  }

  // Walls are joined across edges that turn by less: at first, than Feature Angle.
  void joinAcross(double leastCosine)
  {
    joiner_ = FaceJoiner(leastCosine);
    joinerBeyond_ = FaceJoiner(leastCosine);
  }

  // Of cells that have faces, joined as far as `joins` allows. Returns the cost in all: of its faces, of its
  // volume as a share of the first one's box, of volume that joined faces add or take; or Never, where it
  // would have too few faces, keep too little of its volume, or its faces cost more than `most` before any is
  // joined.
  double tryOut(CellUnion& cells, const JoinSpec& joins, double most);

  // The same of cells that the view shows already.
  double tryOutView(CellUnion& cells, const JoinSpec& joins, double most = Never);

  // Of the union tried out last: as long as solvers refuse a face, or are strained by one, joins that which
  // costs most with the neighbour that helps most: the first at any angle, the second up to a bit more
  // than a right angle. Returns the cost in the end.
  double simplify(CellUnion& cells, double cost);

  // That can be merged: no two of its faces have the same nodes, nor a face near by.
  bool isSound(const CellUnion& cells) const;

  // By how much the costs of cells of other regions rise with the faces that are joined between them; Never or more,
  // where solvers refuse more of them than before.
  double costBeyond(const CellUnion& cells);

private:
  double costOfCell(const CellUnion& cells, const Polyhedron& polyhedron, const CellShape& shape,
    const FaceCosts& costs) const;
  double costOfJoined(
    const CellUnion& cells, const JoinedFaces& joined, double most, FaceCosts& costs);
  double costBeyond(const CellUnion& cells, CellKey other);
  double volumeMoved(
    const CellView& view, const JoinedFaces& joined, const JoinedShape& result) const;

  const CellComplex& cells_;
  CellShape shape_; // of the view
  FaceJoiner joiner_;

  // Of a cell of another region:
  CellView beyond_;
  CellShape shapeBeyond_;
  FaceJoiner joinerBeyond_;
};

}

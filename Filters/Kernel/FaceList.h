// A mesh by its faces, each once, as OpenFOAM keeps it.
#pragma once

#include "Execution.h"

#include <vector>

namespace cartesian
{

using Id = long long;

// The faces of all cells as the cells name them: a face between two cells is in it twice.
struct CellFaces
{
  std::vector<Id> start{ 0 }; // first node of each face, and the end
  std::vector<Id> nodes;      // points, counter-clockwise from outside the cell
  std::vector<Id> cell;       // of each face, ascending

  Id size() const { return static_cast<Id>(cell.size()); }
};

// Inner faces come first, in upper-triangular order: by owner, then by neighbour. The others follow
// by owner.
struct FaceList
{
  std::vector<Id> start;     // first node of each face, and the end
  std::vector<Id> nodes;     // points, counter-clockwise from outside the owner
  std::vector<Id> owner;     // cell of each face, of two the lower
  std::vector<Id> neighbour; // the other cell of each inner face

  Id size() const { return static_cast<Id>(owner.size()); }
  Id innerSize() const { return static_cast<Id>(neighbour.size()); }
};

// Two cells share a face where they name the same points in opposite cyclic order. Points are from
// 0 to less than `points`.
FaceList shareFaces(const CellFaces& faces, Id points, Execution& execution);

}

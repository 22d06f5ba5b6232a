// SPDX-License-Identifier: BSD-3-Clause
// The sides of stacks: polygons over one or more edges of the faces below.
//
// Where a face's edges follow one another and lead to the same face, or to one boundary without layers, as along a
// finely divided rim, the side over them is one polygon as far as they are straight enough for it: small faces at the
// edge of large cells are skew.
#pragma once

#include "Layers/StackCells.h"

namespace cartesian
{

class StackSides
{
public:
  // Borrows all of them.
  StackSides(const LayeredWall& wall, const LayerHeights& heights, const StackCells& cells,
    Execution& execution);

  // Calls visit(i, n) for the sides over a face, in the k-th layer above the mesh: each is over the edges from corner i
  // of the face to corner i + n.
  template <class Visitor>
  void forEach(std::size_t face, std::size_t k, Visitor&& visit) const
  {
    const std::size_t corners = wall_.corners(face);
    std::size_t first = 0;
    while (first < corners && isInner(face, first, k))
    {
      ++first;
    }
    for (std::size_t i = first; i < first + corners;)
    {
      std::size_t n = 1;
      while (n < corners && isInner(face, i + n, k))
      {
        ++n;
      }
      visit(i % corners, n);
      i += n;
    }
  }

private:
  // Edges of one face from corner `first` that lead to the same place.
  struct Run
  {
    std::size_t face;
    std::size_t first;
    std::size_t edges;
  };

  bool leadAlike(std::size_t face, std::size_t i) const;
  void divideFace(std::size_t face);
  void divide(const Run& run, std::size_t k);
  bool isStraight(const Run& part, std::size_t k) const;
  double thicknessOf(const Run& part, std::size_t k) const;
  std::uint8_t isInner(std::size_t face, std::size_t i, std::size_t k) const
  {
    return inner_[k * wall_.beyond.size() + wall_.corner(face, i)];
  }

  const LayeredWall& wall_;
  const LayerHeights& heights_;
  const StackCells& cells_;
  std::vector<std::uint8_t> inner_; // of each layer's corners: it is within a side, not at its end
};

}

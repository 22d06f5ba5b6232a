// SPDX-License-Identifier: BSD-3-Clause
// Divides a warped polygon by diagonals into parts that are flat enough, as few as follow from the triangulation of the
// best shape.
#pragma once

#include "Lattice/Vector.h"

#include <array>
#include <cstdint>
#include <vector>

namespace cartesian
{

// Any unit of length.
struct FlatEnough
{
  double off;  // of a face's centre from the mean of its corners, along the normal
  double warp; // of its corners from the plane through its centre
};

class FaceDivision
{
public:
  using Part = std::vector<std::uint32_t>; // corners, by their places in the polygon
  using Diagonal = std::array<std::uint32_t, 2>;

  // The polygon itself, if it is flat enough or cannot be divided: each part faces the centre of the cell below, and as the
  // polygon does. `corners`: counter-clockwise from outside the cell. `barred`: diagonals between corners, the lower first.
  const std::vector<Part>& divide(const std::vector<Vector>& corners, const Vector& cell,
    const FlatEnough& flat, const std::vector<Diagonal>& barred = {});

private:
  double excessOf(const Part& ring, const FlatEnough& flat) const;
  bool faces(const Part& ring) const;
  double costOf(const Part& triangle) const;
  bool triangulate(const std::vector<Diagonal>& barred);
  void listTriangles(std::size_t i, std::size_t k);
  void joinFlat(const FlatEnough& flat);
  bool joinFlattest(const FlatEnough& flat);
  bool isConvex(const Part& ring) const;

  const std::vector<Vector>* corners_ = nullptr;
  Vector cell_{};
  Vector normal_{};
  std::vector<double> cost_;      // of the part from one corner to another
  std::vector<std::size_t> apex_; // of the triangle on its chord
  std::vector<Part> parts_;
};

}

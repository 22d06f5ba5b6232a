// SPDX-License-Identifier: BSD-3-Clause
// Which faces of a cell solvers refuse (CellFaults.h), with either of the two centres that solvers compute.
#pragma once

#include "Acceptance/CellFaults.h"

namespace cartesian
{

// Borrows its arguments; measures the other centre once that is asked for.
class Refusal
{
public:
  // `beyond`: of each face, the cell there.
  Refusal(const Polyhedron& cell, const CellShape& shape, const std::vector<NeighbourCell>& beyond)
    : cell_(cell)
    , shape_(shape)
    , beyond_(beyond)
  {
  }

  bool isRefused(std::size_t face)
  {
    if (cartesian::isRefused(cell_, shape_, face, beyond_[face]))
    {
      return true;
    }
    const bool boundary = cell_.isBoundary[face] != 0;
    if (!mayBeDoubtful(shape_, boundary, face))
    {
      return false;
    }
    if (projected_.faces.empty())
    {
      measureProjected(cell_, projected_);
    }
    return isDoubtful(projected_, boundary, face);
  }

private:
  const Polyhedron& cell_;
  const CellShape& shape_;
  const std::vector<NeighbourCell>& beyond_;
  CellShape projected_;
};

}

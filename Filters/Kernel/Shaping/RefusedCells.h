// SPDX-License-Identifier: BSD-3-Clause
// The last resort where neither a cut, nor a merge, nor an IP patch mends a cell (section 4.11): it is
// removed as a small cell is (4.10).
#pragma once

#include "Base/Execution.h"
#include "Shaping/CellComplex.h"

#include <set>

namespace cartesian
{

// Cells with refused faces (CellFaults.h; by either centre of bent faces), or too few; of an inner
// face's two the smaller goes. Only cells with a boundary face go, smaller than `largest` volumes of their
// box, or than R where their boundary has its own.
class RefusedCells
{
public:
  RefusedCells(CellComplex& cells, const SmallCellSpec& small, Execution& execution)
    : cells_(cells)
    , small_(small)
    , execution_(execution)
  {
  }

  // Of these cells, in order, and of those that could not go before. In rounds, the smallest first, so that
  // the result depends on the cells only. Returns how many were removed.
  std::size_t remove(const std::vector<CellKey>& keys, double largest);

private:
  struct Candidate
  {
    double volume; // as a part of its box
    CellKey key;

    bool operator<(const Candidate& other) const;
  };

  Candidate candidate(CellKey key) const;
  bool mayGo(const Candidate& candidate) const;
  void lookAt(CellKey key, MeasuredCell& cell, std::set<Candidate>& candidates);
  std::vector<CellKey> removeSome(const std::vector<CellKey>& keys);

  CellComplex& cells_;
  const SmallCellSpec& small_;
  Execution& execution_;
  double largest_ = 0;
  std::size_t removed_ = 0;
  std::set<CellKey> stay_; // refused, but too large to go
};

}

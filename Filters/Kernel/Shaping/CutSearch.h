// SPDX-License-Identifier: BSD-3-Clause
// Where a cell is cut (section 4.11): along concave edges, the worst first.
#pragma once

#include "Polyhedra/PolyhedronCut.h"
#include "Shaping/CellView.h"

#include <functional>
#include <optional>
#include <vector>

namespace cartesian
{

// Tries cuts of a cell one by one; keeps its memory.
class CutParts
{
public:
  // Borrows both. `shape`: the view's.
  CutParts(const CellView& view, const CellShape& shape)
    : view_(view)
    , shape_(shape)
  {
  }

  // Borrows the cut. False, and ends, with a part whose volume is not larger than `least`.
  bool make(const CellCut& cut, double least);

  double largestAspect() const; // a sixth of the area by volume^(2/3)

  // The faults of all parts; of one, if nothing is beyond the cut.
  CellFaults faults();
  CellFaults faultsAlone(std::size_t part) const;

  std::vector<Polyhedron> parts;
  std::vector<CellShape> shapes;
  double smallest = 0; // volume

private:
  template <class Visitor>
  void forEachFace(std::size_t part, Visitor&& visit) const;
  void measurePart(std::size_t part);

  const CellView& view_;
  const CellShape& shape_;
  const CellCut* cut_ = nullptr;
  std::vector<NeighbourCell> beyond_;
  std::vector<std::uint8_t> counts_; // a face between two parts once
};

// The faults after a cut, or nothing if it must not be made.
using Judge = std::function<std::optional<CellFaults>(const CellCut&)>;

struct FoundCuts
{
  std::vector<CellCut> helpful; // the fittest last
  // If there is none, one along the worst concave edge that does no harm.
  std::optional<CellCut> harmless;
};

// Angles by which planes that halve the angle at an edge are turned about it, in radians: all are tried.
using Turns = std::vector<double>;

// `before`: of the cell as it is.
FoundCuts searchCuts(const CellView& view, const CellShape& shape, const CellFaults& before,
  const Judge& judge, const Turns& turns = { 0 });

}

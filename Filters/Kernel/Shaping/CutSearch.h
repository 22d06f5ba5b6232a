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

// What a cut would make of a cell. Borrows its arguments.
struct CutParts
{
  // Ends with a part whose volume is not larger than `least`: then they are not all.
  CutParts(const CellView& of, const CellCut& by, double least);

  double largestAspect() const; // a sixth of the area by volume^(2/3)

  // What is at fault of all parts; of one, if nothing is beyond the cut.
  CellFaults faults() const;
  CellFaults faultsAlone(std::size_t part) const;

  const CellView& view;
  const CellCut& cut;
  std::vector<Polyhedron> parts;
  std::vector<CellShape> shapes;
  bool areAll = true;
  double smallest; // volume

private:
  template <class Visitor>
  void forEachFace(std::size_t part, Visitor&& visit) const;
};

// What would be at fault after a cut, or nothing where it must not be made.
using Judge = std::function<std::optional<CellFaults>(const CellCut&)>;

struct FoundCuts
{
  std::vector<CellCut> helpful; // the fittest last
  // Where there is none, one along the worst concave edge that does no harm.
  std::optional<CellCut> harmless;
};

// Angles by which planes that halve the angle at an edge are turned about it, in radians: all are tried.
using Turns = std::vector<double>;

// `before`: of the cell as it is.
FoundCuts searchCuts(const CellView& view, const CellShape& shape, const CellFaults& before,
  const Judge& judge, const Turns& turns = { 0 });

}

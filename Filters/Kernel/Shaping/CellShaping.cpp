// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellShaping.h"

#include "Optimisation/NodeOptimisation.h"
#include "Shaping/CellCarving.h"
#include "Shaping/CellMerging.h"
#include "Shaping/CellSplitting.h"
#include "Shaping/FaceMending.h"
#include "Shaping/RefusedCells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cartesian
{

namespace
{

// Faces of a merged cell become one where their normals differ by less, in degrees: boundary faces, and faces
// to the same cell.
constexpr double MergeJoinAngle = 3;
constexpr double InnerJoinAngle = 20;

// Those at the boundary below a part of their box: R of their boundary, but not more than `most`.
// Elsewhere they would leave a hole.
void removeSmallCells(CellComplex& complex, const SmallCellSpec& spec, double most)
{
  for (const CellKey key : complex.polyhedra())
  {
    const double share = complex.share(key);
    if (share < most && share < ratioOf(spec, complex.boundaryOfCell(key), spec.ratio) &&
      complex.isAtBoundary(key))
    {
      complex.remove(key);
    }
  }
}

// What is done to the cells of one slab.
class Shaper
{
public:
  Shaper(CellComplex& complex, const SmallCellSpec& small, const ShapingSpec& spec, bool exact,
    Execution& execution)
    : complex_(complex)
    , small_(small)
    , spec_(spec)
    , exact_(exact)
    , execution_(execution)
    , mender_(complex)
  {
    mergeSpec_.ratio = spec.mergeRatio;
    if (!exact)
    {
      mergeSpec_.joins = { std::cos(radians(MergeJoinAngle)), std::cos(radians(InnerJoinAngle)) };
    }
  }

  Shaping run()
  {
    removeSmall(Sliver);
    mergeSmall();
    for (int pass = 0; spec_.splitConcave && pass < Passes; ++pass)
    {
      joinFlatFaces();
      split();
      mergeSmall();
      mergeFailing();
      mend();
    }
    mergePoor();
    removeSmall(1);
    return shaping_;
  }

  // What neither merging nor moving nodes has saved. The smallest first, as a removal may be enough for the
  // neighbours. What it exposes can be mended; what is too large to go can lose a part.
  Shaping removeRefused()
  {
    RefusedCells refused(complex_, small_, execution_);
    std::uint32_t looked = 0;
    for (std::size_t pass = 0; pass < LargestShares.size(); ++pass)
    {
      mend();
      shaping_.partsCarved +=
        carveCells(complex_, complex_.polyhedraAtFault(), MostCarved, execution_);
      mend();
      removeSmall(1);
      // Only a look at all cells finds skewed inner faces: once, and in the end at what has changed.
      std::vector<CellKey> keys;
      if (pass == 0)
      {
        complex_.lookAtChanged();
        keys = complex_.polyhedra();
        looked = complex_.mark();
      }
      else
      {
        const bool last = pass + 1 == LargestShares.size();
        keys = last ? complex_.polyhedraChangedSince(looked) : complex_.polyhedraAtFault();
      }
      shaping_.refusedCellsRemoved +=
        refused.remove(keys, LargestShares[pass] * spec_.refusedCellRatio);
    }
    return shaping_;
  }

private:
  // What cannot be merged is small beyond use.
  void removeSmall(double most)
  {
    if (small_.handling == SmallCells::Merge && !exact_)
    {
      removeSmallCells(complex_, small_, most);
    }
  }

  void mergeSmall()
  {
    if (small_.handling == SmallCells::Merge)
    {
      shaping_.cellsMerged += mergeSmallCells(complex_, mergeSpec_, execution_);
    }
  }

  void mergeFailing()
  {
    if (small_.handling == SmallCells::Merge)
    {
      shaping_.cellsMerged += mergeFailingCells(complex_, mergeSpec_, execution_);
    }
  }

  void mergePoor()
  {
    if (small_.handling == SmallCells::Merge && !exact_)
    {
      complex_.lookAtChanged();
      shaping_.cellsMerged += mergePoorCells(complex_, mergeSpec_, execution_);
    }
  }

  void joinFlatFaces()
  {
    const double leastCosine = exact_ ? OnOnePlane : std::cos(radians(spec_.joinAngle));
    for (const CellKey key : complex_.polyhedraAtFault())
    {
      execution_.poll();
      mender_.joinFaces(key, leastCosine);
    }
  }

  void split()
  {
    const double least = small_.handling == SmallCells::Remove ? small_.ratio : 0;
    shaping_.cellsSplit +=
      splitCells(complex_, complex_.polyhedraAtFault(), least, execution_).cellsSplit;
  }

  void mend()
  {
    for (const CellKey key : exact_ ? std::vector<CellKey>{} : complex_.polyhedraAtFault())
    {
      execution_.poll();
      shaping_.cellsMended += mender_.mend(key) ? complex_.counts(key) : 0;
    }
  }

  // What one pass has left the second mends in part; a third finds hardly anything.
  static constexpr int Passes = 2;
  static constexpr double OnOnePlane = 1;

  // Cells below this part of their box are a wall next to a meshline: merged, they would stick out of
  // their neighbour.
  static constexpr double Sliver = 1e-9;

  static constexpr std::array<double, 4> LargestShares{ 0.025, 0.25, 1, 1 };

  // A carved cell loses no more than this part of its box.
  static constexpr double MostCarved = 0.5;

  CellComplex& complex_;
  const SmallCellSpec& small_;
  const ShapingSpec& spec_;
  bool exact_;
  Execution& execution_;
  FaceMender mender_;
  MergeSpec mergeSpec_;
  Shaping shaping_;
};

// Of the time that is left (Execution::nextLoop).
struct Shares
{
  double shaping;
  double optimisation;
  double removal;
};

constexpr std::array<Shares, ShapingStages> SharesOfStages{ { { 0.35, 0.5, 0.2 },
  { 0.45, 0.6, 0.8 } } };

void optimise(
  CellsToShape& whole, const std::vector<Slab>& slabs, double featureAngle, Execution& execution)
{
  const WallParts parts(
    whole.boxes, whole.patches, whole.sides, whole.nodes, whole.inner, whole.cells, whole.sideOf);
  for (const std::uint32_t cell :
    optimiseNodes(parts, slabs, featureAngle, whole.nodes, whole.cells, execution))
  {
    whole.known.atFault[cell] = IsAtFault::Unknown;
  }
  const std::vector<Point>& at = whole.nodes.at;
  std::sort(whole.nodes.ofCuts.begin(), whole.nodes.ofCuts.end(),
    [&](std::uint32_t a, std::uint32_t b) { return at[a] < at[b]; });
}

}

Shaping operator+(Shaping sum, const Shaping& other)
{
  sum.cellsSplit += other.cellsSplit;
  sum.cellsMerged += other.cellsMerged;
  sum.cellsMended += other.cellsMended;
  sum.partsCarved += other.partsCarved;
  sum.refusedCellsRemoved += other.refusedCellsRemoved;
  return sum;
}

bool shapesCells(const SmallCellSpec& small, const ShapingSpec& spec)
{
  return small.handling == SmallCells::Merge || spec.splitConcave;
}

Shaping shapeCells(const Boxes& boxes, const Patches& patches, Sides& sides, Nodes& nodes,
  const InnerFaces& inner, Cells& cells, const SmallCellSpec& small, const ShapingSpec& spec,
  double featureAngle, Execution& execution)
{
  const bool exact = isExact(patches);
  const std::uint32_t all = boxes.allLayers().end;
  CellsToShape whole(boxes, patches, sides, nodes, inner, cells);
  Shaping sum;
  std::size_t stage = 0;
  for (const std::vector<Slab>& slabs : slabsFor(boxes.core.grown(HaloOfShapedCells, all), all))
  {
    const Shares& shares = SharesOfStages[stage++];
    if (slabs.empty())
    {
      continue;
    }
    const auto inSlabs = [&](double share, auto&& shape) {
      execution.nextLoop(0.02);
      whole.measure({ slabs.front().layers.begin, slabs.back().layers.end }, execution);
      std::vector<std::unique_ptr<CellComplex>> complexes(slabs.size());
      std::vector<Shaping> shapings(slabs.size());
      execution.nextLoop(share);
      execution.forEach(slabs.size(), 1, [&](std::size_t s, std::size_t) {
        Execution alone = execution.alone();
        complexes[s] = std::make_unique<CellComplex>(whole, slabs[s]);
        Shaper shaper(*complexes[s], small, spec, exact, alone);
        shapings[s] = shape(shaper);
      });
      sum = std::accumulate(shapings.begin(), shapings.end(), sum);
      writeBack(whole, complexes, execution);
    };
    inSlabs(shares.shaping, [](Shaper& shaper) { return shaper.run(); });
    if (spec.optimiseNodes && !exact)
    {
      execution.nextLoop(shares.optimisation);
      optimise(whole, slabs, featureAngle, execution);
    }
    if (spec.splitConcave && spec.refusedCellRatio > 0 && !exact)
    {
      inSlabs(shares.removal, [](Shaper& shaper) { return shaper.removeRefused(); });
    }
  }
  return sum;
}

}

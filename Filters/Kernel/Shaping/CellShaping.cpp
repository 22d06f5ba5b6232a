// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellShaping.h"

#include "Cells/FlatBorders.h"
#include "Optimisation/NodeOptimisation.h"
#include "Shaping/CellCession.h"
#include "Shaping/CellSplitting.h"
#include "Shaping/FewFaces.h"
#include "Shaping/InterfaceMending.h"
#include "Shaping/InvalidCells.h"
#include "Shaping/PartTransfer.h"
#include "Shaping/RefusedCells.h"
#include "Shaping/TipRemoval.h"
#include "Shaping/WallJoining.h"

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

// Cells between regions cannot be removed if a merge fails later: larger ones are not merged.
constexpr double LargestMergedBetweenRegions = 0.15;

MergeSpec mergeSpecOf(const ShapingSpec& spec, bool merges, bool exact, bool hasRegions)
{
  MergeSpec merging;
  merging.ratio =
    hasRegions ? std::min(spec.mergeRatio, LargestMergedBetweenRegions) : spec.mergeRatio;
  merging.merges = merges;
  merging.simplifies = spec.splitConcave && !exact;
  if (!exact)
  {
    merging.joins = { std::cos(radians(MergeJoinAngle)), std::cos(radians(InnerJoinAngle)) };
  }
  return merging;
}

// Whether failing cells are repaired again, and removed, in a later stage.
bool removesLater(const ShapingSpec& spec, bool exact)
{
  return spec.splitConcave && spec.refusedCellRatio > 0 && !exact;
}

// Shapes the cells of one slab.
class Shaper
{
public:
  // `isLast`: no other slab looks at cells after this one.
  Shaper(
    CellComplex& complex, const ShapingTask& task, bool exact, bool isLast, Execution& execution)
    : complex_(complex)
    , task_(task)
    , exact_(exact)
    , isLast_(isLast)
    , merges_(task.small.handling == SmallCells::Merge)
    , execution_(execution)
    , mergeSpec_(mergeSpecOf(task.spec, merges_, exact, complex.hasRegions()))
    , merger_(complex, mergeSpec_, execution)
  {
  }

  Shaping run()
  {
    execution_.stage("Merging", 0, 0.25);
    removeSlivers();
    if (!exact_)
    {
      cedeFlat();
    }
    const bool cutsFirst = task_.spec.splitConcave && !exact_ && !complex_.hasRegions();
    merger_.bendInvalid(!cutsFirst);
    mergeSmall();
    if (task_.spec.splitConcave)
    {
      execution_.stage("Splitting", 0.25, 0.6);
      split();
      if (cutsFirst)
      {
        cutInvalid();
      }
      execution_.stage("Merging", 0.6, 0.7);
      mergeSmall();
    }
    execution_.stage("Improving", 0.7, 1);
    merger_.bendInvalid(true);
    improve();
    if (!exact_ && task_.spec.splitConcave)
    {
      cutInvalid();
      improve();
    }
    if (!removesLater(task_.spec, exact_))
    {
      mergeFewFaced();
    }
    joinWalls();
    return result();
  }

  // Where nodes have moved.
  Shaping mendRefused()
  {
    execution_.stage("Improving", 0, 1);
    improve();
    removeTips();
    removeSmall();
    cedeFlat();
    cutInvalid();
    improve();
    if (merger_.refused(isLast_).empty())
    {
      finish();
      mergeFewFaced();
    }
    else
    {
      shaping_.isAnyRefused = true;
    }
    return result();
  }

  // Cells that could not be repaired are removed: small ones first, then parts of others, finally whole cells. Each
  // time exposed cells may be repaired again.
  Shaping removeRefused(bool isLastPass)
  {
    execution_.stage("Improving", 0, 0.4);
    improve();
    removeSmall();
    improve();
    for (std::size_t pass = 0; pass < LargestShares.size(); ++pass)
    {
      execution_.stage("Removing", 0.4 + 0.075 * double(pass), 0.4 + 0.075 * double(pass + 1));
      std::vector<CellKey> keys = merger_.refused(isLast_);
      if (keys.empty())
      {
        break;
      }
      if (cedeCells(
            complex_, keys, std::min(LargestShares[pass], LargestCeded), merger_, execution_))
      {
        keys = merger_.refused(isLast_);
      }
      if (pass > 0)
      {
        transfer(keys, LeftOver::IsRemoved, givenAwayAt_);
        keys = merger_.refused(isLast_);
      }
      cartesian::removeRefused(complex_, keys, task_.small,
        LargestShares[pass] * task_.spec.refusedCellRatio, execution_, shaping_.refused);
      removeSmall();
      improve();
    }
    finish();
    noteRefused();
    if (isLastPass || !shaping_.isAnyRefused) // then no pass follows
    {
      mergeFewFaced();
    }
    return result();
  }

private:
  // For the slabs of the next stage.
  void noteRefused()
  {
    MeasuredCell cell;
    for (const CellKey key : merger_.refused(isLast_))
    {
      complex_.lookAround(key, cell);
      if (failsCheckMesh(faultsOf(cell.shape, cell.measures, cell.beyond)))
      {
        shaping_.isAnyRefused = true;
        break;
      }
    }
  }

  void mergeFewFaced()
  {
    shaping_.cellsMerged +=
      cartesian::mergeFewFaced(complex_, merger_.lookedAfter(isLast_), execution_);
  }

  void finish()
  {
    removeTips();
    joinWalls();
    if (complex_.hasRegions())
    {
      cutInvalid();
    }
  }

  void cutInvalid()
  {
    shaping_.cellsSplit += splitInvalid(complex_, merger_.refused(isLast_), execution_);
  }

  // Where layers are requested.
  void joinWalls()
  {
    if (task_.layers && !exact_)
    {
      cartesian::joinWalls(complex_, merger_.lookedAfter(isLast_), *task_.layers, execution_);
    }
  }

  // Walls next to a meshline: if merged, they would stick out of their neighbour.
  void removeSlivers()
  {
    removeSmaller(LeastOfThick, [](CellKey) { return true; });
  }

  // Small cells that strain solvers and cannot be merged; and cells that no face connects with others, where a solver
  // cannot determine the pressure. Cells as thin as the body there stay; a film on a side of a flow domain does not,
  // as below a wheel on the ground.
  void removeSmall()
  {
    removeSmaller(1, [&](CellKey key) {
      return complex_.neighbours(key).empty() ||
        (task_.isAround && complex_.share(key) < LargestFilm && isAtEndOfGrid(key)) ||
        (merger_.isFailing(key) && keepsWall(complex_, key) && !isThinThere(key));
    });
  }

  bool isAtEndOfGrid(CellKey key) const
  {
    const Boxes& boxes = complex_.boxes();
    const Box box = boxes.box(complex_.boxOf(key));
    bool isAtEnd = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      isAtEnd = isAtEnd || box.low[axis] == boxes.planes[axis].front() ||
        box.high[axis] == boxes.planes[axis].back();
    }
    return isAtEnd;
  }

  // Whether the body is as thin as the cell: there is no larger one beside it.
  bool isThinThere(CellKey key) const
  {
    const auto neighbours = complex_.neighbours(key);
    return std::none_of(neighbours.begin(), neighbours.end(),
      [&](const auto& neighbour) { return complex_.share(neighbour.first) >= LeastOfHost; });
  }

  // Cells at the boundary (elsewhere they would leave a hole) below a part of their box: R of their boundary, but not
  // more than `most`.
  template <class MayGo>
  void removeSmaller(double most, MayGo&& mayGo)
  {
    if (!merges_ || exact_)
    {
      return;
    }
    for (const CellKey key : merger_.lookedAfter(isLast_))
    {
      const double share = complex_.share(key);
      if (share < most &&
        share < ratioOf(task_.small, complex_.boundaryOfCell(key), task_.spec.strandedRatio()) &&
        complex_.isAtBoundary(key) && mayGo(key) && sparesOthers(complex_, key))
      {
        complex_.remove(key);
      }
    }
  }

  void cedeFlat()
  {
    cedeCells(complex_, merger_.lookedAfter(isLast_), FlatCell, merger_, execution_);
  }

  void removeTips()
  {
    if (merges_ && mergeSpec_.simplifies)
    {
      std::vector<CellKey> keys = merger_.lookedAfter(isLast_);
      keys.erase(std::remove_if(keys.begin(), keys.end(),
                   [&](CellKey key) {
                     return complex_.share(key) >= 2 * LargestTip || !merger_.isFailing(key) ||
                       !keepsWall(complex_, key) || isThinThere(key);
                   }),
        keys.end());
      cartesian::removeTips(complex_, keys, task_.small, LargestTip, mergeSpec_.joins);
      improve();
    }
  }

  void mergeSmall()
  {
    if (merges_)
    {
      merger_.mergeSmall();
    }
  }

  void split()
  {
    const double least = merges_ ? 0 : task_.small.ratio;
    shaping_.cellsSplit +=
      splitCells(complex_, complex_.polyhedraAtFault(), least, execution_).cellsSplit;
  }

  // A transfer may help its neighbours.
  void improve()
  {
    for (int pass = 0; !exact_ && pass < Passes; ++pass)
    {
      complex_.lookAtChanged();
      merger_.improve();
      if (complex_.hasRegions())
      {
        mendInterfaces(complex_, merger_.refused(isLast_), execution_);
      }
      if (mergeSpec_.simplifies && merges_)
      {
        transfer(merger_.refused(isLast_), LeftOver::ComesBack, transferredAt_);
      }
    }
  }

  // Parts of failing cells; not again where nothing near by has changed since `triedAt`.
  void transfer(std::vector<CellKey> keys, LeftOver leftOver, std::uint32_t& triedAt)
  {
    const auto isTried = [&](CellKey key) { return !complex_.hasChangedNear(key, triedAt); };
    if (triedAt > 0)
    {
      keys.erase(std::remove_if(keys.begin(), keys.end(), isTried), keys.end());
    }
    triedAt = complex_.mark();
    transferParts(complex_, keys, leftOver, merger_, execution_, shaping_.refused);
  }

  Shaping result()
  {
    shaping_.cellsMerged = merger_.merged();
    shaping_.cellsSimplified = merger_.simplified();
    return shaping_;
  }

  static constexpr int Passes = 2;

  // Of its box: a cell that its neighbour could have been merged with.
  static constexpr double LeastOfHost = 0.15;

  // Of its box.
  static constexpr double LargestFilm = 1e-3;

  // Up to this part of its box a cell may move to another region.
  static constexpr double LargestCeded = 0.1;

  // Below this part of their box tips are removed.
  static constexpr double LargestTip = 0.05;

  static constexpr std::array<double, 8> LargestShares{ 0.025, 0.1, 0.25, 0.25, 1, 1, 1, 1 };

  CellComplex& complex_;
  const ShapingTask& task_;
  bool exact_;
  bool isLast_;
  bool merges_;
  Execution& execution_;
  MergeSpec mergeSpec_;
  CellMerger merger_;
  std::uint32_t transferredAt_ = 0; // all failing cells have been tried since
  std::uint32_t givenAwayAt_ = 0;   // likewise
  Shaping shaping_;
};

// Of the time that is left (Execution::nextLoop).
struct Shares
{
  double shaping;
  double optimisation;
  double removal;
};

// The second may repair what the first has exposed.
constexpr int RemovalPasses = 2;

constexpr std::array<Shares, ShapingStages> SharesOfStages{ { { 0.35, 0.5, 0.2 },
  { 0.45, 0.6, 0.8 } } };

// One stage: its slabs, step by step.
class Stage
{
public:
  Stage(ShapedWall& whole, std::vector<Slab> slabs, const ShapingTask& task, bool isLast,
    Execution& execution)
    : whole_(whole)
    , slabs_(std::move(slabs))
    , task_(task)
    , exact_(isExact(whole.patches))
    , isLast_(isLast)
    , execution_(execution)
    , edits_(slabs_.size())
  {
  }

  Shaping run(const Shares& shares)
  {
    const bool removes = removesLater(task_.spec, exact_);
    shape(shares.shaping, [](Shaper& shaper) { return shaper.run(); });
    optimise(shares.optimisation, NodesMove::All);
    if (removes)
    {
      shape(shares.removal, [](Shaper& shaper) { return shaper.mendRefused(); });
      keepFailing();
      for (int pass = 0; pass < RemovalPasses; ++pass)
      {
        optimise(shares.optimisation, NodesMove::AtPoorFaces);
        shape(shares.removal,
          [pass](Shaper& shaper) { return shaper.removeRefused(pass + 1 == RemovalPasses); });
        keepFailing();
      }
    }
    else if (!exact_)
    {
      shape(shares.removal, [](Shaper&) { return Shaping(); }); // for the edits of faces alone
    }
    return sum_;
  }

private:
  template <class Shape>
  void shape(double share, Shape&& shape)
  {
    if (slabs_.empty())
    {
      return;
    }
    execution_.nextLoop(0.02);
    whole_.measure({ slabs_.front().layers.begin, slabs_.back().layers.end }, execution_);
    std::vector<std::unique_ptr<CellComplex>> complexes(slabs_.size());
    std::vector<Shaping> shapings(slabs_.size());
    execution_.nextLoop(share);
    execution_.forEach(slabs_.size(), 1, [&](std::size_t s, std::size_t) {
      Execution alone =
        execution_.alone(double(s) / double(slabs_.size()), double(s + 1) / double(slabs_.size()));
      complexes[s] = std::make_unique<CellComplex>(whole_, slabs_[s]);
      for (const FaceEdit& edit : edits_[s])
      {
        complexes[s]->reform(edit.face, edit.ring);
      }
      Shaper shaper(*complexes[s], task_, exact_, isLast_, alone);
      shapings[s] = shape(shaper);
    });
    sum_ = std::accumulate(shapings.begin(), shapings.end(), sum_);
    fails_.clear();
    std::transform(shapings.begin(), shapings.end(), std::back_inserter(fails_),
      [](const Shaping& shaping) { return shaping.isAnyRefused; });
    writeBack(whole_, complexes, execution_);
    edits_.assign(slabs_.size(), {});
  }

  void optimise(double share, NodesMove move)
  {
    if (slabs_.empty() || !task_.spec.optimiseNodes || exact_)
    {
      return;
    }
    execution_.nextLoop(share);
    Optimised optimised = optimiseNodes(whole_.boxes, whole_.sides, slabs_, task_.featureAngle,
      task_.layers, move, whole_.nodes, whole_.mesh, execution_);
    for (const std::uint32_t cell : optimised.changed)
    {
      whole_.known.atFault[cell] = IsAtFault::Unknown;
    }
    for (const MovedHexahedron& moved : optimised.hexahedra)
    {
      whole_.movedHexahedra[moved.box] = { moved.geometry.centre, moved.geometry.volume };
    }
    const std::vector<Point>& at = whole_.nodes.at;
    std::sort(whole_.nodes.ofCuts.begin(), whole_.nodes.ofCuts.end(),
      [&](std::uint32_t a, std::uint32_t b) { return at[a] < at[b]; });
    edits_ = std::move(optimised.edits);
  }

  // The slabs with failing cells; the others are done.
  void keepFailing()
  {
    std::vector<Slab> failing;
    for (std::size_t s = 0; s < slabs_.size(); ++s)
    {
      if (fails_[s])
      {
        failing.push_back(slabs_[s]);
      }
    }
    slabs_ = std::move(failing);
    edits_.assign(slabs_.size(), {});
  }

  ShapedWall& whole_;
  std::vector<Slab> slabs_; // still to be worked on
  const ShapingTask& task_;
  bool exact_;
  bool isLast_;
  Execution& execution_;
  std::vector<std::vector<FaceEdit>> edits_; // of each slab, to be made
  std::vector<bool> fails_;                  // whether it has failing cells
  Shaping sum_;
};

}

Shaping operator+(Shaping sum, const Shaping& other)
{
  sum.cellsSplit += other.cellsSplit;
  sum.cellsMerged += other.cellsMerged;
  sum.cellsSimplified += other.cellsSimplified;
  sum.refused.insert(sum.refused.end(), other.refused.begin(), other.refused.end());
  return sum;
}

bool shapesCells(const SmallCellSpec& small, const ShapingSpec& spec)
{
  return small.handling == SmallCells::Merge || spec.splitConcave;
}

Shaping shapeCells(const Boxes& boxes, const Patches& patches, Sides& sides, Nodes& nodes,
  WallMesh& mesh, const ShapingTask& task, Execution& execution)
{
  const std::uint32_t all = boxes.allLayers().end;
  ShapedWall whole(boxes, patches, sides, nodes, mesh, task.featureAngle);
  Shaping sum;
  std::size_t stage = 0;
  for (const std::vector<Slab>& slabs : slabsFor(layersOfShapedCells(boxes.core, all), all))
  {
    const Shares& shares = SharesOfStages[stage++];
    sum = sum + Stage(whole, slabs, task, stage == ShapingStages, execution).run(shares);
  }
  return sum;
}

}

#include "CellShaping.h"

#include "CellCarving.h"
#include "CellSplitting.h"
#include "RefusedCells.h"
#include "SmallCells.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// Faces that become one may cut off less than the rest of a cell.
constexpr double LeastVolumeLeft = 0.8;

// Where no pair of faces helps, those that meet at less become one, in degrees.
constexpr std::array<double, 5> WiderAngles{ 30, 45, 60, 90, 180 };

constexpr double RadiansPerDegree = 3.14159265358979 / 180;

// Joins the faces of a cell where that helps; returns whether it did.
bool joinFacesOf(CellComplex& complex, CellKey key, double leastCosine)
{
  CellView view;
  CellShape shape;
  complex.view({ key }, view);
  complex.lookBeyond(key, view);
  measure(view.shape, shape);
  if (isThin(shape))
  {
    return false;
  }
  const Fitness before = fitnessOf(view.shape, shape, view.beyond);
  const JoinedFaces joined = joinFaces(view, shape, leastCosine);
  if (joined.groups.empty())
  {
    return false;
  }
  std::vector<Beyond> beyond;
  const Polyhedron after = shapeOf(view, joined, beyond);
  const double volume = shape.volume;
  measure(after, shape);
  if (after.faces() >= LeastFaces && shape.volume > LeastVolumeLeft * volume &&
    fitnessOf(after, shape, beyond).isBetterThan(before) &&
    !complex.hasFacesNear(key, view, joined))
  {
    complex.open(key);
    complex.join(key, view, joined);
    return true;
  }
  return false;
}

// Where no cut helps: makes a boundary face at fault and one of its neighbours one (the paper's IP
// patches, 4.11). Returns whether it could.
bool mendFace(CellComplex& complex, CellKey key)
{
  CellView view;
  CellShape shape;
  complex.view({ key }, view);
  if (view.faces.size() > MostFacesJoined)
  {
    return false;
  }
  complex.lookBeyond(key, view);
  measure(view.shape, shape);
  const Fitness before = fitnessOf(view.shape, shape, view.beyond);
  Fitness best = before;
  JoinedFaces bestJoined;
  for (std::uint32_t face = 0; face < view.faces.size(); ++face)
  {
    if (!view.shape.isBoundary[face] || view.across[face] != None ||
      !isAtFault(view.shape, shape, face))
    {
      continue;
    }
    for (JoinedFaces& joined : joinFace(view, shape, face))
    {
      std::vector<Beyond> beyond;
      CellShape after;
      const Polyhedron trial = shapeOf(view, joined, beyond);
      measure(trial, after);
      const Fitness fitness = fitnessOf(trial, after, beyond);
      if (trial.faces() >= LeastFaces && after.volume > LeastVolumeLeft * shape.volume &&
        fitness.isBetterThan(best) && !complex.hasFacesNear(key, view, joined))
      {
        best = fitness;
        bestJoined = std::move(joined);
      }
    }
  }
  if (bestJoined.groups.empty())
  {
    return false;
  }
  complex.open(key);
  complex.join(key, view, bestJoined);
  return true;
}

// Those at the boundary below a part of their box: R of their boundary, but not more than `most`.
// Elsewhere they would leave a hole.
void removeSmallCells(CellComplex& complex, const CellSpec& spec, double most)
{
  for (const CellKey key : complex.polyhedra())
  {
    const double share = complex.share(key);
    if (share < most && share < ratioOf(spec, complex.boundaryOfCell(key), spec.smallCellRatio) &&
      complex.isAtBoundary(key))
    {
      complex.remove(key);
    }
  }
}

// Joins faces of a cell at fault where that helps, whatever angle they meet at; returns whether it did.
bool mendFaces(CellComplex& complex, CellKey key)
{
  bool any = false;
  while (mendFace(complex, key))
  {
    any = true;
  }
  for (const double angle : WiderAngles)
  {
    if (complex.isAtFault(key))
    {
      any = joinFacesOf(complex, key, std::cos(angle * RadiansPerDegree)) || any;
    }
  }
  return any;
}

// What is done to the cells of one slab.
class Shaper
{
public:
  Shaper(CellComplex& complex, const CellSpec& spec, bool exact, Execution& execution)
    : complex_(complex)
    , spec_(spec)
    , exact_(exact)
    , execution_(execution)
  {
  }

  Shaping run()
  {
    removeSmall(Sliver);
    merge(false);
    for (int pass = 0; spec_.splitConcave && pass < Passes; ++pass)
    {
      joinFlatFaces();
      split();
      merge(true);
      mend();
    }
    removeSmall(1);
    if (spec_.splitConcave && spec_.refusedCellRatio > 0 && !exact_)
    {
      removeRefused();
    }
    return shaping_;
  }

private:
  // What cannot be merged is small beyond use.
  void removeSmall(double most)
  {
    if (spec_.smallCells == SmallCells::Merge && !exact_)
    {
      removeSmallCells(complex_, spec_, most);
    }
  }

  // The smallest first, as a removal may be enough for the neighbours. What it exposes can be mended;
  // what is too large to go can lose a part.
  void removeRefused()
  {
    RefusedCells refused(complex_, spec_, execution_);
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
  }

  void merge(bool mend)
  {
    if (spec_.smallCells == SmallCells::Merge)
    {
      shaping_.cellsMerged +=
        mergeSmallCells(complex_, spec_.mergeRatio, mend, OnOnePlane, merges_, execution_);
    }
  }

  void joinFlatFaces()
  {
    const double leastCosine = exact_ ? OnOnePlane : std::cos(spec_.joinAngle * RadiansPerDegree);
    for (const CellKey key : complex_.polyhedraAtFault())
    {
      execution_.poll();
      joinFacesOf(complex_, key, leastCosine);
    }
  }

  void split()
  {
    const double least = spec_.smallCells == SmallCells::Remove ? spec_.smallCellRatio : 0;
    shaping_.cellsSplit +=
      splitCells(complex_, complex_.polyhedraAtFault(), least, execution_).cellsSplit;
  }

  void mend()
  {
    for (const CellKey key : exact_ ? std::vector<CellKey>{} : complex_.polyhedraAtFault())
    {
      execution_.poll();
      shaping_.cellsMended += mendFaces(complex_, key) ? complex_.counts(key) : 0;
    }
  }

  // What one pass has left the second mends in part; a third finds hardly anything.
  static constexpr int Passes = 2;
  static constexpr double OnOnePlane = 1;

  // Cells below this part of their box are a wall next to a meshline: merged, they would stick out of
  // their neighbour.
  static constexpr double Sliver = 1e-4;

  static constexpr std::array<double, 4> LargestShares{ 0.025, 0.25, 1, 1 };

  // A carved cell loses no more than this part of its box.
  static constexpr double MostCarved = 0.5;

  CellComplex& complex_;
  const CellSpec& spec_;
  bool exact_;
  Execution& execution_;
  MergesTried merges_;
  Shaping shaping_;
};

}

Shaping& Shaping::operator+=(const Shaping& other)
{
  cellsSplit += other.cellsSplit;
  cellsMerged += other.cellsMerged;
  cellsMended += other.cellsMended;
  partsCarved += other.partsCarved;
  refusedCellsRemoved += other.refusedCellsRemoved;
  return *this;
}

bool shapesCells(const CellSpec& spec)
{
  return spec.smallCells == SmallCells::Merge || spec.splitConcave;
}

Reach reachOf(const CellSpec& spec)
{
  return { spec.collapseRatio > 0, shapesCells(spec) };
}

Shaping shapeCells(const Boxes& boxes, const Patches& patches, Sides& sides, Nodes& nodes,
  const InnerFaces& inner, Cells& cells, const CellSpec& spec, Execution& execution)
{
  const bool exact = isExact(patches);
  const std::uint32_t all = boxes.allLayers().end;
  const auto stages = slabsFor(boxes.core.grown(HaloOfShapedCells, all), all);
  CellsToShape whole(boxes, patches, sides, nodes, inner, cells);
  Shaping sum;
  for (std::size_t stage = 0; stage < stages.size(); ++stage)
  {
    const std::vector<Slab>& slabs = stages[stage];
    if (slabs.empty())
    {
      continue;
    }
    const double left = static_cast<double>(stages.size() - stage);
    execution.nextLoop(0.02);
    whole.measure({ slabs.front().layers.begin, slabs.back().layers.end }, execution);
    std::vector<std::unique_ptr<CellComplex>> complexes(slabs.size());
    std::vector<Shaping> shapings(slabs.size());
    execution.nextLoop(0.9 / left);
    execution.forEach(slabs.size(), 1, [&](std::size_t s, std::size_t) {
      Execution alone = execution.alone();
      complexes[s] = std::make_unique<CellComplex>(whole, slabs[s]);
      shapings[s] = Shaper(*complexes[s], spec, exact, alone).run();
    });
    for (const Shaping& shaping : shapings)
    {
      sum += shaping;
    }
    writeBack(whole, complexes, execution);
  }
  return sum;
}

}

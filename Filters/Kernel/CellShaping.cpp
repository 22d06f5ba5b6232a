#include "CellShaping.h"

#include "CellSplitting.h"
#include "SmallCells.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 512;
// Faces that become one may cut off less than the rest of a cell.
constexpr double LeastVolumeLeft = 0.8;

constexpr double RadiansPerDegree = 3.14159265358979 / 180;

// Those of the cells, in order, that are at fault.
std::vector<CellKey> cellsAtFault(
  const CellComplex& complex, const std::vector<CellKey>& keys, Execution& execution)
{
  std::vector<std::vector<CellKey>> parts(chunks(keys.size(), CellsAChunk));
  execution.forEach(keys.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      if (complex.isAtFault(keys[i]))
      {
        parts[begin / CellsAChunk].push_back(keys[i]);
      }
    }
  });
  std::vector<CellKey> all;
  for (const auto& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

// Whether a face that several would make is there already.
bool meetsFace(const CellComplex& complex, CellKey key, const CellView& view, const JoinedFaces& joined)
{
  return std::any_of(
    joined.groups.begin(), joined.groups.end(), [&](const JoinedFaces::Group& group) {
      std::vector<std::uint32_t> nodes;
      for (const std::uint32_t node : group.ring)
      {
        nodes.push_back(view.nodes[node]);
      }
      return group.members.size() > 1 && complex.hasFaceNear(key, std::move(nodes));
    });
}

// Joins the faces of a cell where that helps.
void joinFacesOf(CellComplex& complex, CellKey key, double leastCosine)
{
  CellView view;
  CellShape shape;
  complex.view({ key }, view);
  complex.lookBeyond(key, view);
  measure(view.shape, shape);
  if (isThin(shape))
  {
    return;
  }
  const Fitness before = fitnessOf(view.shape, shape, view.beyond);
  const JoinedFaces joined = joinFaces(view, leastCosine);
  std::vector<Beyond> beyond;
  const Polyhedron after = shapeOf(view, joined, beyond);
  measure(after, shape);
  if (fitnessOf(after, shape, beyond).isBetterThan(before) &&
    !meetsFace(complex, key, view, joined))
  {
    complex.open(key);
    complex.join(key, view, joined);
  }
}

// Where no cut helps: makes a boundary face at fault and one of its neighbours one (the paper's IP
// patches, 4.11). Returns whether it could.
bool mendFace(CellComplex& complex, CellKey key)
{
  CellView view;
  CellShape shape;
  complex.view({ key }, view);
  complex.lookBeyond(key, view);
  measure(view.shape, shape);
  const Fitness before = fitnessOf(view.shape, shape, view.beyond);
  Fitness best = before;
  JoinedFaces bestJoined;
  for (std::uint32_t face = 0; face < view.faces.size(); ++face)
  {
    if (!view.shape.isBoundary[face] || view.across[face] != None || !isAtFault(view.shape, shape, face))
    {
      continue;
    }
    for (JoinedFaces& joined : joinFace(view, face))
    {
      std::vector<Beyond> beyond;
      CellShape after;
      const Polyhedron trial = shapeOf(view, joined, beyond);
      measure(trial, after);
      const Fitness fitness = fitnessOf(trial, after, beyond);
      if (after.volume > LeastVolumeLeft * shape.volume && fitness.isBetterThan(best) &&
        !meetsFace(complex, key, view, joined))
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

// What could not be merged and is small beyond use.
std::size_t removeSmallCells(CellComplex& complex, const CellSpec& spec)
{
  std::size_t removed = 0;
  for (const CellKey key : complex.polyhedra())
  {
    const double ratio = ratioOf(spec, complex.boundaryOfCell(key));
    if (complex.volume(key) < ratio * complex.volumeOfBox(key))
    {
      complex.remove(key);
      ++removed;
    }
  }
  return removed;
}

}

bool shapesCells(const CellSpec& spec)
{
  return spec.smallCells == SmallCells::Merge || spec.splitConcave;
}

Shaping shapeCells(const Boxes& boxes, const Patches& patches, Sides& sides, Nodes& nodes,
  const InnerFaces& inner, Cells& cells, const CellSpec& spec, Execution& execution)
{
  Shaping shaping;
  execution.nextLoop(0.02);
  CellComplex complex(boxes, patches, sides, nodes, inner, cells, execution);
  const bool exact = isExact(patches);
  const double leastCosine = exact ? 1 : std::cos(spec.joinAngle * RadiansPerDegree);
  const auto merge = [&](bool mend) {
    if (spec.smallCells == SmallCells::Merge)
    {
      shaping.cellsMerged += mergeSmallCells(complex, spec.mergeRatio, mend, 1, execution);
    }
  };
  merge(false);
  if (spec.splitConcave)
  {
    const std::vector<CellKey> atFault = cellsAtFault(complex, complex.polyhedra(), execution);
    for (const CellKey key : atFault)
    {
      execution.poll();
      joinFacesOf(complex, key, leastCosine);
    }
    const Splitting splitting = splitCells(complex, cellsAtFault(complex, atFault, execution),
      spec.smallCells == SmallCells::Remove ? spec.smallCellRatio : 0, execution);
    shaping.cellsSplit = splitting.cellsSplit;
    merge(true);
    if (!exact)
    {
      for (const CellKey key : cellsAtFault(complex, complex.polyhedra(), execution))
      {
        execution.poll();
        while (mendFace(complex, key))
        {
        }
      }
    }
  }
  if (spec.smallCells == SmallCells::Merge && !exact)
  {
    shaping.cellsRemoved = removeSmallCells(complex, spec);
  }
  if (complex.changed())
  {
    complex.finish(execution);
  }
  return shaping;
}

}

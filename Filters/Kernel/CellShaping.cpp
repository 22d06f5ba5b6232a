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
constexpr double RadiansPerDegree = 3.14159265358979 / 180;

std::vector<CellKey> failingCells(const CellComplex& complex, Execution& execution)
{
  const std::vector<CellKey> keys = complex.polyhedra();
  std::vector<std::vector<CellKey>> parts(chunks(keys.size(), CellsAChunk));
  execution.forEach(keys.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    Polyhedron polyhedron;
    CellShape shape;
    for (std::size_t i = begin; i < end; ++i)
    {
      complex.shape(keys[i], polyhedron);
      measure(polyhedron, shape);
      if (failingArea(polyhedron, shape) > 0)
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

}

Shaping shapeCells(const Boxes& boxes, const Patches& patches, Sides& sides, Nodes& nodes,
  const InnerFaces& inner, Cells& cells, const CellSpec& spec, Execution& execution)
{
  Shaping shaping;
  CellComplex complex(boxes, patches, sides, nodes, inner, cells);
  const auto merge = [&] {
    if (spec.smallCells == SmallCells::Merge)
    {
      shaping.cellsMerged += mergeSmallCells(
        complex, spec.mergeRatio, std::cos(spec.joinAngle * RadiansPerDegree), execution);
    }
  };
  merge();
  if (spec.splitConcave)
  {
    const Splitting splitting = splitCells(complex, failingCells(complex, execution), execution);
    shaping.cellsSplit = splitting.cellsSplit;
    merge();
  }
  shaping.angleFailures = failingCells(complex, execution).size();
  if (complex.changed())
  {
    complex.finish(execution);
  }
  return shaping;
}

}

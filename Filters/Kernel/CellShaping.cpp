#include "CellShaping.h"

#include "CellSplitting.h"
#include "SmallCells.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 512;

std::vector<CellKey> failingCells(
  const CellComplex& complex, const Cells& cells, Execution& execution)
{
  std::vector<std::vector<CellKey>> parts(chunks(cells.size(), CellsAChunk));
  execution.forEach(cells.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    Polyhedron polyhedron;
    CellShape shape;
    for (std::size_t c = begin; c < end; ++c)
    {
      const auto key = static_cast<CellKey>(c);
      if (cells.cells[c].removed)
      {
        continue;
      }
      complex.shape(key, polyhedron);
      measure(polyhedron, shape);
      if (failingArea(polyhedron, shape) > 0)
      {
        parts[begin / CellsAChunk].push_back(key);
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
  if (spec.splitConcave)
  {
    const Splitting splitting =
      splitCells(complex, failingCells(complex, cells, execution), execution);
    shaping.cellsSplit = splitting.cellsSplit;
    shaping.angleFailures = splitting.failed.size();
  }
  if (spec.smallCells == SmallCells::Merge)
  {
    shaping.cellsMerged = mergeSmallCells(complex, spec.mergeRatio, execution);
  }
  if (complex.changed())
  {
    complex.finish(execution);
  }
  return shaping;
}

}

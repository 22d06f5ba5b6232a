// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/CellsLeftOut.h"

#include <numeric>

namespace cartesian
{

namespace
{

double volumeOf(const Box& box)
{
  const Vector size = minus(box.high, box.low);
  return size[0] * size[1] * size[2];
}

// Of the core, in levels.
double volumeOfMesh(const Assembly& a)
{
  double volume = 0;
  for (std::uint32_t box = 0; box < a.boxes.packed.size(); ++box)
  {
    const bool isHexahedron = a.sides.polyhedralOrdinal(box) == None;
    volume += isHexahedron && a.boxes.isCore(a.boxes.packed[box]) ? volumeOf(a.boxes.box(box)) : 0;
  }
  for (std::size_t c = 0; c < a.cells.size(); ++c)
  {
    const Cell& cell = a.cells.all[c];
    if (!cell.removed && a.boxes.isCore(a.boxes.packed[cell.box]))
    {
      volume += cell.volumeFraction * volumeOf(a.boxes.box(cell.box));
    }
  }
  return volume;
}

double levelsLeftOut(const Assembly& a)
{
  const std::vector<CellLeftOut> cells = cellsLeftOut(a);
  return std::accumulate(cells.begin(), cells.end(), 0.0,
    [](double sum, const CellLeftOut& cell) { return sum + cell.volume; });
}

}

std::vector<CellLeftOut> cellsLeftOut(const Assembly& a)
{
  std::vector<CellLeftOut> cells;
  for (std::size_t c = 0; c < a.cells.size(); ++c)
  {
    const Cell& cell = a.cells.all[c];
    if (cell.removed && !cell.sliver && a.boxes.isCore(a.boxes.packed[cell.box]))
    {
      cells.push_back(
        { cell.box, cell.boundary, cell.volumeFraction * volumeOf(a.boxes.box(cell.box)) });
    }
  }
  return cells;
}

double volumeLeftOut(const Assembly& a)
{
  const double step = a.boxes.lattice.step();
  return levelsLeftOut(a) * step * step * step;
}

double shareLeftOut(const Assembly& a)
{
  const double lost = levelsLeftOut(a);
  return lost > 0 ? lost / (lost + volumeOfMesh(a)) : 0;
}

}

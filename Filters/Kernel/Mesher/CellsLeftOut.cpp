// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/CellsLeftOut.h"

#include "Mesher/Statistics.h"

#include <algorithm>
#include <numeric>

namespace cartesian
{

std::vector<CellLeftOut> cellsLeftOut(const Assembly& a)
{
  std::vector<CellLeftOut> cells;
  for (std::size_t c = 0; c < a.wall.size(); ++c)
  {
    const Cell& cell = a.wall.cells[c];
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
  const std::vector<CellLeftOut> cells = cellsLeftOut(a);
  return std::accumulate(cells.begin(), cells.end(), 0.0,
    [&](double sum, const CellLeftOut& cell) { return sum + cell.volume * step * step * step; });
}

double shareLeftOut(const Assembly& a)
{
  const double lost = volumeLeftOut(a);
  return lost > 0 ? lost / std::accumulate(a.regionVolumes.begin(), a.regionVolumes.end(), lost)
                  : 0;
}

LeftOutAtRims leftOutAtRims(const Assembly& a)
{
  LeftOutAtRims all;
  double most = 0;
  for (const RemovedCell& cell : a.edits.removed)
  {
    if (cell.reason != RemovalReason::Rim)
    {
      continue;
    }
    const double boxes = cell.volume / volumeOf(a.boxes.box(cell.box));
    all.largest = boxes > most ? cell.box : all.largest;
    most = std::max(most, boxes);
    all.boxes += boxes;
    ++all.pieces;
  }
  return all;
}

}

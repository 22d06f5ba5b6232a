// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/Statistics.h"

#include "Mesher/CellsLeftOut.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace cartesian
{

namespace
{

struct Counts
{
  double cells = 0;
  double hexahedra = 0;
  double polyhedra = 0;
  double points = 0;
  double boundaryFaces = 0;
  double boxesInside = 0;
  double boxesIntersected = 0;
  double byMarchingCubes = 0;
  double byExactFit = 0;
  double boxesRebuilt = 0;
  double boxesFlawed = 0;
  double patches = 0;
  double cellsSplit = 0;
  double cellsWithJoinedFaces = 0;
  double smallCellsMerged = 0;
  double smallCellsRemoved = 0;
  double refusedCellsRemoved = 0;
  double volumeLeftOut = 0;
  double surfaceVolume = 0;
  double meshVolume = 0;
  double fragmentCellsRemoved = 0;
  double partsLeftOut = 0;
  double isolatedCells = 0;
  double sizesRelaxed = 0;
  double voids = 0;
  double folds = 0;
  double boundaryAngle = 0;
  double innerAngle = 0;
  double openness = 0;
  double volume = 0;
};

struct Row
{
  const char* name;
  const char* meaning;
  double Counts::*count;
};

constexpr std::array<Row, 30> Table{ {
  { "Cells", "cells of the mesh", &Counts::cells },
  { "Hexahedra", "cells that are whole boxes without hanging nodes", &Counts::hexahedra },
  { "Polyhedra", "all other cells", &Counts::polyhedra },
  { "Points", "points of the mesh", &Counts::points },
  { "BoundaryFaces", "faces that belong to only one cell", &Counts::boundaryFaces },
  { "BoxesInside", "boxes that the surface does not pass through", &Counts::boxesInside },
  { "BoxesIntersected", "boxes that it passes through", &Counts::boxesIntersected },
  { "BoxesByMarchingCubes", "... with patches by Marching Cubes", &Counts::byMarchingCubes },
  { "BoxesByExactFit", "... with patches by Exact Fit", &Counts::byExactFit },
  { "BoxesRebuilt",
    "boxes whose patches were made from corner statuses, as the surface is open there",
    &Counts::boxesRebuilt },
  { "BoxesFlawed", "boxes left out, as they are open even so", &Counts::boxesFlawed },
  { "Patches", "faces of boxes on the surface, before cells are shaped", &Counts::patches },
  { "CellsSplit", "cuts through concave cells", &Counts::cellsSplit },
  { "CellsWithJoinedFaces", "cells with failing faces joined, at any angle (IP patches)",
    &Counts::cellsWithJoinedFaces },
  { "SmallCellsMerged", "small cells merged into a neighbour", &Counts::smallCellsMerged },
  { "SmallCellsRemoved", "small cells that were left out", &Counts::smallCellsRemoved },
  { "RefusedCellsRemoved", "failing cells left out", &Counts::refusedCellsRemoved },
  { "FragmentCellsRemoved", "cells left out, as the grid cuts them off from the rest",
    &Counts::fragmentCellsRemoved },
  { "VolumeLeftOut", "volume of the cells that were left out, in user units cubed",
    &Counts::volumeLeftOut },
  { "SurfaceVolume", "what the surface encloses of the domain, in user units cubed; 0: not known",
    &Counts::surfaceVolume },
  { "MeshVolume", "what its cells hold without layers of prisms, in user units cubed",
    &Counts::meshVolume },
  { "PartsLeftOut", "connected parts of the domain without a Keep Point, left out",
    &Counts::partsLeftOut },
  { "IsolatedCells", "cells in parts of at most 16 that no face connects with the rest",
    &Counts::isolatedCells },
  { "SizesRelaxed", "fraction by which requested sizes were enlarged for the Cell Budget",
    &Counts::sizesRelaxed },
  { "VoidsInsideCells", "closed pieces of surface inside one cell, which become voids in it",
    &Counts::voids },
  { "FoldsLeftOut", "walls without thickness inside one cell, left out", &Counts::folds },
  { "BoundaryAngleFailures", "cells that fail the angle condition of boundary faces (section 3)",
    &Counts::boundaryAngle },
  { "InnerAngleFailures", "cells that fail the angle condition of inner faces",
    &Counts::innerAngle },
  { "OpennessFailures", "cells that do not close", &Counts::openness },
  { "VolumeFailures", "cells without a positive volume", &Counts::volume },
} };

// Of the boxes of the core.
class Counter
{
public:
  explicit Counter(const Assembly& assembly)
    : a_(assembly)
    , first_(a_.boxes.firstBoxOf(a_.boxes.core.begin))
    , last_(a_.boxes.firstBoxOf(a_.boxes.core.end))
  {
  }

  Counts count()
  {
    countBoxes();
    countCells();
    countChanges();
    n_.points = static_cast<double>(a_.mesh->ownPointCount());
    n_.boundaryFaces = static_cast<double>(a_.mesh->boundary().size());
    n_.boundaryAngle = static_cast<double>(a_.mesh->failures().boundaryAngle);
    n_.innerAngle = static_cast<double>(a_.mesh->failures().innerAngle);
    countLayers();
    n_.openness = static_cast<double>(a_.mesh->failures().open);
    n_.volume = static_cast<double>(a_.mesh->failures().negativeVolume);
    return n_;
  }

private:
  void countLayers()
  {
    if (a_.layers)
    {
      const PrismStacks& stacks = a_.layers->stacks;
      n_.cells += static_cast<double>(stacks.cells());
      n_.polyhedra += static_cast<double>(stacks.cells());
      n_.points += static_cast<double>(stacks.nodeOfPoint.size());
      n_.boundaryFaces = static_cast<double>(a_.layers->boundary.faces.size());
    }
  }

  bool isCore(std::uint32_t box) const { return box >= first_ && box < last_; }

  void countBoxes()
  {
    double polyhedral = 0;
    for (std::size_t n = 0; n < a_.sides.polyhedral.size(); ++n)
    {
      if (!isCore(a_.sides.polyhedral[n]))
      {
        continue;
      }
      ++polyhedral;
      if (const std::uint32_t box = a_.sides.patchBox[n]; box != None)
      {
        ++n_.boxesIntersected;
        n_.byMarchingCubes += a_.patches.reason[box] == PatchReason::MarchingCubes;
        n_.patches += static_cast<double>(a_.patches.boxStart[box + 1] - a_.patches.boxStart[box]);
      }
    }
    const double boxes = last_ - first_;
    n_.hexahedra = boxes - polyhedral;
    n_.boxesInside = boxes - n_.boxesIntersected;
    n_.byExactFit = n_.boxesIntersected - n_.byMarchingCubes;
    n_.boxesRebuilt = static_cast<double>(rebuiltBoxes(a_).size());
    n_.boxesFlawed = static_cast<double>(flawedBoxes(a_).size());
  }

  // What was removed for whatever reason before edits, or after them, is marked: countRemovals() separates it.
  void countCells()
  {
    const WallMesh& wall = a_.wall;
    n_.cells = static_cast<double>(a_.mesh->cellCount());
    n_.polyhedra = n_.cells - n_.hexahedra;
    for (std::size_t c = 0; c < wall.size(); ++c)
    {
      const Cell& cell = wall.cells[c];
      if (!isCore(cell.box))
      {
        continue;
      }
      n_.smallCellsRemoved += cell.removed;
    }
    n_.voids = static_cast<double>(wall.voids);
    n_.folds = static_cast<double>(wall.folds);
  }

  void countChanges()
  {
    n_.cellsSplit = static_cast<double>(a_.edits.split);
    n_.cellsWithJoinedFaces = static_cast<double>(a_.edits.simplified);
    n_.smallCellsMerged = static_cast<double>(a_.edits.merged);
    countRemovals();
    n_.volumeLeftOut = volumeLeftOut(a_);
    n_.surfaceVolume = a_.patches.surfaceVolume;
    n_.meshVolume = std::accumulate(a_.regionVolumes.begin(), a_.regionVolumes.end(), 0.0);
    n_.sizesRelaxed = a_.relaxation - 1;
    n_.partsLeftOut = static_cast<double>(a_.separate.leftOut);
    n_.isolatedCells = static_cast<double>(a_.separate.isolatedCells);
  }

  // Each reason for itself; pieces at rims count as refused.
  void countRemovals()
  {
    const auto count = [&](RemovalReason reason) {
      return static_cast<double>(countRemoved(a_, reason));
    };
    n_.refusedCellsRemoved = count(RemovalReason::Refused) + count(RemovalReason::Rim);
    n_.fragmentCellsRemoved = count(RemovalReason::Fragment);
    n_.smallCellsRemoved += count(RemovalReason::Small) -
      static_cast<double>(a_.edits.overlapping.size() + a_.separate.fragments.size());
  }

  const Assembly& a_;
  const std::uint32_t first_;
  const std::uint32_t last_;
  Counts n_;
};

}

std::vector<Statistic> statistics(const Assembly& assembly)
{
  const Counts counts = Counter(assembly).count();
  std::vector<Statistic> result;
  result.reserve(Table.size());
  for (const Row& row : Table)
  {
    result.push_back({ row.name, row.meaning, counts.*row.count });
  }
  return result;
}

}

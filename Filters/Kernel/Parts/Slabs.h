// SPDX-License-Identifier: BSD-3-Clause
// Slabs: layers of global boxes whose cells change by themselves.
//
// Shaping (CellShaping.h) goes from cell to neighbour, as far as it likes. In slabs it ends somewhere:
// the layer next to another slab is looked at, but nothing in it changes. Cells there have their turn
// in a second stage, in slabs that lie across the borders of the first. Borders are the grid's, so
// that they are the same for any number of threads and for all parts of a mesh (Decomposition.h); slabs of
// one stage depend on no other.
//
//   layer              0 1 2 3 4 5 6 7 8 9 10 ...
//   first stage        A A A A A A A A f - |  - f A A A A A A f - | ...
//   second stage                   - A A A |  A A A -                     A acts, f free, - fixed
//
// Between 3 and 6 nothing changes in the second stage: there a mesh is divided at least cost.
#pragma once

#include "Boxes/Boxes.h"

namespace cartesian
{

// In layers, of the first stage. Thinner slabs need less around a part, and give more threads work.
constexpr std::uint32_t SlabThickness = 10;

constexpr std::size_t ShapingStages = 2;

// No cell grows beyond so many layers by merging: a part sees one layer of what may reach into it.
constexpr std::uint32_t MostLayersOfACell = 2;

// The cells of one layer beyond tell which points of a part's are used, and which of its faces lost
// their neighbour; where cells may reach into the next layer, those of two do.
constexpr std::uint32_t HaloOfCells = 1;
constexpr std::uint32_t HaloOfShapedCells = HaloOfCells + MostLayersOfACell - 1;

struct Slab
{
  Layers layers; // all that it looks at
  Layers free;   // cells that lie in these may change
  Layers acting; // cells of these are looked for faults
};

// The slabs of each stage that the shaped cells of these layers depend on.
std::array<std::vector<Slab>, ShapingStages> slabsFor(Layers wanted, std::uint32_t allLayers);

// The layers whose cells must be right before they are shaped for those of `wanted` to be right after.
Layers layersForShaping(Layers wanted, std::uint32_t allLayers);

// Where a grid is divided at least cost.
constexpr std::uint32_t FirstDivide = SlabThickness / 2;
constexpr std::uint32_t DivideDistance = SlabThickness;

// Short edges (ShortEdges.h) collapse from one seam, a plane between layers, to the next, and then
// across seams. Here their slabs fit those of parts that are divided so; a grid of a single slab has no
// seam.
constexpr std::uint32_t FirstSeam = 2;
constexpr std::uint32_t SeamDistance = SlabThickness / 2;

inline bool isSeam(std::uint32_t plane, std::uint32_t allLayers)
{
  return allLayers > SlabThickness && plane % SeamDistance == FirstSeam;
}

// The layers that those of `wanted` depend on: as they were before edges collapsed.
Layers layersForCollapse(Layers wanted, std::uint32_t allLayers);

// What is done to cells, as far as cells depend on others.
struct LaterSteps
{
  bool collapses = false; // short edges
  bool shapes = false;
};

// The layers whose cells must be right, as the grid cuts them, for those of `core` to be so in the end.
Layers layersForCells(Layers core, const LaterSteps& laterSteps, std::uint32_t allLayers);

}

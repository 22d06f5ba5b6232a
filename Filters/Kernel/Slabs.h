// Slabs: layers of global boxes whose cells are shaped by themselves.
//
// Shaping (CellShaping.h) goes from cell to neighbour, as far as it likes. In slabs it ends somewhere:
// the layer next to another slab is looked at, but nothing in it changes. Cells there have their turn
// in a second stage, in slabs that lie across the borders of the first. Borders are the grid's, so
// that they are the same for any number of threads and for all parts of a mesh (Division.h); slabs of
// one stage depend on no other.
//
//   layer            0 1 2 3 4 5 6 7 8 9 ...
//   first stage      A A A A A A f - | - f A A A A f - | ...
//   second stage             - f A A | A A f -                A acts, f free, - fixed
#pragma once

#include "Boxes.h"

namespace cartesian
{

// In layers; even a multiple of 4. Thinner slabs need less around a part, and give more threads work.
constexpr std::uint32_t SlabThickness = 8;

constexpr std::size_t ShapingStages = 2;

struct Slab
{
  Layers layers; // all that it looks at
  Layers free;   // cells that lie in these may change
  Layers acting; // cells of these are looked for faults: all their neighbours are free
};

// The slabs of each stage that the shaped cells of these layers depend on.
std::array<std::vector<Slab>, ShapingStages> slabsFor(Layers wanted, std::uint32_t allLayers);

// The layers whose cells must be right before they are shaped for those of `wanted` to be right after.
Layers shapedFrom(Layers wanted, std::uint32_t allLayers);

// Where a grid is divided at least cost: the layer at or next to `layer` that fewest others are shaped
// with.
std::uint32_t nearestSeam(std::uint32_t layer, std::uint32_t allLayers);

}

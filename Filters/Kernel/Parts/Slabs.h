// SPDX-License-Identifier: BSD-3-Clause
// Slabs: ranges of layers of global boxes whose cells can be changed independently.
//
// Shaping (CellShaping.h) can propagate from cell to cell without bound. Slabs bound it: a slab
// sees the layer next to another slab, but changes nothing in it. Cells there have their turn in a
// second stage, in slabs across the borders of the first. The borders are fixed in the grid, so
// that they are the same for any number of threads and for all parts of a mesh (Decomposition.h);
// the slabs of one stage are independent of each other.
//
//   layer              0 1 2 3 4 5 6 7 8 9 10 ...
//   first stage        A A A A A A A A f - |  - f A A A A A A f - | ...
//   second stage                   - A A A |  A A A -                     A acts, f free, - fixed
//
// Nothing changes in layers 3 to 6 in the second stage: it costs least to divide a mesh there.
#pragma once

#include "Boxes/Boxes.h"

namespace cartesian
{

// Of the first stage, in layers. Thinner slabs need a smaller halo and keep more threads busy.
constexpr std::uint32_t SlabThickness = 10;

constexpr std::size_t ShapingStages = 2;

// No cell extends over more layers after merging, so that a part has to see only one layer of cells
// that may extend into it.
constexpr std::uint32_t MostLayersOfACell = 2;

// Whether a cell over these layers is partly in those that the second stage may change: it would be fixed beside what
// the second stage removes, and is better avoided.
bool straddlesStages(Layers layers, std::uint32_t allLayers);

// The cells of one more layer tell which of a part's points are used, and which of its faces have
// lost their neighbour. If cells may extend into the next layer, this takes two.
constexpr std::uint32_t HaloOfCells = 1;
constexpr std::uint32_t HaloOfShapedCells = HaloOfCells + MostLayersOfACell - 1;

// A small isolated part of the mesh (Cells/Fragments.h) can only be removed if all parts of a grid that may see it
// know its neighbours: it extends over at most this many layers, and into none beside a plane where it costs least to
// divide the grid.
constexpr std::uint32_t MostLayersOfAFragment = 3;
bool isBesideDivide(std::uint32_t layer, std::uint32_t allLayers);

// The layers whose shaped cells must be correct, for those of the core and their points to be.
Layers layersOfShapedCells(Layers core, std::uint32_t allLayers);

struct Slab
{
  Layers layers; // that it sees
  Layers free;   // whose cells may change
  Layers acting; // whose cells are checked for faults
  Layers moving; // within which nodes may move
};

// The slabs of each stage on which the shaped cells of these layers depend.
std::array<std::vector<Slab>, ShapingStages> slabsFor(Layers wanted, std::uint32_t allLayers);

// Of what there is so much of in each layer, how much the slabs of the first stage hold at most that as many threads
// shape at once: the fullest.
double mostAtOnce(const std::vector<double>& ofLayers, Layers layers, int threads);

// The same, as a share of all, if each layer has as much.
double shareAtOnce(double layers, int threads);

// The layers whose cells must be correct before shaping, for those of `wanted` to be correct
// afterwards.
Layers layersForShaping(Layers wanted, std::uint32_t allLayers);

// Where it costs least to divide a grid.
constexpr std::uint32_t FirstDivide = SlabThickness / 2;
constexpr std::uint32_t DivideDistance = SlabThickness;

// Short edges (EdgeCollapse.h) are collapsed between seams (planes between layers) first, then across
// seams. Seams are placed so that they fit parts which are divided at least cost; a grid of a
// single slab has none.
constexpr std::uint32_t FirstSeam = 2;
constexpr std::uint32_t SeamDistance = SlabThickness / 2;

inline bool isSeam(std::uint32_t plane, std::uint32_t allLayers)
{
  return allLayers > SlabThickness && plane % SeamDistance == FirstSeam;
}

// The layers whose cells must be correct before short edges collapse, for those of `wanted` to be
// correct afterwards.
Layers layersForCollapse(Layers wanted, std::uint32_t allLayers);

// The steps to come after cells are cut in which cells depend on their neighbours.
struct LaterSteps
{
  bool collapses = false;    // short edges are collapsed
  bool standsOff = false;    // nodes move off the surface (StandOff.h)
  bool shapes = false;       // cells are shaped
  bool editsInPlace = false; // each part has the whole wall edited
};

// Once edges have collapsed, patches reach half a box beyond their box, so that nodes of one patch are up to two layers
// apart. How far a node moves off the surface depends on the boxes around it (1), on its neighbours' way (2), and on
// whether a patch around it would bend (2); cells have nodes of the next layer (1).
constexpr std::uint32_t HaloOfStandOff = 6;

// The layers whose cells must be cut correctly, for those of `core` to be correct in the end.
Layers layersForCells(Layers core, const LaterSteps& steps, std::uint32_t allLayers);

}

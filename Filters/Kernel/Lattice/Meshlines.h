// SPDX-License-Identifier: BSD-3-Clause
// The user's meshlines: the cutting planes of the global mesh (section 4, steps 1 and 3).
#pragma once

#include "Base/Range.h"
#include "Lattice/Lattice.h"

#include <vector>

namespace cartesian
{

// What the user asks for, in user units.
struct GridSpec
{
  static constexpr Range CellSizes{ 0 }; // user units

  double cellSize = 0; // of boxes in directions without meshlines; 0: longest dimension / 50
  std::array<std::vector<double>, 3> meshlines; // strictly increasing, at least two, or none
};

constexpr double DefaultCellsAlongLongest = 50;

// Even levels of the planes along x, y and z, strictly increasing, at least two a direction.
using Meshlines = std::array<std::vector<Level>, 3>;

// Both the surface's bounds and the meshlines: what the lattice must hold.
// Throws Error: BadCellSize, BadMeshlines.
Bounds domainOf(const GridSpec& spec, const Bounds& surface);

// Cells of uniform size start at the surface's lower bounds; the first and the last plane step
// aside by a level where they would touch the surface.
// Throws Error: BadCellSize, BadMeshlines (away from the surface, closer than the lattice).
Meshlines onLattice(const GridSpec& spec, const Bounds& surface, const Lattice& lattice);

// Refuses a grid whose rows alone would take more bytes than `mostBytes`, before it is built.
// Throws Error: TooManyBoxes, with the number of boxes.
void checkGrid(const GridSpec& spec, const Bounds& surface, double mostBytes);

// The interval [lines[i], lines[i + 1]) that holds `level`: -1 below the first line,
// lines.size() - 1 from the last line on.
std::int64_t intervalOf(const std::vector<Level>& lines, Level level);

// The distance of the two lines around `level`, in levels; beyond the ends, of the nearest two.
double spacing(const std::vector<Level>& lines, double level);

}

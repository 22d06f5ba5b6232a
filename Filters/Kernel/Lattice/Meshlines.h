// SPDX-License-Identifier: BSD-3-Clause
// Meshlines: the cutting planes of the global mesh (section 4, steps 1 and 3).
#pragma once

#include "Base/Range.h"
#include "Lattice/Lattice.h"

#include <vector>

namespace cartesian
{

// The user's specification, in user units.
struct GridSpec
{
  static constexpr Range CellSizes{ 0 }; // user units

  // Of boxes in directions without meshlines; 0: the surface's longest dimension / 50.
  double cellSize = 0;
  std::array<std::vector<double>, 3> meshlines; // strictly increasing, at least two, or none
};

constexpr double DefaultCellsAlongLongest = 50;

// A plane that divides boxes, where it does not lie at an even part of the way between two meshlines.
struct MovedPlane
{
  std::int64_t fine; // in the smallest parts of boxes, from the first meshline (Boxes.h)
  Level level;
};

// Planes between meshlines are at least as fine, so that the patches of shallow grids do not depend on the depth.
constexpr int LeastPlaneLevel = 6;

// Even levels of the planes along x, y and z: strictly increasing, at least two in each direction.
struct Meshlines
{
  std::array<std::vector<Level>, 3> lines;
  std::array<std::vector<MovedPlane>, 3> moved = {}; // in order (PlanePerturbation.h)

  // Of the planes that may divide boxes: how often they halve the space between meshlines.
  int planeLevel = LeastPlaneLevel;

  std::int64_t partsPerBox() const { return std::int64_t(1) << planeLevel; }

  const std::vector<Level>& operator[](std::size_t axis) const { return lines[axis]; }
  std::vector<Level>& operator[](std::size_t axis) { return lines[axis]; }
  auto begin() const { return lines.begin(); }
  auto end() const { return lines.end(); }
  auto begin() { return lines.begin(); }
  auto end() { return lines.end(); }
};

// The bounds of the surface and the meshlines together: what the lattice must hold.
// Throws Error: BadCellSize, BadMeshlines.
Bounds domainOf(const GridSpec& spec, const Bounds& surface);

// The grid that ends where the box does: where it has no meshlines, its cells are as large as fit evenly, at
// most its cell size. Throws Error: BadCellSize, TooManyBoxes.
GridSpec fittedTo(const Bounds& box, const GridSpec& spec);

// Cells of uniform size start at the lower bounds of the surface; the first and the last plane are
// moved outward by a level if they would touch the surface. Throws Error: BadCellSize, BadMeshlines
// (they miss the surface, or are closer than the lattice resolves).
Meshlines onLattice(const GridSpec& spec, const Bounds& surface, const Lattice& lattice);

// Throws Error: TooManyBoxes, with the number of boxes, if the rows of the grid alone would take
// more than `mostBytes`.
void checkGrid(const GridSpec& spec, const Bounds& surface, double mostBytes);

// The i for which [lines[i], lines[i + 1]) contains `level`: -1 below the first line, lines.size()
// - 1 from the last one on.
std::int64_t intervalOf(const std::vector<Level>& lines, Level level);

// The distance between the two lines around `level`, in levels; outside, between the nearest two.
double spacing(const std::vector<Level>& lines, double level);

// The narrowest side of the box there, in levels.
double narrowestSide(const Meshlines& planes, const std::array<double, 3>& at);

}

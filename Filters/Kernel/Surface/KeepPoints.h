// SPDX-License-Identifier: BSD-3-Clause
// Points that select the connected parts of the domain to mesh, or must not be in one of these.
#pragma once

#include "Lattice/Meshlines.h"
#include "Surface/Surface.h"

namespace cartesian
{

struct KeepPoint
{
  Point at;         // even levels; the surface does not come within two levels above them
  Winding winding;  // of the surface around it
  std::string name; // with its place, for messages
  std::array<double, 3> place; // as it was given, user units
  bool isBeyond = false;       // the planes; `at` and `winding` say nothing
};

// Places in user units on the lattice, each where a vertex of the surface would be, but a level lower. Throws
// Error: BadCoordinate; BadParameter: a place that lies beyond the planes, or on the surface, as exactly as the
// lattice tells.
std::vector<KeepPoint> onLattice(const std::vector<std::array<double, 3>>& places,
  const Surface& surface, const Meshlines& planes);

// The same for points to keep out, which may lie beyond the planes.
std::vector<KeepPoint> keepOutOnLattice(const std::vector<std::array<double, 3>>& places,
  const Surface& surface, const Meshlines& planes);

// Their places alone, wherever the surface is. Throws Error: as onLattice().
std::vector<Point> placesOnLattice(const std::vector<std::array<double, 3>>& places,
  const Lattice& lattice, const Meshlines& planes);

// Throws Error (BadParameter) where the surface, as it is oriented, does not enclose one of the points.
void requireInside(const std::vector<KeepPoint>& points, const char* domain);

// Whether the points lie outside of all bodies, so that the surface must be turned inside out for them. Throws Error
// (BadParameter): there are none, or some lie inside and others outside.
bool areOutside(const std::vector<KeepPoint>& points);

}

// SPDX-License-Identifier: BSD-3-Clause
// Cells one deep, swept from the faces on one side of a mesh: for flow in a plane, or, as a wedge, around an axis. (As
// OpenFOAM's extrudeMesh makes them; beyond the paper.)
//
// What is swept in a straight line has the area of the side times its thickness; a wedge has the volume that OpenFOAM's wedge
// patches ask for, with flat front and back. Points on the axis are one, and cells there have no face on it.
#pragma once

#include "Base/Range.h"
#include "Lattice/Vector.h"
#include "Sections/SideFaces.h"

namespace cartesian
{

struct SweepSpec
{
  static constexpr Range Thicknesses{ 0 };
  static constexpr Range Angles{ 0, 90, true, false }; // degrees

  // Points nearer to the axis are on it, as a part of the size of the side.
  static constexpr double OnAxis = 1e-6;

  std::size_t across = 2; // the axis that the side is the lower end along
  double thickness = 0;   // user units; 0: the mean side of its faces
  bool isWedge = false;
  std::size_t axis = 0; // of a wedge, another than `across`: its direction
  Vector origin{};      // a point on it
  double angle = 5;     // degrees, between front and back
};

// In FlatCells::source, of faces that are no edges of the side.
constexpr std::size_t FrontFace = ~std::size_t(0);
constexpr std::size_t BackFace = FrontFace - 1;

struct FlatCells
{
  CellFaces cells;                 // one for each polygon; corners counter-clockwise from outside
  std::vector<double> points;      // three coordinates each
  std::vector<std::size_t> source; // of each face: SideFaces::beside, FrontFace or BackFace
  std::vector<std::uint32_t> pointOf; // of each point, that of the mesh which it comes from
};

// Throws Error: BadParameter (a value out of its range, or faces on both sides of the axis); BadMesh (no faces).
FlatCells sweep(const SideFaces& side, const std::vector<double>& points, const SweepSpec& spec);

}

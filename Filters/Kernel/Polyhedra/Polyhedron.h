// SPDX-License-Identifier: BSD-3-Clause
// One cell by itself, and the conditions of section 3 that it has to fulfil.
#pragma once

#include "Base/RawVector.h"
#include "Lattice/Vector.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

// Nodes in levels from an origin of its own; faces counter-clockwise from outside.
struct Polyhedron
{
  RawVector<Vector> nodes; // whole numbers
  std::vector<std::uint32_t> start{ 0 };
  RawVector<std::uint32_t> corners;     // indices into nodes
  std::vector<std::uint8_t> isBoundary; // of each face

  std::size_t faces() const { return isBoundary.size(); }
  void clear();
  void reserve(std::size_t ofNodes, std::size_t ofFaces, std::size_t ofCorners);
  void addCorner(std::uint32_t node) { corners.push_back(node); }
  void closeFace(bool boundary)
  {
    start.push_back(static_cast<std::uint32_t>(corners.size()));
    isBoundary.push_back(boundary ? 1 : 0);
  }
};

struct FaceShape
{
  Vector area;   // vector, outwards
  Vector centre; // of area, by star triangulation
  Vector mean;   // of the corners
};

struct CellShape
{
  double volume = 0;
  Vector centre{}; // of volume
  std::vector<FaceShape> faces;
};

// As solvers (OpenFOAM 1912) measure.
void measure(const Polyhedron& cell, CellShape& shape);

// The same measures with the centres of faces that later versions have (CellGeometry.h).
void measureProjected(const Polyhedron& cell, CellShape& shape);

// Whether moving its nodes by a level or two, as rounding does, might turn a cell inside out: less
// thick (volume over area) than four levels.
bool isThin(const CellShape& shape);

// Whether a face seen along its normal has a star triangulation.
bool isStar(const Polyhedron& cell, std::size_t face, const Vector& normal);

// Whether all corners of a face are this close to its plane.
bool isFlat(const Polyhedron& cell, const CellShape& shape, std::size_t face, double distance);

}

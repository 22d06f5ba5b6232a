// SPDX-License-Identifier: BSD-3-Clause
// A single cell and its geometric measures.
#pragma once

#include "Base/RawVector.h"
#include "Polyhedra/CellGeometry.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

// Nodes are in levels from the cell's own origin; faces are counter-clockwise from outside.
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

inline Ring ringOf(const Polyhedron& cell, std::size_t face)
{
  const std::uint32_t begin = cell.start[face];
  return { cell.nodes.data(), cell.corners.data() + begin, cell.start[face + 1] - begin };
}

struct FaceShape
{
  Vector area;   // outward area vector
  Vector centre; // of area, from the star triangulation
  Vector mean;   // of the corners
};

struct CellShape
{
  double volume = 0;
  Vector centre{}; // of volume
  std::vector<FaceShape> faces;
};

// Measures a cell as OpenFOAM 1912 does.
void measure(const Polyhedron& cell, CellShape& shape);

// Its parts: of a face, and of a cell whose faces are measured.
FaceShape measure(const Ring& ring);
Vector areaOf(const Ring& ring); // alone
void measureVolume(CellShape& shape);

// Gives a measured cell the centres of faces of later versions (projectedCentre in CellGeometry.h), and its own by these.
void projectCentres(const Polyhedron& cell, CellShape& shape);

// Whether rounding, which moves nodes by a level or two, might turn a cell inside out: it is thinner
// (volume divided by area) than four levels.
bool isThin(const CellShape& shape);

// Whether a face, projected along `normal`, has a star triangulation.
bool isStar(const Ring& ring, const Vector& normal);

// Whether all corners of a face are within `distance` of its plane.
bool isFlat(const Ring& ring, const FaceShape& shape, double distance);

}

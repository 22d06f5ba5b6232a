// One cell by itself, and the conditions of section 3 that it has to fulfil.
#pragma once

#include "Vector.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

// Nodes in levels from an origin of its own; faces counter-clockwise from outside.
struct Polyhedron
{
  std::vector<Vector> nodes; // whole numbers
  std::vector<std::uint32_t> start{ 0 };
  std::vector<std::uint32_t> corners;   // indices into nodes
  std::vector<std::uint8_t> isBoundary; // of each face

  std::size_t faces() const { return isBoundary.size(); }
  void clear();
  void addCorner(std::uint32_t node) { corners.push_back(node); }
  void closeFace(bool boundary);
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

// As solvers (OpenFOAM) measure.
void measure(const Polyhedron& cell, CellShape& shape);

// Whether moving its nodes by a level or two, as rounding does, might turn a cell inside out: less
// thick (volume over area) than four levels.
bool isThin(const CellShape& shape);

// Cosine of the angle between the face's normal and the line from the cell's centre to the face's.
double cosineOfFace(const CellShape& shape, std::size_t face);

// The angle conditions: faces of the boundary less than 90 degrees, inner ones less than 75.
constexpr double LeastBoundaryCosine = 0;
constexpr double LeastInnerCosine = 0.258819045102521; // cos 75

// What checkMesh allows: how far the foot of the perpendicular from the cell's centre is from the
// centre of a boundary face, over the face's reach in this direction or 0.4 of its length.
constexpr double MostSkewness = 4;

// Whether all corners of a face are this close to its plane.
bool isFlat(const Polyhedron& cell, const CellShape& shape, std::size_t face, double distance);

enum class Demand
{
  Angles,  // the angle conditions
  Fitness, // and no boundary face is too skewed
};

bool isUnfit(const Polyhedron& cell, const CellShape& shape, std::size_t face,
  Demand demand = Demand::Fitness);

// Whether a face seen along its normal has a star triangulation.
bool isStar(const Polyhedron& cell, std::size_t face, const Vector& normal);

// Area of the unfit faces.
double unfitArea(const Polyhedron& cell, const CellShape& shape, Demand demand = Demand::Fitness);

}

// SPDX-License-Identifier: BSD-3-Clause
// The sections of polyhedra with a plane: one polygon for each connected part of a cell's section.
//
// What lies in the plane counts as above it: so a face in it is the section of the cell below, and no cell is cut twice.
#pragma once

#include "Sections/PointSums.h"

namespace cartesian
{

struct SectionPlane
{
  Vector origin;
  Vector normal; // upwards, of length 1
  double offset; // of the plane from the origin along the normal

  double height(const Vector& p) const { return dot(normal, minus(p, origin)) - offset; }
};

struct PlaneSection
{
  // How a point lies between two ends: points of the mesh or, from `given` on, centres of fans.
  struct Place
  {
    std::uint32_t from;
    std::uint32_t to;
    double part; // of the way
  };

  std::vector<Vector> points; // each once
  std::vector<Place> places;  // of the points
  std::uint32_t given = 0;
  std::vector<std::uint32_t> fans;           // faces that have one
  std::vector<std::size_t> firstCorner{ 0 }; // of each polygon, and the end
  std::vector<std::uint32_t> corners;        // points, counter-clockwise seen from above
  std::vector<std::uint32_t> cell;           // of each polygon

  std::size_t count() const { return cell.size(); }
};

// `cells`: with corners counter-clockwise from outside. `points`: three coordinates each. `heights`: of all points.
// Faces that are not flat are those of solvers (FaceFans.h). A section with holes is one polygon, joined to each by two edges
// that coincide.
PlaneSection planeSection(const CellFaces& cells, const double* points,
  const std::vector<double>& heights, const SectionPlane& plane, Execution& execution);

// The section's points as sums of the mesh's.
PointSums sumsOf(
  const PlaneSection& section, const CellFaces& cells, const double* points, Execution& execution);

}

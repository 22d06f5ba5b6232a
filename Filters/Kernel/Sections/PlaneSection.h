// SPDX-License-Identifier: BSD-3-Clause
// The sections of polyhedra with a plane: one polygon for each connected part of a cell's section.
//
// What lies in the plane counts as above it: so a face in it is the section of the cell below, and no cell is cut twice.
#pragma once

#include "Lattice/Vector.h"
#include "Quality/FaceList.h"

namespace cartesian
{

struct PlaneSection
{
  // A point on an edge, at this part of the way from one of its ends to the other; or a point of the mesh, at 0.
  struct Place
  {
    std::uint32_t from;
    std::uint32_t to;
    double part;
  };

  std::vector<Place> places;                 // each once
  std::vector<std::size_t> firstCorner{ 0 }; // of each polygon, and the end
  std::vector<std::uint32_t> corners;        // places, counter-clockwise seen from above
  std::vector<std::uint32_t> cell;           // of each polygon

  std::size_t count() const { return cell.size(); }
};

// `cells`: with corners counter-clockwise from outside. `points`: three coordinates each. `heights`: of the points above the
// plane. `normal`: of the plane, upwards. A section with holes is one polygon, joined to each by two edges that coincide.
PlaneSection planeSection(const CellFaces& cells, const double* points, const double* heights,
  const Vector& normal, Execution& execution);

}

// An independent judge of meshes: it knows the arrays that were written, and nothing of how.
#pragma once

#include "Support/Pipeline.h"

#include <gtest/gtest.h>

namespace cartesian
{

// A valid finite-volume mesh, whatever it is a mesh of:
// - cells lie in their boxes, are closed edge by edge and have a positive volume, which is
//   `volumeFraction` of the box's
// - each face belongs to two cells, once either way round, or is listed once as boundary
// - boundary edges are run through as often one way as the other
// - no points coincide, none is unused
// `merged`: cells may reach into neighbouring boxes.
::testing::AssertionResult isValid(const MeshArrays& mesh, bool merged = false);

// The mesh fills the surface: its volume, and its boundary's area, boundary by boundary, are the
// surface's to 1e-9 or to two steps of the lattice.
::testing::AssertionResult fills(const MeshArrays& mesh, const Soup& soup);

// How far off the volume may be: 1e-9 or two steps of the lattice.
double volumeSlack(const MeshArrays& mesh, const Soup& soup);

double volumeOf(const MeshArrays& mesh);

// The points of each face of a cell, counter-clockwise from outside.
using Face = std::vector<Id>;
std::vector<Face> facesOf(const MeshArrays& mesh, std::size_t cell);

// Volumes of the cells of each box (I, J, K), ascending.
std::map<std::array<int, 3>, std::vector<double>> volumesByBox(const MeshArrays& mesh);

}

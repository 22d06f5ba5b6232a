// An independent check of meshes: it knows only the arrays that were written, not how they were made.
#pragma once

#include "Quality/QualityMeasures.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <optional>

namespace cartesian
{

// Whether a mesh is a valid finite-volume mesh, whatever its surface:
// - cells lie in their boxes, are closed edge by edge and have a positive volume, which is
//   `volumeFraction` of the box's
// - each face belongs to two cells, with opposite orientations, or is listed once as boundary
// - boundary edges are used as often in one direction as in the other
// - no points coincide, none is unused
// `merged`: cells may extend into neighbouring boxes.
::testing::AssertionResult isValid(const MeshArrays& mesh, bool merged = false);

// The mesh fills the surface: its volume, and its boundary's area, boundary by boundary, are the
// surface's to 1e-9 or to two steps of the lattice.
::testing::AssertionResult fills(const MeshArrays& mesh, const Soup& soup);

// The tolerance of the volume: 1e-9 or two steps of the lattice.
double volumeSlack(const MeshArrays& mesh, const Soup& soup);

double volumeOf(const MeshArrays& mesh);

std::map<int, double> volumesByRegion(const MeshArrays& mesh);

// Of the faces of each boundary, and of the triangles of each.
std::map<std::int32_t, double> areasByBoundary(const MeshArrays& mesh);
std::map<std::int32_t, double> areasByBoundary(const Soup& soup);

// The area of the faces between each two regions, the lower first, or between outside (0) and a region. Faces
// count as between two cells if both have the same points.
std::map<std::pair<int, int>, double> areasBetweenRegions(const MeshArrays& mesh);

// The points of each face of a cell, counter-clockwise from outside.
using Face = std::vector<Id>;
std::vector<Face> facesOf(const MeshArrays& mesh, std::size_t cell);

// Of all cells, or of one region by itself.
Quality qualityOf(const MeshArrays& mesh, std::optional<int> region = {});

// Volumes of the cells of each box (I, J, K), ascending.
std::map<std::array<int, 3>, std::vector<double>> volumesByBox(const MeshArrays& mesh);

}

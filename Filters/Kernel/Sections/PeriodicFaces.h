// SPDX-License-Identifier: BSD-3-Clause
// Gives two flat sides of a mesh the same faces (PlaneOverlay.h), as a periodic pair of boundaries must have them.
//
// The first side stays as it is, except for new points on its edges and within its faces, and for points of faces that cross
// themselves (FoldedPolygons.h). The second's outline moves onto the first's (OutlineFitting.h), and points near it with it; others move
// along the side by at most PlaneOverlay::Nearby of the distance to the next, onto those of the first. All cells stay closed: where edges get points, all
// their faces do.
#pragma once

#include "Quality/FaceList.h"
#include "Sections/SideMotion.h"

namespace cartesian
{

struct PeriodicSpec
{
  // Points of a side may stand off its plane by so much of its size.
  static constexpr double Flatness = 1e-6;

  // Sides that differ by more than this part of their area do not match.
  static constexpr double Unmatched = 1e-9;

  // Points on the axis, and other places of both sides: nearer than this part of the side's size.
  static constexpr double Same = 1e-9;
};

enum class FacesOfPair
{
  Same, // of both sides
  Own   // of each; only the outlines of flat sides become the same, and so the areas
};

struct PeriodicFaces
{
  CellFaces cells;            // the same cells, whose corners are counter-clockwise from outside
  std::vector<double> points; // three coordinates each; those of the mesh, then new ones
  std::vector<std::size_t> source; // of each face, that of the mesh which it is, or is a part of

  // Pairs of the same faces, of the first side and of the second. The first corners are the same place; further ones follow in opposite
  // order.
  std::vector<std::array<std::size_t, 2>> pairs;

  double farthest = 0; // that a point of the second side has moved by
};

// `sides`: faces of `cells`, with corners counter-clockwise from outside. `motion`: from the first to the second side. Throws Error
// (BadMesh), unless faces are their own: the first is not flat, or they are not the same.
PeriodicFaces matchSides(const CellFaces& cells, const std::vector<double>& points,
  const std::array<std::vector<std::size_t>, 2>& sides, const SideMotion& motion,
  FacesOfPair which = FacesOfPair::Same);

}

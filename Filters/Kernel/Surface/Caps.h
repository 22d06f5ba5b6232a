// SPDX-License-Identifier: BSD-3-Clause
// Flat patches, and those among them that may close a duct.
#pragma once

#include "Lattice/Vector.h"
#include "Surface/Features.h"
#include "Surface/SurfaceEdges.h"

namespace cartesian
{

// How far a flat patch is off its plane at most, relative to the distance of its farthest point from its centre; and
// by how much normals and places of one plane may differ.
constexpr double Flatness = 1e-5;

struct PatchShape
{
  Vector area{};        // the sum of its triangles' area vectors, in square user units
  double size = 0;      // its area
  Vector centre{};      // of its area
  double radius = 0;    // the distance of its farthest point from the centre
  double thickness = 0; // the distance of a point from the plane, at most
  bool isFlat = false;
};

// Of `count` patches; `patchOf`: of each triangle of the surface, which is that of the view on the lattice.
std::vector<PatchShape> shapesOf(const SurfaceView& view, const Surface& surface,
  const std::vector<std::uint32_t>& patchOf, std::size_t count);

// Which patches are caps: flat; the surface turns inwards along all of their rim, by 40 degrees or more; and
// the patches there are at least four times as large together, as the walls of a duct that is as long as wide. An
// annulus may be one; a wall that a duct begins at is none.
std::vector<std::uint8_t> findCaps(const Surface& surface, const SurfaceEdges& edges,
  const Features& features, const std::vector<std::uint32_t>& patchOf,
  const std::vector<PatchShape>& shapes);

// The lowest patch in the plane of each flat patch that faces the same way; other patches are alone. `size`: of the surface.
std::vector<std::uint32_t> planesOf(const std::vector<PatchShape>& shapes, double size);

}

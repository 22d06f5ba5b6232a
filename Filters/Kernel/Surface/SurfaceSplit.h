// SPDX-License-Identifier: BSD-3-Clause
// Divides a surface into patches that may become boundaries.
#pragma once

#include "Lattice/Vector.h"
#include "Surface/Surface.h"

namespace cartesian
{

enum class SplitBy
{
  FeatureAngle, // at edges where the surface turns by more than the feature angle, whatever edges are known
  FlatCaps,       // flat ends of ducts, and the rest of each boundary (Caps.h)
  Planes,         // flat patches, those in one plane together, and the rest of each boundary
  ConnectedParts, // that have no edge in common
  Boundaries      // as they are
};

struct SplitSpec
{
  SplitBy by = SplitBy::FlatCaps;
  double featureAngle = 30; // in degrees, 0 to 180
};

struct SurfacePatch
{
  std::int32_t boundary = 0; // of which it is all or a part
  bool standsAlone = false;  // a cap or a plane, not the rest of its boundary
  std::size_t triangles = 0;
  double area = 0; // in square user units
  Vector centre{}; // of its area
};

struct SurfaceSplit
{
  std::vector<std::uint32_t> patchOf; // of each triangle of the view
  // In order of boundaries; of one boundary caps and planes first, and larger ones before smaller ones.
  std::vector<SurfacePatch> patches;
};

// No patch has triangles of two boundaries. The patches depend neither on the order of the triangles nor on where the
// surface is. Throws Error: EmptySurface, BadCoordinate.
SurfaceSplit splitSurface(const SurfaceView& view, const SplitSpec& spec, Execution& execution);

}

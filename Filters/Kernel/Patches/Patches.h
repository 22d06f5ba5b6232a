// SPDX-License-Identifier: BSD-3-Clause
// Generation of Patches (section 4.7): the boundary faces inside each intersected box, by Marching
// Cubes or Exact Fit, tied (4.8) and simplified (A2).
//
// Method: Marching Cubes without a table (Lattice/MarchingCubes.h) where a box has a plain piece of a smooth wall, the surface's own
// triangles, clipped (Lattice/ExactFit.h), where it has edges, corners or borders: PatchChoice.h decides, box by box.
// Sources: Lorensen and Cline 1987 for Marching Cubes; Sutherland and Hodgman 1974 for clipping; the rest is the paper's.
// Limits: Marching Cubes sees only crossings with edges of boxes, so that what lies between them is lost (Patches::missing says how
// much); patches do not close where the surface is flawed within a box: BoxRebuilding.h makes these anew.
#pragma once

#include "Boxes/Shoeboxes.h"
#include "Patches/PatchChoice.h"
#include "Patches/PatchSpec.h"

namespace cartesian
{

// Polygons with outward normals, by intersected box. Together they are watertight: every edge is
// shared by two polygons (by an even number at non-manifold places).
struct Patches
{
  std::vector<Point> points;         // each once
  RawVector<PointKind> kinds;        // of points, without OffSurface
  bool knowsEdges = false;           // the surface knows its sharp edges: so do the kinds
  RawVector<std::size_t> start;      // first corner of each polygon, and the end
  RawVector<std::uint32_t> corners;  // ids of points
  RawVector<std::uint32_t> triangle; // of the surface, from which each polygon comes
  RawVector<std::int32_t> boundary;  // boundary index of each polygon
  Walls walls;                       // of the surface
  std::vector<float> enclosed;       // of each of its triangles, by its component (Components.h)
  std::vector<std::size_t> boxStart; // first polygon of the n-th intersected box, and the end
  std::vector<PatchReason> reason;   // of the n-th intersected box

  // Of the n-th intersected box: the volume that the surface encloses there and the patches do not (VolumeGap.h), by
  // their area; levels. Empty: not known.
  std::vector<float> missing;

  // The part of the domain that the surface encloses, in cubic user units; 0: not known, or given by the part with
  // the lowest layer.
  double surfaceVolume = 0;

  std::size_t size() const { return triangle.size(); }
};

// Whether the user chose the exact surface, which no later step may then approximate.
bool isExact(const Patches& patches);

// Where finer neighbours divide a side of a box, its patches have nodes on the lines between them, so
// that patches meet corner to corner across the side. Throws Error: BadParameter.
Patches generatePatches(const Surface& surface, const Boxes& boxes, const Shoeboxes& shoeboxes,
  const PatchSpec& spec, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// The walls of bodies, each once: what lies between two regions, or between one and outside.
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

// `arranged`: of all regions (Surface::region, from FirstRegion to `regions`), each closed and oriented, which cross
// nowhere (Arrangement.h). Where several regions are, the first of them is; bodies of one region are one. Boundary
// indices of the result are those of its walls. Triangles with the same region on both sides are left out.
// `crossing`: triangles of `arranged` that still cross others, so that what is beside them is not sure.
Surface wallsOf(const Surface& arranged, std::int32_t regions, std::vector<std::uint32_t>& crossing,
  Execution& execution);

// Makes bodies of one region, which are arranged likewise, one: takes out what is in another of them, or between two that touch. Does nothing and
// returns false where some still cross, or nothing is left.
bool unite(Surface& surface, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// Strips of triangles between rims that face each other (FacingRims.h): of a lid and its frame, of the halves of a body.
//
// From the nearest vertices that face each other on, both rims are followed both ways as long as their edges face each other: a step goes
// along the rim whose next vertex comes first. What was passed is zipped (ZippedChains.h). A strip ends where one of the rims turns away,
// or where an edge of one reaches beyond the end of the other. What is left there is a hole (StripEnds.h).
// Limits: only between different loops; the two sides of a slot in one sheet are one loop, and a hole. Every triangle has
// vertices of both rims: at teeth that are narrower than the gap they overlap. Where both rims are aslant at a sharp edge of a body,
// the least area may cut its corner off. Edges are not divided: one that reaches along several sheets is the end of a strip with each.
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

struct RimStrip
{
  // Vertices: along one side, back along the other; where these are loops, from seam to seam.
  std::vector<std::uint32_t> rim;

  std::vector<std::array<std::uint32_t, 3>> triangles; // oriented like most along the rims
  double width;                                        // the largest distance across, levels
};

// Those at most `widest` levels wide, the nearest rims first. Edges that an odd number of triangles use are open.
std::vector<RimStrip> findRimStrips(const Surface& surface, double widest, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// The triangles between two chains of vertices that run along each other.
//
// Of all triangulations near a way along both chains, it is the one with the least area, found by dynamic programming (Fuchs, Kedem,
// Uselton 1977, with the least area of Barequet and Sharir 1995). In a plane all that do not overlap have the same area: there the one
// whose triangles have the shorter edges across. The time is proportional to the chains' lengths.
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

struct ChainPair
{
  std::vector<std::uint32_t>
    first; // vertices; a closed chain ends with the one that it starts with
  std::vector<std::uint32_t> second; // likewise, the same way
  std::vector<bool> steps;           // from both starts to both ends; true: along the first
};

// Those along the first chain run its way. None: a triangle would have a vertex of both chains twice.
std::vector<std::array<std::uint32_t, 3>> zipped(const Surface& surface, const ChainPair& chains);

}

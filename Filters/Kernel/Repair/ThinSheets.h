// SPDX-License-Identifier: BSD-3-Clause
// Sheets without thickness, whose triangles are there twice (a front and a back, such as a fairing), get two sides.
//
// Between the sides is next to nothing, some levels of the lattice: that is outside. The rims stay where they are, in
// free space or at other walls, so a sheet may end anywhere. All later steps see a thin closed body.
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

// A sheet is a connected part of duplicates, in pairs, at least one edge of which no other triangle uses. The first
// triangle of each pair becomes the side that the sheet's lowest triangle faces, the second one the other; where all
// corners are on rims, further triangles are appended. Returns the number of pairs.
std::size_t giveSidesToSheets(Surface& surface, Execution& execution);

}

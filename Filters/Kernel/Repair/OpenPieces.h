// SPDX-License-Identifier: BSD-3-Clause
// The open pieces of a surface: triangles of one region that are connected across edges of exactly two of them, where one has an
// edge that nothing else of its region uses.
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

struct OpenPiece
{
  std::vector<std::uint32_t> triangles; // in order
  std::vector<std::array<std::uint32_t, 2>>
    rim; // edges that nothing else uses, the lower end first
};

// In order of their first triangles. `isLeftOut`: of each triangle, 1: it is as if it were not there; or empty.
std::vector<OpenPiece> openPiecesOf(
  const Surface& surface, const std::vector<std::uint8_t>& isLeftOut, Execution& execution);

}

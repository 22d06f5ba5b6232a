// SPDX-License-Identifier: BSD-3-Clause
// Baffles: open sheets in a region, each side of which becomes a boundary.
//
// A sheet that reaches from wall to wall divides its region into parts. In all steps before output the parts are
// separate regions, and the sheet is the wall between them (Walls.h): so the cells on both sides share its faces, and
// everything that holds between regions holds here. Walls::given has the region of each part. If one ends elsewhere,
// all get two sides like sheets present twice (ThinSheets.h).
//
// The rim of a sheet need not have the edges of the walls: its corners move to the nearest places on the walls, and
// the triangles on both sides are divided along each other where the sheet's plane meets them.
#pragma once

#include "Surface/Surface.h"

#include <optional>
#include <string>
#include <vector>

namespace cartesian
{

struct Baffle
{
  std::int32_t boundary; // of its triangles: of the cells that these point away from
  std::int32_t back;     // of the cells on the other side
};

// Takes the triangles of baffles out of a surface.
Surface takeBaffles(Surface& surface, const std::vector<Baffle>& baffles);

// The parts of regions.
struct RegionParts
{
  std::vector<std::int32_t>
    given; // of each part, the region that it is a part of; parts are numbered as regions
};

// `surface`: of all regions, each closed and oriented; Surface::region are parts then. `sheets`: from takeBaffles().
// `tolerance`: how far from walls rims may end, in levels. `names`: of regions, for messages. Returns nothing if a
// sheet ends within its region or does not divide it. Throws Error (FlawedSurface): a sheet lies outside its region
// or on a wall.
std::optional<RegionParts> divideByBaffles(Surface& surface, Surface sheets,
  const std::vector<Baffle>& baffles, std::int32_t regions, double tolerance,
  const std::vector<std::string>& names, Execution& execution);

// Turns baffles and open sheets, which may end anywhere, into sheets present twice (Surface::ofSheet): in a surface that
// need not be closed yet, of one region or several. `open`: of each triangle, 1: of an open sheet (OpenSheets.h), both sides
// of which have its boundary; or empty. `tolerance`: as above.
void doubleSheets(Surface& surface, const std::vector<Baffle>& baffles,
  const std::vector<std::uint8_t>& open, double tolerance, Execution& execution);

}

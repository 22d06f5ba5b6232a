// SPDX-License-Identifier: BSD-3-Clause
// The walls of bodies, each once: what lies between two regions, or between one and outside; and the sheets in them.
#pragma once

#include "Repair/Spaces.h"
#include "Surface/Surface.h"

namespace cartesian
{

// The meshed part of one region, as far as known.
enum class MeshedSide
{
  Inside,
  Outside,
  Unknown
};

struct Bodies
{
  std::int32_t regions;            // from FirstRegion on
  std::vector<std::int32_t> given; // as Walls::given: sheets are of the user's regions
  MeshedSide meshed = MeshedSide::Inside;
  std::int32_t around = 0; // how often other bodies of the only region wind around all of them
};

// In Surface::region, of sheets in a region of the user's, where there are so many regions.
constexpr std::int32_t regionOfSheets(std::int32_t region, std::int32_t regions)
{
  return regions + region;
}

// `arranged`: of all regions, each closed and oriented, which cross nowhere (Arrangement.h), and sheets, whose
// triangles are there in both directions. Where regions overlap, the first listed wins; bodies of one region are
// united. Boundary indices of the result are those of its walls. Of triangles with the same space on both sides,
// those of sheets that are in their region get sides (ThinSheets.h), or, where it is not meshed, those outside;
// others are left out. `crossing`: triangles of `arranged` that still cross others, so that what is beside them is
// not sure. `inside`: those left out inside a body, not between two that touch.
Surface wallsOf(const Surface& arranged, const Bodies& bodies, std::vector<std::uint32_t>& crossing,
  Execution& execution, std::vector<std::uint32_t>* inside = nullptr);

// The same where the spaces are known.
Surface wallsBetween(const Surface& arranged, const Bodies& bodies,
  const std::vector<Piece>& pieces, const Spaces& spaces, Execution& execution);

// Replaces a surface by walls of its only region, with the boundaries that it had.
void takeWalls(Surface& surface, Surface walls);

// Unites bodies of one region, arranged likewise: removes triangles inside another body, or between two that touch.
// Does nothing and returns false where some still cross (`crossing`), or nothing is left.
bool unite(Surface& surface, const Bodies& bodies, std::vector<std::uint32_t>& crossing,
  Execution& execution, std::vector<std::uint32_t>* inside = nullptr);

// In Surface::given, of a triangle that closes a hole.
constexpr std::uint32_t ClosesAHole = ~0u;

// Puts vertices in order of their places, and triangles in order of vertices, as onLattice() does; those that close
// holes become the last, without an entry in Surface::given.
void sortByPlace(Surface& surface);

}

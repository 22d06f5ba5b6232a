// SPDX-License-Identifier: BSD-3-Clause
// What axis-parallel lines through a surface say about its sheets: which way they face, and which closed ones lie in
// which.
//
// Before its odd crossings with a surface a line is outside, before its even ones inside. A line that crosses the
// surface an odd number of times (through a hole) has no vote, nor have crossings at the same level of the lattice.
#pragma once

#include "Repair/ManifoldComponents.h"
#include "Repair/TriangleTree.h"

#include <map>

namespace cartesian
{

// All sheets that are not closed, as if they were one.
constexpr std::uint32_t AllOpenSheets = ~0u;

struct RayParityVotes
{
  struct OfFacing
  {
    long long outward = 0; // that the sheet's first triangle has its normal outward
    long long inward = 0;

    bool isTie() const { return outward == inward; }
    bool isOutward() const { return outward > inward; }
  };

  struct OfNesting
  {
    long long inside = 0;  // samples of the first sheet that lie in the second
    long long unknown = 0; // on it, as exactly as places are known
  };

  std::vector<OfFacing> amongAll; // of each sheet, by the crossings with all sheets
  std::vector<OfFacing> alone;    // of each closed sheet, by its own crossings
  std::vector<long long> samples; // of each closed sheet: crossings with the lines laid through it
  std::map<std::array<std::uint32_t, 2>, OfNesting>
    nesting; // of a closed sheet in another, or in AllOpenSheets
};

// `tree`: of the surface.
RayParityVotes voteOnSheets(const Surface& surface, const ManifoldComponents& sheets,
  const TriangleTree& tree, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
// Zero-thickness sheets, whose triangles are present twice, such as a fairing or a guide vane, get a small thickness,
// so that each side is a separate wall, wherever the sheet ends.
//
// The two triangles of a pair move apart, each in the direction that the sheet faces on its side; along its free rims the
// sheet has no thickness. The result is a closed shell, which all later steps treat as a body; where it ends on a wall,
// it opens into what is behind that.
#pragma once

#include "Repair/Duplicates.h"

namespace cartesian
{

// Of sheets present twice, and of open surfaces (OpenSheets.h).
enum class SheetHandling
{
  Automatic = 0, // sheets are those present twice, and open ones that would enclose next to nothing
  LeaveOut = 1,  // none: open surfaces are closed
  Keep = 2       // all
};

// Two triangles with the same vertices.
using SheetPair = std::array<std::uint32_t, 2>;

// The pairs among duplicates that are known to be of sheets (Surface::ofSheet), and, if sheets are kept, those that
// are connected with an edge that nothing else uses. Others are a body written twice, or a wall between two bodies.
std::vector<SheetPair> findSheets(const Surface& surface, SheetHandling sheets,
  const SurfaceEdges& edges, const Duplicates& duplicates);

// Of triangles that are walls: whether the spaces behind them and in front are meshed.
using MeshedSides = std::vector<std::array<std::uint8_t, 2>>;

// `sheets`: pairs that are sheets, `edges`: of the surface before. A sheet goes on across edges that two of these pairs
// use and nothing else; all other edges are rims, whose vertices stay. But if `meshed` is given, each space has vertices of
// its own where sheets end on walls that close the meshed space, or on another sheet. Triangles keep their numbers; where
// one has to be divided, further pieces are appended (Surface::given). The side that a triangle faces has its boundary.
// Marks the triangles (Surface::ofSheet), and orients them out of the shells.
void giveSides(Surface& surface, const SurfaceEdges& edges, const std::vector<SheetPair>& sheets,
  const MeshedSides& meshed = {});

}

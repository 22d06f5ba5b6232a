// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a mesh for its report: its boundary, a cut along whole cells, and cells to look at.
#pragma once

#include "GridFaces.h"
#include "Lattice/Vector.h"
#include "Report/ReportPage.h"

#include <optional>

namespace cartesian
{

// Every face of a mesh once, with what it is drawn in.
struct DrawnMesh
{
  const double* points; // three coordinates each
  const CellFaces& cells;
  const FaceList& faces;
  std::vector<Colour> colours; // of each boundary face
  std::optional<Vector>
    flow; // of a mesh around bodies: its direction; the sides in front of these are left out
};

ReportPicture pictureOfBoundary(const DrawnMesh& mesh);

// The cells on one side of a plane, across the most material; around bodies, along the flow through their middle.
ReportPicture pictureOfCut(const DrawnMesh& mesh);

// `which`: cells in red, in front of the pale boundary; in circles, if they are not many.
ReportPicture pictureOfCells(const DrawnMesh& mesh, const std::vector<std::uint32_t>& which);

}

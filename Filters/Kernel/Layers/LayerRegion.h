// SPDX-License-Identifier: BSD-3-Clause
// One region of a mesh as layers see it; with a single region, the whole mesh.
#pragma once

#include "Mesh/OutputMesh.h"

namespace cartesian
{

struct LayerRegion
{
  std::int32_t region;
  std::vector<BoundaryFace>
    faces; // of the mesh's boundary, then those of interfaces as this region has them
  std::vector<std::int32_t> boundary; // of each face, the user's on this side
  std::vector<std::size_t>
    ofInterface;     // of each face of an interface, which of OutputMesh::interfaces()
  BoundaryMesh mesh; // of the faces
  std::vector<std::uint8_t>
    isShared; // of each of its nodes: another region has it, too; empty: none
  std::vector<std::uint8_t>
    isElsewhere; // of each cell, as CellArrays has them: in another region; empty: none

  std::size_t boundaryFaces() const { return faces.size() - ofInterface.size(); }
  bool isInterface(std::size_t face) const { return face >= boundaryFaces(); }
};

// In order. `walls`: without baffles.
std::vector<LayerRegion> layerRegions(
  const OutputMesh& mesh, const Walls& walls, Execution& execution);

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Interfaces.h"

namespace cartesian
{

void makeInterfaces(const Patches& patches, InnerFaces& inner, Cells& cells, Execution& execution)
{
  if (!patches.walls.any())
  {
    return;
  }
  std::vector<std::uint32_t> innerOf(patches.size(), None);
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    if (patches.walls.isInterface(patches.boundary[p]))
    {
      innerOf[p] = static_cast<std::uint32_t>(inner.size());
      inner.nodes.insert(inner.nodes.end(),
        patches.corners.begin() + std::ptrdiff_t(patches.start[p]),
        patches.corners.begin() + std::ptrdiff_t(patches.start[p + 1]));
      inner.start.push_back(inner.nodes.size());
      inner.wall.push_back(patches.boundary[p]);
    }
  }
  for (FaceOfCell& face : cells.faces)
  {
    if (face.isPatch() && innerOf[face.index] != None)
    {
      face = FaceOfCell(innerOf[face.index],
        face.turned() ? FaceOfCell::Kind::TurnedInner : FaceOfCell::Kind::Inner);
    }
  }
  findCellsOfInnerFaces(inner, cells, execution);
}

// Hexahedra are in boxes that no wall passes through.
bool isInterface(const Cells& cells, const FaceOfCell& face)
{
  if (face.isPatch())
  {
    return false;
  }
  const bool inner =
    face.kind() == FaceOfCell::Kind::Inner || face.kind() == FaceOfCell::Kind::TurnedInner;
  const auto& [below, above] =
    inner ? cells.ofInnerFace[face.index] : cells.shaped.cells[face.index];
  return below < cells.size() && above < cells.size() &&
    cells.all[below].region != cells.all[above].region;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Interfaces.h"

namespace cartesian
{

void makeInterfaces(const Walls& walls, WallMesh& wall)
{
  if (!walls.any())
  {
    return;
  }
  WallFaces& faces = wall.faces;
  std::vector<std::uint32_t> interfaceOf(faces.firstOfSides(), None);
  for (std::uint32_t p = 0; p < interfaceOf.size(); ++p)
  {
    if (walls.isInterface(faces.boundary[p]))
    {
      interfaceOf[p] = static_cast<std::uint32_t>(faces.size());
      const std::size_t end = faces.start[p + 1];
      for (std::size_t i = faces.start[p]; i < end; ++i)
      {
        faces.corners.push_back(std::uint32_t(faces.corners[i]));
      }
      faces.add(std::array<CellKey, 2>(faces.cells[p]), faces.boundary[p]);
      faces.cells[p] = { None, None };
    }
  }
  for (FaceUse& use : wall.uses)
  {
    if (faces.isPatch(use.face) && interfaceOf[use.face] != None)
    {
      use = FaceUse(interfaceOf[use.face], use.turned != 0);
    }
  }
}

}

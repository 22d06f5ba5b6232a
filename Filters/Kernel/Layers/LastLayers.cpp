// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/LastLayers.h"

#include <algorithm>
#include <array>

namespace cartesian
{

namespace
{

// The lowest nodes of a face of the wall, by which its cell is found: of two faces, at most two are the same.
using Key = std::array<std::uint32_t, 3>;

struct FaceOfCell
{
  Key key;
  std::uint32_t cell;

  bool operator<(const FaceOfCell& other) const { return key < other.key; }
};

Key keyOf(std::vector<std::uint32_t>& nodes)
{
  std::partial_sort(nodes.begin(), nodes.begin() + 3, nodes.end());
  return { nodes[0], nodes[1], nodes[2] };
}

std::vector<FaceOfCell> facesAtWall(const NearCells& near)
{
  std::vector<FaceOfCell> found;
  std::vector<std::uint32_t> nodes;
  const CellFaces& cells = near.cells;
  for (std::uint32_t c = 0; c < cells.cellCount(); ++c)
  {
    for (std::size_t f = cells.firstFace[c]; f < cells.firstFace[c + 1]; ++f)
    {
      nodes.clear();
      for (std::size_t i = cells.firstCorner[f]; i < cells.firstCorner[f + 1]; ++i)
      {
        nodes.push_back(near.wallNode[cells.corners[i]]);
      }
      if (std::find(nodes.begin(), nodes.end(), None) == nodes.end())
      {
        found.push_back({ keyOf(nodes), c });
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}

std::vector<double> lastByCells(const LayeredWall& wall, const LayerHeights& heights,
  const NearCells& near, const std::vector<double>& volumes, Execution& execution)
{
  const StackCells cells(wall, heights, execution);
  const std::vector<FaceOfCell> faces = facesAtWall(near);
  std::vector<double> ratios(wall.layered.size());
  std::vector<std::uint32_t> nodes;
  for (std::size_t f = 0; f < ratios.size(); ++f)
  {
    if (!wall.hasStack(f) || wall.tapers(f))
    {
      continue;
    }
    nodes.clear();
    for (std::size_t i = 0; i < wall.corners(f); ++i)
    {
      nodes.push_back(static_cast<std::uint32_t>(wall.node(f, i)));
    }
    const FaceOfCell wanted{ keyOf(nodes), 0 };
    const auto at = std::lower_bound(faces.begin(), faces.end(), wanted);
    if (at != faces.end() && at->key == wanted.key)
    {
      const double height = wall.heightOn(f, [&](std::size_t n) {
        return wall.parts[n] -
          heights.at(wall.parts[n], cells.layers() - cells.end(f, 0), wall.isFlat[n]);
      });
      ratios[f] = height * wall.area(f) / volumes[at->cell];
    }
  }
  return ratios;
}

}

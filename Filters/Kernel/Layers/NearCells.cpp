// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/NearCells.h"

#include "Quality/FaceCorners.h"

#include <algorithm>

namespace cartesian
{

namespace
{

class NearFinder
{
public:
  NearFinder(const OutputMesh& mesh, const LayeredWall& wall)
    : mesh_(mesh)
    , isElsewhere_(wall.of.isElsewhere)
    , isNear_(static_cast<std::size_t>(mesh.cellCount()))
    , points_(static_cast<std::size_t>(mesh.pointCount()))
  {
    near_.wallNode.assign(points_, None);
    near_.origin.assign(points_, None);
    for (std::size_t n = 0; n < wall.nodes(); ++n)
    {
      if (wall.isOnWall[n])
      {
        const auto point = static_cast<std::size_t>(wall.of.mesh.meshPoint[n]);
        near_.wallNode[point] = static_cast<std::uint32_t>(n);
        near_.origin[point] = static_cast<std::uint32_t>(n);
      }
      else if (!wall.of.isShared.empty() && wall.of.isShared[n])
      {
        shared_.push_back(static_cast<std::size_t>(wall.of.mesh.meshPoint[n]));
      }
    }
  }

  NearCells run(int rings)
  {
    for (int ring = 0; ring < rings; ++ring)
    {
      addRing();
    }
    near_.mayMove.assign(points_, 0);
    for (std::size_t p = 0; p < points_; ++p)
    {
      near_.mayMove[p] = near_.origin[p] != None && near_.wallNode[p] == None;
    }
    forEachOther([&](const CellOfMesh& cell) {
      forEachPoint(cell, [&](std::size_t p) { near_.mayMove[p] = 0; });
    });
    for (const std::size_t p : shared_)
    {
      near_.mayMove[p] = 0;
    }
    addRing();
    listCells();
    return std::move(near_);
  }

private:
  // Calls visit(cell) for those of the region that are not near so far.
  template <class Visitor>
  void forEachOther(Visitor&& visit) const
  {
    mesh_.forEachCell([&](const CellOfMesh& cell) {
      if (!isNear_[cell.place] && (isElsewhere_.empty() || !isElsewhere_[cell.place]))
      {
        visit(cell);
      }
    });
  }

  template <class Visitor>
  void forEachPoint(const CellOfMesh& cell, Visitor&& visit) const
  {
    mesh_.forEachPoint(cell, [&](Id point) { visit(static_cast<std::size_t>(point)); });
  }

  // The cells at known points, and their points.
  void addRing()
  {
    std::vector<std::uint32_t> next = near_.origin;
    forEachOther([&](const CellOfMesh& cell) {
      std::uint32_t least = None;
      forEachPoint(cell, [&](std::size_t p) { least = std::min(least, near_.origin[p]); });
      if (least == None)
      {
        return;
      }
      isNear_[cell.place] = true;
      forEachPoint(cell, [&](std::size_t p) {
        next[p] = near_.origin[p] == None ? std::min(next[p], least) : next[p];
      });
    });
    near_.origin = std::move(next);
  }

  void listCells()
  {
    near_.cells.firstFace.assign(1, 0);
    near_.cells.firstCorner.assign(1, 0);
    mesh_.forEachCell([&](const CellOfMesh& cell) {
      if (isNear_[cell.place])
      {
        near_.places.push_back(static_cast<Id>(cell.place));
        mesh_.addFaces(cell, near_.cells);
      }
    });
  }

  const OutputMesh& mesh_;
  const std::vector<std::uint8_t>& isElsewhere_;
  std::vector<std::size_t>
    shared_; // points that cells of other regions have, too, and that are not on the wall
  std::vector<bool> isNear_; // of each cell, so far
  const std::size_t points_;
  NearCells near_;
};

}

std::vector<double> volumesOf(const CellFaces& cells, const std::vector<double>& points)
{
  std::vector<double> result(cells.cellCount());
  std::vector<FaceGeometry> faces;
  for (std::size_t c = 0; c < result.size(); ++c)
  {
    result[c] = FaceCorners(cells, points.data()).geometryOfCell(c, faces).volume;
  }
  return result;
}

NearCells findNearCells(const OutputMesh& mesh, const LayeredWall& wall, int rings)
{
  return NearFinder(mesh, wall).run(rings);
}

}

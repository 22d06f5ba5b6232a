// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/NearCells.h"

#include "Quality/FaceCorners.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t RowsAChunk = 32;
constexpr std::size_t CellsAChunk = 1024;

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

  NearCells run(int rings, Execution& execution)
  {
    for (int ring = 0; ring < rings; ++ring)
    {
      addRing(execution);
    }
    near_.mayMove.assign(points_, 0);
    for (std::size_t p = 0; p < points_; ++p)
    {
      near_.mayMove[p] = near_.origin[p] != None && near_.wallNode[p] == None;
    }
    const std::size_t before = found_.size();
    addRing(execution);
    for (std::size_t i = before; i < found_.size(); ++i)
    {
      forEachPoint(found_[i], [&](std::size_t p) { near_.mayMove[p] = 0; });
    }
    for (const std::size_t p : shared_)
    {
      near_.mayMove[p] = 0;
    }
    listCells();
    return std::move(near_);
  }

private:
  template <class Visitor>
  void forEachPoint(const CellOfMesh& cell, Visitor&& visit) const
  {
    mesh_.forEachPoint(cell, [&](Id point) { visit(static_cast<std::size_t>(point)); });
  }

  std::uint32_t leastOrigin(const CellOfMesh& cell) const
  {
    std::uint32_t least = None;
    forEachPoint(cell, [&](std::size_t p) { least = std::min(least, near_.origin[p]); });
    return least;
  }

  // The cells of the region at known points, and their points.
  void addRing(Execution& execution)
  {
    const auto [first, last] = mesh_.coreRows();
    const std::size_t firstRow = first;
    std::vector<std::vector<CellOfMesh>> found(chunks(last - first, RowsAChunk));
    execution.forEach(last - first, RowsAChunk, [&](std::size_t begin, std::size_t end) {
      mesh_.forEachCellInRows(firstRow + begin, firstRow + end, [&](const CellOfMesh& cell) {
        const bool isOther =
          !isNear_[cell.place] && (isElsewhere_.empty() || !isElsewhere_[cell.place]);
        if (isOther && leastOrigin(cell) != None)
        {
          found[begin / RowsAChunk].push_back(cell);
        }
      });
    });
    std::vector<std::uint32_t> next = near_.origin;
    for (const std::vector<CellOfMesh>& cells : found)
    {
      for (const CellOfMesh& cell : cells)
      {
        isNear_[cell.place] = true;
        const std::uint32_t least = leastOrigin(cell);
        forEachPoint(cell, [&](std::size_t p) {
          next[p] = near_.origin[p] == None ? std::min(next[p], least) : next[p];
        });
      }
      found_.insert(found_.end(), cells.begin(), cells.end());
    }
    near_.origin = std::move(next);
  }

  void listCells()
  {
    std::sort(found_.begin(), found_.end(),
      [](const CellOfMesh& a, const CellOfMesh& b) { return a.place < b.place; });
    near_.cells.firstFace.assign(1, 0);
    near_.cells.firstCorner.assign(1, 0);
    near_.places.reserve(found_.size());
    for (const CellOfMesh& cell : found_)
    {
      near_.places.push_back(static_cast<Id>(cell.place));
      mesh_.addFaces(cell, near_.cells);
    }
  }

  const OutputMesh& mesh_;
  const std::vector<std::uint8_t>& isElsewhere_;
  std::vector<std::size_t>
    shared_; // points that cells of other regions have, too, and that are not on the wall
  std::vector<bool> isNear_; // of each cell, so far
  std::vector<CellOfMesh> found_;
  const std::size_t points_;
  NearCells near_;
};

}

std::vector<double> volumesOf(
  const CellFaces& cells, const std::vector<double>& points, Execution& execution)
{
  std::vector<double> result(cells.cellCount());
  execution.forEach(result.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    std::vector<FaceGeometry> faces;
    for (std::size_t c = begin; c < end; ++c)
    {
      result[c] = FaceCorners(cells, points.data()).geometryOfCell(c, faces).volume;
    }
  });
  return result;
}

NearCells findNearCells(
  const OutputMesh& mesh, const LayeredWall& wall, int rings, Execution& execution)
{
  return NearFinder(mesh, wall).run(rings, execution);
}

}

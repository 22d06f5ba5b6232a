// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/NearCells.h"

#include "Polyhedra/CellGeometry.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::array<std::array<int, 4>, 6> SidesOfHexahedron{ { { 0, 4, 7, 3 }, { 1, 2, 6, 5 },
  { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } } };

// The mesh's cells as CellArrays has them.
struct AllCells
{
  static constexpr unsigned char Hexahedron = 0;

  std::vector<Id> offsets;
  std::vector<Id> connectivity;
  std::vector<unsigned char> types;
  std::vector<Id> faceStart;
  std::vector<Id> faceStream;

  AllCells(const OutputMesh& mesh, Execution& execution)
    : offsets(static_cast<std::size_t>(mesh.cellCount() + 1))
    , connectivity(static_cast<std::size_t>(mesh.connectivitySize()))
    , types(static_cast<std::size_t>(mesh.cellCount()))
    , faceStart(types.size())
    , faceStream(static_cast<std::size_t>(mesh.faceStreamSize()))
  {
    mesh.writeCells({ offsets.data(), connectivity.data(), types.data(), faceStart.data(),
                      faceStream.data(), Hexahedron, 1 },
      execution);
  }

  std::size_t count() const { return types.size(); }

  template <class Visitor>
  void forEachPoint(std::size_t cell, Visitor&& visit) const
  {
    for (Id i = offsets[cell]; i < offsets[cell + 1]; ++i)
    {
      visit(static_cast<std::size_t>(connectivity[static_cast<std::size_t>(i)]));
    }
  }
};

class NearFinder
{
public:
  NearFinder(const OutputMesh& mesh, const LayeredWall& wall, Execution& execution)
    : all_(mesh, execution)
    , points_(static_cast<std::size_t>(mesh.pointCount()))
  {
    near_.wallNode.assign(points_, None);
    near_.origin.assign(points_, None);
    for (std::size_t n = 0; n < wall.nodes(); ++n)
    {
      if (wall.isOnWall[n])
      {
        const auto point = static_cast<std::size_t>(wall.faces.meshPoint[n]);
        near_.wallNode[point] = static_cast<std::uint32_t>(n);
        near_.origin[point] = static_cast<std::uint32_t>(n);
      }
    }
  }

  NearCells run(int rings)
  {
    std::vector<std::uint8_t> isNear(all_.count());
    for (int ring = 0; ring < rings; ++ring)
    {
      addRing(isNear);
    }
    near_.mayMove.assign(points_, 0);
    for (std::size_t p = 0; p < points_; ++p)
    {
      near_.mayMove[p] = near_.origin[p] != None && near_.wallNode[p] == None;
    }
    for (std::size_t c = 0; c < all_.count(); ++c)
    {
      if (!isNear[c])
      {
        all_.forEachPoint(c, [&](std::size_t p) { near_.mayMove[p] = 0; });
      }
    }
    addRing(isNear);
    listCells(isNear);
    return std::move(near_);
  }

private:
  // The cells at known points, and their points.
  void addRing(std::vector<std::uint8_t>& isNear)
  {
    std::vector<std::uint32_t> next = near_.origin;
    for (std::size_t c = 0; c < all_.count(); ++c)
    {
      if (isNear[c])
      {
        continue;
      }
      std::uint32_t least = None;
      all_.forEachPoint(c, [&](std::size_t p) { least = std::min(least, near_.origin[p]); });
      if (least == None)
      {
        continue;
      }
      isNear[c] = 1;
      all_.forEachPoint(c, [&](std::size_t p) {
        next[p] = near_.origin[p] == None ? std::min(next[p], least) : next[p];
      });
    }
    near_.origin = std::move(next);
  }

  void listCells(const std::vector<std::uint8_t>& isNear)
  {
    near_.cells.firstFace.assign(1, 0);
    near_.cells.firstCorner.assign(1, 0);
    for (std::size_t c = 0; c < all_.count(); ++c)
    {
      if (!isNear[c])
      {
        continue;
      }
      near_.places.push_back(static_cast<Id>(c));
      if (all_.types[c] == AllCells::Hexahedron)
      {
        addHexahedron(&all_.connectivity[static_cast<std::size_t>(all_.offsets[c])]);
      }
      else
      {
        addPolyhedron(near_.cells, &all_.faceStream[static_cast<std::size_t>(all_.faceStart[c])]);
      }
    }
  }

  void addHexahedron(const Id* corners)
  {
    CellFaces& cells = near_.cells;
    for (const auto& side : SidesOfHexahedron)
    {
      for (const int corner : side)
      {
        cells.corners.push_back(static_cast<std::uint32_t>(corners[corner]));
      }
      cells.firstCorner.push_back(cells.corners.size());
    }
    cells.firstFace.push_back(cells.faceCount());
  }

  const AllCells all_;
  const std::size_t points_;
  NearCells near_;
};

}

void addPolyhedron(CellFaces& cells, const Id* stream)
{
  for (Id left = *stream++; left > 0; --left)
  {
    const Id size = *stream++;
    for (Id i = 0; i < size; ++i)
    {
      cells.corners.push_back(static_cast<std::uint32_t>(*stream++));
    }
    cells.firstCorner.push_back(cells.corners.size());
  }
  cells.firstFace.push_back(cells.faceCount());
}

std::vector<double> volumesOf(const CellFaces& cells, const std::vector<double>& points)
{
  std::vector<double> result(cells.cellCount());
  std::vector<FaceGeometry> faces;
  for (std::size_t c = 0; c < result.size(); ++c)
  {
    faces.clear();
    for (std::size_t f = cells.firstFace[c]; f < cells.firstFace[c + 1]; ++f)
    {
      const std::uint32_t* const corners = &cells.corners[cells.firstCorner[f]];
      faces.push_back(
        measureFace(cells.firstCorner[f + 1] - cells.firstCorner[f], [&](std::size_t i) -> Vector {
          const double* const at = &points[3 * static_cast<std::size_t>(corners[i])];
          return { at[0], at[1], at[2] };
        }));
    }
    const auto face = [&](std::size_t i) -> const FaceGeometry& { return faces[i]; };
    result[c] = measureCell(faces.size(), face).volume;
  }
  return result;
}

NearCells findNearCells(
  const OutputMesh& mesh, const LayeredWall& wall, int rings, Execution& execution)
{
  return NearFinder(mesh, wall, execution).run(rings);
}

}

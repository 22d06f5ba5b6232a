// SPDX-License-Identifier: BSD-3-Clause
#include "Lifting/BoundaryLayers.h"

#include "Quality/QualityMeasures.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr int MostRounds = 12;
constexpr double Thinned = 0.5;
constexpr double LeastPart = 0.2; // thinner ones end
constexpr double Slope = 0.6;     // of parts, from node to node of a face

constexpr std::uint32_t Refused = 1U << Volume | 1U << Openness | 1U << OpenEdges |
  1U << BoundaryAngle | 1U << NonOrthogonality | 1U << Skewness;
// A cell that had less of its volume than this part hardly had any to compare with.
constexpr double LeastFormer = 1e-3;
constexpr double WrongAngle = 89.9; // InnerAngle of a face whose pyramid has no volume

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

  template <class Visitor>
  void forEachPoint(std::size_t cell, Visitor&& visit) const
  {
    for (Id i = offsets[cell]; i < offsets[cell + 1]; ++i)
    {
      visit(static_cast<std::size_t>(connectivity[static_cast<std::size_t>(i)]));
    }
  }
};

void closeFace(CellFaces& cells)
{
  cells.firstCorner.push_back(cells.corners.size());
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
    closeFace(cells);
  }
  cells.firstFace.push_back(cells.faceCount());
}

void addHexahedron(CellFaces& cells, const Id* corners)
{
  for (const auto& side : SidesOfHexahedron)
  {
    for (const int corner : side)
    {
      cells.corners.push_back(static_cast<std::uint32_t>(corners[corner]));
    }
    closeFace(cells);
  }
  cells.firstFace.push_back(cells.faceCount());
}

class StackThinner
{
public:
  StackThinner(const OutputMesh& mesh, const std::vector<double>& points,
    std::vector<double> heights, LayeredWall& wall, Execution& execution)
    : mesh_(mesh)
    , before_(points)
    , heights_(std::move(heights))
    , wall_(wall)
    , execution_(execution)
  {
  }

  BoundaryLayers run()
  {
    for (const std::size_t n : nodesWithoutLayers(wall_))
    {
      wall_.parts[n] = 0;
    }
    smooth();
    listNear();
    former_ = volumes(before_);
    findFormerFaults();
    for (int round = 0;; ++round)
    {
      result_.stacks = stackPrisms(mesh_, wall_, heights_);
      if (!lowerAtFaults() || round == MostRounds)
      {
        break;
      }
      smooth();
    }
    listChanged();
    return std::move(result_);
  }

  // Nodes of what thinner layers did not mend.
  const std::vector<std::size_t>& atFault() const { return atFault_; }

private:
  // The cells with a node on the wall, and those beside them.
  void listNear()
  {
    const AllCells all(mesh_, execution_);
    std::vector<std::uint8_t> isNear(static_cast<std::size_t>(mesh_.pointCount()));
    isWallPoint_.assign(isNear.size(), 0);
    for (std::size_t n = 0; n < wall_.isOnWall.size(); ++n)
    {
      isWallPoint_[static_cast<std::size_t>(wall_.faces.meshPoint[n])] = wall_.isOnWall[n];
    }
    for (std::size_t c = 0; c < all.types.size(); ++c)
    {
      bool near = false;
      all.forEachPoint(c, [&](std::size_t p) { near = near || isWallPoint_[p]; });
      if (near)
      {
        all.forEachPoint(c, [&](std::size_t p) { isNear[p] = 1; });
      }
    }
    near_.firstFace.assign(1, 0);
    near_.firstCorner.assign(1, 0);
    for (std::size_t c = 0; c < all.types.size(); ++c)
    {
      int points = 0;
      all.forEachPoint(c, [&](std::size_t p) { points += isNear[p]; });
      if (points < 3)
      {
        continue;
      }
      places_.push_back(static_cast<Id>(c));
      if (all.types[c] == AllCells::Hexahedron)
      {
        addHexahedron(near_, &all.connectivity[static_cast<std::size_t>(all.offsets[c])]);
      }
      else
      {
        addPolyhedron(near_, &all.faceStream[static_cast<std::size_t>(all.faceStart[c])]);
      }
    }
  }

  std::vector<double> volumes(const std::vector<double>& points) const
  {
    std::vector<double> result(places_.size());
    std::vector<FaceGeometry> faces;
    for (std::size_t c = 0; c < result.size(); ++c)
    {
      faces.clear();
      for (std::size_t f = near_.firstFace[c]; f < near_.firstFace[c + 1]; ++f)
      {
        faces.push_back(measureFace(
          near_.firstCorner[f + 1] - near_.firstCorner[f], [&](std::size_t i) -> Vector {
            const double* const at =
              &points[3 * std::size_t(near_.corners[near_.firstCorner[f] + i])];
            return { at[0], at[1], at[2] };
          }));
      }
      result[c] = measureCell(faces.size(), [&](std::size_t i) -> const FaceGeometry& {
        return faces[i];
      }).volume;
    }
    return result;
  }

  std::vector<double> pointsNow() const
  {
    std::vector<double> points = before_;
    for (const MovedPoint& moved : result_.stacks.moved)
    {
      std::copy(moved.to.begin(), moved.to.end(), points.begin() + 3 * std::ptrdiff_t(moved.point));
    }
    points.insert(points.end(), result_.stacks.points.begin(), result_.stacks.points.end());
    return points;
  }

  static bool isAtFault(const Quality& quality, std::size_t f)
  {
    return (quality.faceFailures[f] & Refused) != 0 || !(quality.faces[InnerAngle][f] < WrongAngle);
  }

  // Of the mesh without layers.
  void findFormerFaults()
  {
    const FaceList list = listFaces(near_, before_.size() / 3, Clashes::AreBoundary, execution_);
    const Quality quality = measureQuality(before_.data(), near_, list, execution_);
    wasAtFault_.assign(near_.faceCount(), 0);
    for (std::size_t f = 0; f < list.face.size(); ++f)
    {
      wasAtFault_[list.face[f]] = isAtFault(quality, f);
    }
  }

  // Whether any part is lower than it was.
  bool lowerAtFaults()
  {
    CellFaces cells = near_;
    for (const Id start : result_.stacks.faceStart)
    {
      addPolyhedron(cells, &result_.stacks.faceStream[static_cast<std::size_t>(start)]);
    }
    const std::vector<double> points = pointsNow();
    const FaceList list = listFaces(cells, points.size() / 3, Clashes::AreBoundary, execution_);
    const Quality quality = measureQuality(points.data(), cells, list, execution_);
    next_ = wall_.parts;
    atFault_.clear();
    for (std::size_t f = 0; f < list.face.size(); ++f)
    {
      if (isAtFault(quality, f))
      {
        const bool isInner = f < list.neighbour.size();
        const bool isOfMesh =
          list.owner[f] < places_.size() && !(isInner && list.neighbour[f] >= places_.size());
        if (isOfMesh && (wasAtFault_[list.face[f]] || !hasMoved(cells, list.face[f])))
        {
          continue;
        }
        lowerAtFace(cells, list.face[f],
          isInner && isBetweenStacks(list.owner[f], list.neighbour[f]) ? 0 : Thinned);
      }
    }
    for (std::size_t c = 0; c < cells.cellCount(); ++c)
    {
      constexpr std::uint32_t OfCells = 1U << Volume | 1U << Openness | 1U << OpenEdges;
      for (std::size_t f = cells.firstFace[c];
           (quality.cellFailures[c] & OfCells) != 0 && f < cells.firstFace[c + 1]; ++f)
      {
        lowerAtFace(cells, f, Thinned);
      }
    }
    const bool lowered = next_ != wall_.parts;
    wall_.parts = std::move(next_);
    return lowered;
  }

  bool isBetweenStacks(std::uint32_t c, std::uint32_t d) const
  {
    const std::size_t layers = heights_.size() - 1;
    const std::size_t count = places_.size();
    return c >= count && d >= count && (c - count) / layers != (d - count) / layers;
  }

  // Of an own face of a cell of the mesh, or one towards layers.
  bool hasMoved(const CellFaces& cells, std::size_t f) const
  {
    bool moved = false;
    for (std::size_t i = cells.firstCorner[f]; i < cells.firstCorner[f + 1]; ++i)
    {
      const std::size_t n = nodeOf(cells.corners[i]);
      moved = moved || (n != None && (wall_.parts[n] > 0 || wall_.displaced[n] != wall_.onWall[n]));
    }
    return moved;
  }

  void lowerAtFace(const CellFaces& cells, std::size_t f, double factor)
  {
    for (std::size_t i = cells.firstCorner[f]; i < cells.firstCorner[f + 1]; ++i)
    {
      const std::uint32_t point = cells.corners[i];
      const std::size_t n = nodeOf(point);
      if (n == None)
      {
        continue;
      }
      atFault_.push_back(n);
      const double part = factor * wall_.parts[n];
      next_[n] = std::min(next_[n], part < LeastPart ? 0 : part);
    }
  }

  // The wall's node at or below a point, or None.
  std::size_t nodeOf(std::uint32_t point) const
  {
    if (point >= mesh_.pointCount())
    {
      return result_.stacks.nodeOfPoint[point - static_cast<std::size_t>(mesh_.pointCount())];
    }
    if (!isWallPoint_[point])
    {
      return None;
    }
    const auto& all = wall_.faces.meshPoint;
    return static_cast<std::size_t>(
      std::lower_bound(all.begin(), all.end(), Id(point)) - all.begin());
  }

  // Until no part is higher than the slope allows: the same whatever the order.
  void smooth()
  {
    for (bool changed = true; changed;)
    {
      changed = false;
      for (std::size_t f = 0; f < wall_.layered.size(); ++f)
      {
        double least = 1;
        for (std::size_t i = 0; wall_.layered[f] && i < wall_.corners(f); ++i)
        {
          least = std::min(least, wall_.parts[wall_.node(f, i)]);
        }
        for (std::size_t i = 0; least + Slope < 1 && i < wall_.corners(f); ++i)
        {
          double& part = wall_.parts[wall_.node(f, i)];
          changed = changed || part > least + Slope;
          part = std::min(part, least + Slope);
        }
      }
    }
  }

  void listChanged()
  {
    const std::vector<double> now = volumes(pointsNow());
    for (std::size_t c = 0; c < now.size(); ++c)
    {
      if (now[c] != former_[c] && former_[c] > LeastFormer * now[c])
      {
        result_.changed.push_back({ places_[c], now[c] / former_[c] });
      }
    }
  }

  const OutputMesh& mesh_;
  const std::vector<double>& before_; // points of the mesh
  const std::vector<double> heights_;
  LayeredWall& wall_;
  Execution& execution_;
  std::vector<std::uint8_t> isWallPoint_; // of the mesh's points
  CellFaces near_;
  std::vector<Id> places_;               // of the near cells in the mesh
  std::vector<double> former_;           // their volumes
  std::vector<std::uint8_t> wasAtFault_; // of their faces, before there were layers
  std::vector<double> next_;             // parts
  std::vector<std::size_t> atFault_;     // nodes
  BoundaryLayers result_;
};

}

BoundaryLayers addLayers(
  const OutputMesh& mesh, const Lattice& lattice, const WallLift& lift, Execution& execution)
{
  std::vector<double> points(3 * static_cast<std::size_t>(mesh.pointCount()));
  mesh.writePoints(points.data(), execution);
  LayeredWall wall = findLayeredWall(mesh, points, lattice, lift, execution);
  StackThinner thinner(mesh, points, heightsOfLayers(lift.displacement().spec), wall, execution);
  BoundaryLayers layers = thinner.run();
  layers.spec = lift.displacement().spec;
  layers.thickness = lift.displacement().thickness * lattice.step();
  for (const std::size_t n : thinner.atFault())
  {
    layers.faults.push_back(
      lift.triangleAt(scaled(minus(wall.displaced[n], lattice.origin()), 1 / lattice.step())));
  }
  std::sort(layers.faults.begin(), layers.faults.end());
  layers.faults.erase(std::unique(layers.faults.begin(), layers.faults.end()), layers.faults.end());
  return layers;
}

}

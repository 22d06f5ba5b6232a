// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/BoundaryLayers.h"

#include "Layers/NodeMotion.h"
#include "Quality/QualityMeasures.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr int Rings = 4; // of cells whose points follow
constexpr int MostRounds = 40;
constexpr double Thinned = 0.5;
constexpr double LeastPart = 0.2; // thinner ones end
constexpr double Slope = 0.6;     // of parts, from node to node of a face

constexpr std::uint32_t OfCells = 1U << Volume | 1U << Openness | 1U << OpenEdges;
constexpr std::uint32_t OfFaces =
  1U << BoundaryAngle | 1U << NonOrthogonality | 1U << Skewness;
// A cell that had less of its volume than this part hardly had any to compare with.
constexpr double LeastFormer = 1e-3;
constexpr double WrongAngle = 89.9; // InnerAngle of a face whose pyramid has no volume

class LayerMaker
{
public:
  LayerMaker(const OutputMesh& mesh, const std::vector<double>& points,
    std::vector<double> heights, LayeredWall& wall, Execution& execution)
    : mesh_(mesh)
    , before_(points)
    , heights_(std::move(heights))
    , wall_(wall)
    , execution_(execution)
    , near_(findNearCells(mesh, wall, Rings, execution))
    , motion_(near_, wall, points)
  {
  }

  BoundaryLayers run()
  {
    for (const std::size_t n : nodesWithoutLayers(wall_))
    {
      wall_.parts[n] = 0;
    }
    smooth();
    findFormerFaults();
    for (int round = 0;; ++round)
    {
      stack();
      if (!lowerAtFaults(round) || round == MostRounds)
      {
        break;
      }
      smooth();
    }
    listChanged();
    return std::move(result_);
  }

private:
  void stack()
  {
    result_.stacks = stackPrisms(mesh_, wall_, heights_);
    motion_.run(wall_);
    for (std::size_t i = 0; i < motion_.moving().size(); ++i)
    {
      const std::uint32_t p = motion_.moving()[i];
      if (const Vector& way = motion_.ways()[i]; way != Vector{})
      {
        const double* const at = &before_[3 * std::size_t(p)];
        result_.stacks.moved.push_back({ Id(p), plus(Vector{ at[0], at[1], at[2] }, way) });
      }
    }
  }

  std::vector<double> volumes(const std::vector<double>& points) const
  {
    const CellFaces& cells = near_.cells;
    std::vector<double> result(near_.places.size());
    std::vector<FaceGeometry> faces;
    for (std::size_t c = 0; c < result.size(); ++c)
    {
      faces.clear();
      for (std::size_t f = cells.firstFace[c]; f < cells.firstFace[c + 1]; ++f)
      {
        faces.push_back(measureFace(
          cells.firstCorner[f + 1] - cells.firstCorner[f], [&](std::size_t i) -> Vector {
            const double* const at =
              &points[3 * std::size_t(cells.corners[cells.firstCorner[f] + i])];
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
    return (quality.faceFailures[f] & OfFaces) != 0 || !(quality.faces[InnerAngle][f] < WrongAngle);
  }

  // Of the mesh without layers.
  void findFormerFaults()
  {
    const CellFaces& cells = near_.cells;
    const FaceList list = listFaces(cells, before_.size() / 3, Clashes::AreBoundary, execution_);
    const Quality quality = measureQuality(before_.data(), cells, list, execution_);
    wasAtFault_.assign(cells.faceCount(), 0);
    for (std::size_t f = 0; f < list.face.size(); ++f)
    {
      wasAtFault_[list.face[f]] = isAtFault(quality, f);
    }
    cellWasAtFault_.assign(cells.cellCount(), 0);
    for (std::size_t c = 0; c < cells.cellCount(); ++c)
    {
      cellWasAtFault_[c] = (quality.cellFailures[c] & OfCells) != 0;
    }
  }

  // Whether any part is lower than it was.
  bool lowerAtFaults(int round)
  {
    CellFaces cells = near_.cells;
    for (const Id start : result_.stacks.faceStart)
    {
      addPolyhedron(cells, &result_.stacks.faceStream[static_cast<std::size_t>(start)]);
    }
    const std::vector<double> points = pointsNow();
    const FaceList list = listFaces(cells, points.size() / 3, Clashes::AreBoundary, execution_);
    const Quality quality = measureQuality(points.data(), cells, list, execution_);
    next_ = wall_.parts;
    std::size_t inMesh = 0, between = 0, inStack = 0, ofCell = 0;
    for (std::size_t f = 0; f < list.face.size(); ++f)
    {
      if (!isAtFault(quality, f))
      {
        continue;
      }
      const bool isInner = f < list.neighbour.size();
      const std::size_t count = near_.places.size();
      const bool isOfMesh =
        list.owner[f] < count && !(isInner && list.neighbour[f] >= count);
      if (isOfMesh && wasAtFault_[list.face[f]])
      {
        continue;
      }
      const bool isBetween = isInner && isBetweenStacks(list.owner[f], list.neighbour[f]);
      ++(isOfMesh ? inMesh : isBetween ? between : inStack);
      lowerAtFace(cells, list.face[f], isBetween ? 0 : Thinned);
    }
    for (std::size_t c = 0; c < cells.cellCount(); ++c)
    {
      if ((quality.cellFailures[c] & OfCells) == 0 ||
        (c < cellWasAtFault_.size() && cellWasAtFault_[c]))
      {
        continue;
      }
      ++ofCell;
      for (std::size_t f = cells.firstFace[c]; f < cells.firstFace[c + 1]; ++f)
      {
        lowerAtFace(cells, f, Thinned);
      }
    }
    if (getenv("LAYDBG"))
      fprintf(stderr, "round %d: mesh %zu between %zu stack %zu cells %zu\n", round, inMesh, between, inStack, ofCell);
    const bool lowered = next_ != wall_.parts;
    wall_.parts = std::move(next_);
    return lowered;
  }

  bool isBetweenStacks(std::uint32_t c, std::uint32_t d) const
  {
    const std::size_t layers = heights_.size() - 1;
    const std::size_t count = near_.places.size();
    return c >= count && d >= count && (c - count) / layers != (d - count) / layers;
  }

  void lowerAtFace(const CellFaces& cells, std::size_t f, double factor)
  {
    for (std::size_t i = cells.firstCorner[f]; i < cells.firstCorner[f + 1]; ++i)
    {
      const std::size_t n = nodeOf(cells.corners[i]);
      if (n == None)
      {
        continue;
      }
      const double part = factor * wall_.parts[n];
      next_[n] = std::min(next_[n], part < LeastPart ? 0 : part);
    }
  }

  // The wall's node at, below or nearest to a point, or None.
  std::size_t nodeOf(std::uint32_t point) const
  {
    return point >= near_.origin.size() ? result_.stacks.nodeOfPoint[point - near_.origin.size()]
                                        : near_.origin[point];
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
    const std::vector<double> former = volumes(before_);
    const std::vector<double> now = volumes(pointsNow());
    for (std::size_t c = 0; c < now.size(); ++c)
    {
      if (now[c] != former[c] && former[c] > LeastFormer * now[c])
      {
        result_.changed.push_back({ near_.places[c], now[c] / former[c] });
      }
    }
  }

  const OutputMesh& mesh_;
  const std::vector<double>& before_; // points of the mesh
  const std::vector<double> heights_;
  LayeredWall& wall_;
  Execution& execution_;
  const NearCells near_;
  NodeMotion motion_;
  std::vector<std::uint8_t> wasAtFault_; // of their faces, before there were layers
  std::vector<std::uint8_t> cellWasAtFault_;
  std::vector<double> next_; // parts
  BoundaryLayers result_;
};

}

BoundaryLayers addLayers(const OutputMesh& mesh, const Surface& surface, const WallLayerSpec& spec,
  double thickness, Execution& execution)
{
  std::vector<double> points(3 * static_cast<std::size_t>(mesh.pointCount()));
  mesh.writePoints(points.data(), execution);
  LayeredWall wall = findLayeredWall(mesh, points, spec, thickness, execution);
  keepFromOpposite(wall, surface, execution);
  BoundaryLayers layers =
    LayerMaker(mesh, points, heightsOfLayers(spec), wall, execution).run();
  layers.spec = spec;
  layers.thickness = thickness;
  return layers;
}

}

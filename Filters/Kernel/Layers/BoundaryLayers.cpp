// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/BoundaryLayers.h"

#include "Layers/NodeMotion.h"
#include "Quality/QualityMeasures.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr int Rings = 4; // of cells whose points follow the wall
constexpr double Thinned = 0.5;
constexpr int ThinningRounds = 20; // afterwards layers at fault end at once
constexpr double LeastPart = 0.2;  // thinner ones end
constexpr double Slope = 0.8; // of parts, from node to node of a face: layers end over two columns

constexpr std::uint32_t OfCells = 1U << Volume | 1U << Openness | 1U << OpenEdges;
constexpr std::uint32_t OfFaces = 1U << BoundaryAngle | 1U << NonOrthogonality | 1U << Skewness;
constexpr double WrongAngle = 89.9; // InnerAngle of a face whose pyramid has no volume

// A cell that had less of its volume than this part hardly had any to compare with.
constexpr double LeastFormer = 1e-3;

class LayerMaker
{
public:
  LayerMaker(const OutputMesh& mesh, const std::vector<double>& points, std::vector<double> heights,
    LayeredWall& wall, Execution& execution)
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
    former_ = faultsOf(near_.cells, before_);
    for (int round = 0;; ++round)
    {
      execution_.reach(1 - 1 / (1 + 0.3 * double(round)));
      smooth();
      stack();
      if (!lowerAtFaults(round < ThinningRounds ? Thinned : 0))
      {
        break;
      }
    }
    listChanged();
    return std::move(result_);
  }

private:
  // What solvers refuse.
  struct Faults
  {
    FaceList list;
    std::vector<std::uint8_t> face; // of each face of the cells, as its owner has it
    std::vector<std::uint8_t> cell;
    std::vector<std::uint8_t>
      isLong; // cells of which only the aspect ratio is at fault: thinner is no better
  };

  Faults faultsOf(const CellFaces& cells, const std::vector<double>& points) const
  {
    Faults faults;
    faults.list = listFaces(cells, points.size() / 3, Clashes::AreBoundary, execution_);
    const Quality quality = measureQuality(points.data(), cells, faults.list, execution_);
    faults.face.resize(cells.faceCount());
    for (std::size_t f = 0; f < faults.list.face.size(); ++f)
    {
      faults.face[faults.list.face[f]] =
        (quality.faceFailures[f] & OfFaces) != 0 || !(quality.faces[InnerAngle][f] < WrongAngle);
    }
    for (const std::uint32_t failures : quality.cellFailures)
    {
      faults.cell.push_back((failures & OfCells) != 0);
      faults.isLong.push_back((failures & 1U << AspectRatio) != 0);
    }
    return faults;
  }

  void stack()
  {
    result_.stacks = stackPrisms(mesh_, wall_, heights_);
    motion_.run();
    for (std::size_t i = 0; i < motion_.moving().size(); ++i)
    {
      const Id p = motion_.moving()[i];
      if (const Vector& way = motion_.way(i); way != Vector{})
      {
        const double* const at = &before_[3 * static_cast<std::size_t>(p)];
        result_.stacks.moved.push_back({ p, plus(Vector{ at[0], at[1], at[2] }, way) });
      }
    }
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

  // Whether any part is lower than it was.
  bool lowerAtFaults(double factor)
  {
    CellFaces cells = near_.cells;
    for (const Id start : result_.stacks.faceStart)
    {
      addPolyhedron(cells, &result_.stacks.faceStream[static_cast<std::size_t>(start)]);
    }
    const Faults faults = faultsOf(cells, pointsNow());
    next_ = wall_.parts;
    isStuck_.assign(wall_.nodes(), 0);
    for (std::size_t f = 0; f < faults.list.face.size(); ++f)
    {
      lowerAtListed(cells, faults, f, factor);
    }
    for (std::size_t c = 0; c < cells.cellCount(); ++c)
    {
      const bool isOfMesh = c < near_.places.size();
      const bool isNew = faults.cell[c] && !(isOfMesh && former_.cell[c]);
      const bool isLong = faults.isLong[c] && !(isOfMesh && former_.isLong[c]);
      for (std::size_t f = cells.firstFace[c]; (isNew || isLong) && f < cells.firstFace[c + 1]; ++f)
      {
        lowerAtFace(cells, f, isNew ? factor : 0);
      }
    }
    lowerAroundStuck(factor);
    const bool lowered = next_ != wall_.parts;
    wall_.parts = std::move(next_);
    return lowered;
  }

  // A face that was at fault before there were layers may be so.
  void lowerAtListed(const CellFaces& cells, const Faults& faults, std::size_t f, double factor)
  {
    const std::uint32_t face = faults.list.face[f];
    const std::uint32_t owner = faults.list.owner[f];
    const bool isInner = f < faults.list.neighbour.size();
    const std::uint32_t other = isInner ? faults.list.neighbour[f] : owner;
    const bool isOfMesh = std::max(owner, other) < near_.places.size();
    if (faults.face[face] && !(isOfMesh && former_.face[face]))
    {
      lowerAtFace(cells, face, isBetweenStacks(owner, other) ? 0 : factor);
    }
  }

  bool isBetweenStacks(std::uint32_t c, std::uint32_t d) const
  {
    const std::size_t layers = heights_.size() - 1;
    const std::size_t count = near_.places.size();
    return c >= count && d >= count && (c - count) / layers != (d - count) / layers;
  }

  void lowerAtFace(const CellFaces& cells, std::size_t f, double factor)
  {
    bool any = false;
    for (std::size_t i = cells.firstCorner[f]; i < cells.firstCorner[f + 1]; ++i)
    {
      const std::size_t n = nodeOf(cells.corners[i]);
      any = (n != None && lower(n, factor)) || any;
    }
    for (std::size_t i = cells.firstCorner[f]; !any && i < cells.firstCorner[f + 1]; ++i)
    {
      if (const std::size_t n = nodeOf(cells.corners[i]); n != None)
      {
        isStuck_[n] = 1;
      }
    }
  }

  bool lower(std::size_t n, double factor)
  {
    const double part = factor * wall_.parts[n];
    next_[n] = std::min(next_[n], part < LeastPart ? 0 : part);
    return wall_.parts[n] > 0;
  }

  // What is at fault where no layers are, comes from those that are nearest.
  void lowerAroundStuck(double factor)
  {
    for (bool grows = std::find(isStuck_.begin(), isStuck_.end(), 1) != isStuck_.end(); grows;)
    {
      grows = false;
      bool lowered = false;
      const std::vector<std::uint8_t> stuck = isStuck_;
      for (std::size_t f = 0; f < wall_.layered.size(); ++f)
      {
        bool any = false;
        for (std::size_t i = 0; i < wall_.corners(f); ++i)
        {
          any = any || stuck[wall_.node(f, i)];
        }
        for (std::size_t i = 0; any && i < wall_.corners(f); ++i)
        {
          const std::size_t n = wall_.node(f, i);
          lowered = lower(n, factor) || lowered;
          grows = grows || !isStuck_[n];
          isStuck_[n] = 1;
        }
      }
      grows = grows && !lowered;
    }
  }

  // The wall's node at, below or nearest to a point, or None.
  std::size_t nodeOf(std::uint32_t point) const
  {
    return point < near_.origin.size() ? near_.origin[point]
                                       : result_.stacks.nodeOfPoint[point - near_.origin.size()];
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
    const std::vector<double> former = volumesOf(near_.cells, before_);
    const std::vector<double> now = volumesOf(near_.cells, pointsNow());
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
  Faults former_;                     // of the near cells, before there were layers
  std::vector<double> next_;          // parts
  std::vector<std::uint8_t> isStuck_; // nodes near faults, none of which has layers
  BoundaryLayers result_;
};

}

BoundaryLayers addLayers(const OutputMesh& mesh, const Surface& surface, const WallLayerSpec& spec,
  double thickness, Execution& execution)
{
  std::vector<double> points(3 * static_cast<std::size_t>(mesh.pointCount()));
  mesh.writePoints(points.data(), execution);
  LayeredWall wall = findLayeredWall(mesh, points, spec, thickness, execution);
  spreadWays(wall, thickness);
  keepFromOpposite(wall, surface, execution);
  BoundaryLayers layers = LayerMaker(mesh, points, heightsOfLayers(spec), wall, execution).run();
  layers.spec = spec;
  layers.thickness = thickness;
  return layers;
}

}

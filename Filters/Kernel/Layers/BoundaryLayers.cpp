// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/BoundaryLayers.h"

#include "Layers/LastLayers.h"
#include "Layers/LayerFaults.h"
#include "Layers/LayerNumbers.h"
#include "Layers/NodeMotion.h"

#include <algorithm>
#include <optional>

namespace cartesian
{

namespace
{

constexpr int Rings = 4;           // of cells whose points follow the wall
constexpr double LeastMove = 1e-3; // of the longest way: others change no measure much
constexpr double Thinned = 0.72;
constexpr int ThinningRounds = 20; // afterwards layers at fault end at once
constexpr double LeastPart = 0.2;  // thinner ones end
constexpr double LeastOfAsked =
  0.12; // of the thickness of a stack: on thinner ones solvers diverge
constexpr double Slope =
  0.8; // of parts, from node to node of a face, unless it is flat: layers end over two columns

// A cell that had less of its volume than this part hardly had any to compare with.
constexpr double LeastFormer = 1e-3;
class LayerMaker
{
public:
  LayerMaker(const OutputMesh& mesh, const std::vector<double>& points, LayerHeights heights,
    LayeredWall& wall, const FlowDomainSides& sides, Execution& execution)
    : mesh_(mesh)
    , before_(points)
    , heights_(std::move(heights))
    , wall_(wall)
    , sides_(sides)
    , execution_(execution)
    , near_(findNearCells(mesh, wall, Rings))
    , motion_(near_, wall, points)
    , faults_(near_, points, execution)
    , longestWay_(longestWay(wall))
  {
  }

  BoundaryLayers run()
  {
    // At last all is measured, as what hardly moves was left out.
    bool all = true;
    for (int round = 0;; ++round)
    {
      execution_.reach(1 - 1 / (1 + 0.3 * double(round)));
      smooth();
      stack();
      const bool changed = mendFaults(all, round < ThinningRounds ? Thinned : 0);
      if (!changed && (all || round == 0))
      {
        break;
      }
      all = !changed;
    }
    const std::vector<double> volumes = volumesOf(near_.cells, pointsNow());
    result_.boundary =
      boundaryOf(mesh_, wall_, heights_, lastByCells(wall_, heights_, near_, volumes));
    listChanged(volumes);
    result_.copies = shareNodes(mesh_, wall_, result_.stacks, result_.boundary);
    return std::move(result_);
  }

private:
  void stack()
  {
    result_.stacks = stackPrisms(mesh_, wall_, heights_);
    motion_.run(execution_);
    for (std::size_t i = 0; i < motion_.moving().size(); ++i)
    {
      const Id p = motion_.moving()[i];
      if (const Vector& way = motion_.way(i); way != Vector{})
      {
        const double* const at = &before_[3 * static_cast<std::size_t>(p)];
        const Vector from{ at[0], at[1], at[2] };
        result_.stacks.moved.push_back({ p, plus(from, sides_.within(from, way)) });
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

  static double longestWay(const LayeredWall& wall)
  {
    double longest = 0;
    for (const Vector& way : wall.way)
    {
      longest = std::max(longest, norm(way));
    }
    return longest;
  }

  // From where a point was when it was measured last.
  double moveOf(const std::vector<double>& points, std::size_t p) const
  {
    const double* const from = &measured_.points[3 * p];
    const double* const to = &points[3 * p];
    return norm(Vector{ to[0] - from[0], to[1] - from[1], to[2] - from[2] });
  }

  // Since they were measured last; of the stacks those above nodes whose part is another.
  std::vector<std::uint8_t> listMoved(const std::vector<double>& points, bool all) const
  {
    const std::size_t ofMesh = before_.size() / 3;
    std::vector<std::uint8_t> hasMoved(points.size() / 3, all);
    const double least = LeastMove * longestWay_;
    for (std::size_t p = 0; !all && p < hasMoved.size(); ++p)
    {
      const std::size_t n = p < ofMesh ? None : result_.stacks.nodeOfPoint[p - ofMesh];
      hasMoved[p] = n != None ? wall_.parts[n] != measured_.parts[n] : moveOf(points, p) > least;
    }
    return hasMoved;
  }

  // Whether there are any; the remedy.
  bool mendFaults(bool all, double factor)
  {
    std::vector<double> points = pointsNow();
    const std::vector<LayerFault> found =
      faults_.find(result_.stacks, points, listMoved(points, all), execution_);
    measured_ = { std::move(points), wall_.parts };
    next_ = wall_.parts;
    bool changed = false;
    for (const LayerFault& fault : found)
    {
      changed = hold(fault) || lower(fault.points, fault.mendsThinner ? factor : 0) ||
        leaveAlone(fault) || changed;
    }
    wall_.parts = std::move(next_);
    return changed;
  }

  // The points of cells inside the mesh stay where they were.
  bool hold(const LayerFault& fault)
  {
    const bool isAtWall = std::any_of(fault.around.begin(), fault.around.end(),
      [&](std::uint32_t point) { return near_.wallNode[point] != None; });
    bool changed = false;
    for (const std::uint32_t point : fault.around)
    {
      changed = (!isAtWall && motion_.hold(point)) || changed;
    }
    return changed;
  }

  // The parts of nodes at, below or nearest to these points.
  bool lower(const std::vector<std::uint32_t>& points, double factor)
  {
    bool changed = false;
    for (const std::uint32_t point : points)
    {
      const std::size_t ofMesh = near_.origin.size();
      const std::size_t n =
        point < ofMesh ? near_.origin[point] : result_.stacks.nodeOfPoint[point - ofMesh];
      if (n != None && wall_.parts[n] > 0)
      {
        const double part = factor * wall_.parts[n];
        next_[n] = std::min(next_[n], part < LeastPart ? 0 : part);
        wall_.ends[n] = LayerEnd::Fault;
        changed = true;
      }
    }
    return changed;
  }

  // Removes the layers at the fault: its cells are then as before.
  bool leaveAlone(const LayerFault& fault)
  {
    bool changed = lower(fault.around, 0);
    for (const std::uint32_t point : fault.around)
    {
      changed = motion_.hold(point) || changed;
    }
    return changed;
  }

  // Where a stack would be a film it has none.
  bool leaveOutFilms()
  {
    bool changed = false;
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      if (wall_.hasStack(f) && wall_.thickness(f) < LeastOfAsked * wall_.asked[f])
      {
        for (std::size_t i = 0; i < wall_.corners(f); ++i)
        {
          wall_.parts[wall_.node(f, i)] = 0;
        }
        changed = true;
      }
    }
    return changed;
  }

  // Stacks taper off next to stacks that do not: without any of these there are no layers.
  bool leaveOutIslands()
  {
    std::vector<std::uint8_t> isKept(wall_.nodes());
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      const bool isFull = wall_.hasStack(f) && !wall_.tapers(f);
      for (std::size_t i = 0; isFull && i < wall_.corners(f); ++i)
      {
        isKept[wall_.node(f, i)] = 1;
      }
    }
    bool changed = false;
    for (std::size_t n = 0; n < wall_.nodes(); ++n)
    {
      changed = changed || (wall_.parts[n] > 0 && !isKept[n]);
      wall_.parts[n] = isKept[n] ? wall_.parts[n] : 0;
    }
    return changed;
  }

  // What layers take that fit.
  bool fitLayers()
  {
    bool changed = false;
    for (std::size_t n = 0; n < wall_.nodes(); ++n)
    {
      const double fitting = heights_.fitting(wall_.parts[n], wall_.isFlat[n] != 0);
      changed = changed || fitting != wall_.parts[n];
      wall_.parts[n] = fitting;
    }
    return changed;
  }

  // Until no part is higher than the slope allows: the same whatever the order.
  void smooth()
  {
    for (bool changed = true; changed;)
    {
      changed = leaveOutFilms();
      changed = leaveOutIslands() || changed;
      changed = fitLayers() || changed;
      for (std::size_t f = 0; f < wall_.layered.size(); ++f)
      {
        const double slope = wall_.isFlatFace(f) ? 1 : Slope;
        double least = 1;
        for (std::size_t i = 0; wall_.layered[f] && i < wall_.corners(f); ++i)
        {
          least = std::min(least, wall_.parts[wall_.node(f, i)]);
        }
        for (std::size_t i = 0; least + slope < 1 && i < wall_.corners(f); ++i)
        {
          double& part = wall_.parts[wall_.node(f, i)];
          changed = changed || part > least + slope;
          part = std::min(part, least + slope);
        }
      }
    }
  }

  void listChanged(const std::vector<double>& now)
  {
    const std::vector<double> former = volumesOf(near_.cells, before_);
    for (std::size_t c = 0; c < now.size(); ++c)
    {
      if (now[c] != former[c] && former[c] > LeastFormer * now[c])
      {
        result_.changed.push_back({ near_.places[c], now[c] / former[c] });
      }
    }
  }

  // As they were when faults were looked for last.
  struct Measured
  {
    std::vector<double> points;
    std::vector<double> parts; // of the wall
  };

  const OutputMesh& mesh_;
  const std::vector<double>& before_; // points of the mesh
  const LayerHeights heights_;
  LayeredWall& wall_;
  const FlowDomainSides& sides_;
  Execution& execution_;
  const NearCells near_;
  NodeMotion motion_;
  const LayerFaults faults_;
  const double longestWay_;
  Measured measured_;
  std::vector<double> next_; // parts
  BoundaryLayers result_;
};

void append(const OutputMesh& mesh, BoundaryLayers& layers, BoundaryLayers more)
{
  for (PointCopy& copy : more.copies)
  {
    copy.copy += static_cast<Id>(layers.stacks.nodeOfPoint.size());
    layers.copies.push_back(copy);
  }
  append(mesh, layers.stacks, layers.boundary, more.boundary);
  append(mesh, layers.stacks, more.stacks);
  layers.changed.insert(layers.changed.end(), more.changed.begin(), more.changed.end());
}

}

BoundaryLayers addLayers(
  const OutputMesh& mesh, const Surface& surface, const WallLayerSpec& spec, Execution& execution)
{
  std::vector<double> points(3 * static_cast<std::size_t>(mesh.pointCount()));
  mesh.writePoints(points.data(), execution);
  const FlowDomainSides sides(mesh.boxes(), surface);
  std::optional<BoundaryLayers> layers;
  for (LayerRegion& region : layerRegions(mesh, surface.walls, execution))
  {
    LayeredWall wall = findLayeredWall(std::move(region), mesh, points, spec, execution);
    spreadWays(wall, execution);
    keepFromOpposite(wall, surface, sides, execution);
    BoundaryLayers more =
      LayerMaker(mesh, points, LayerHeights(spec), wall, sides, execution).run();
    if (layers)
    {
      append(mesh, *layers, std::move(more));
    }
    else
    {
      layers = std::move(more);
    }
  }
  layers->numbers = numbersWithLayers(mesh, layers->stacks);
  renumber(layers->boundary, layers->numbers);
  layers->spec = spec;
  return std::move(*layers);
}

}

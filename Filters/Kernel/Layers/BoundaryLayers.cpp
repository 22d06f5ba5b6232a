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
    , near_(findNearCells(mesh, wall, Rings, execution))
    , motion_(near_, wall, points, execution)
    , faults_(near_, points, execution)
    , longestWay_(longestWay(wall))
    , points_(points)
  {
  }

  BoundaryLayers run()
  {
    // First all is measured, then what moved by more than this; at last whatever moved.
    std::optional<double> least;
    for (int round = 0;; ++round)
    {
      execution_.reach(1 - 1 / (1 + 0.3 * double(round)));
      smooth();
      move();
      const bool changed = mendFaults(least, round < ThinningRounds ? Thinned : 0);
      if (!changed && least.value_or(0) == 0)
      {
        break;
      }
      least = changed ? LeastMove * longestWay_ : 0;
    }
    result_.stacks = stackPrisms(mesh_, wall_, heights_, {}, execution_);
    const std::vector<double> volumes = volumesOf(near_.cells, points_, execution_);
    result_.boundary = boundaryOf(
      mesh_, wall_, heights_, lastByCells(wall_, heights_, near_, volumes, execution_), execution_);
    listChanged(volumes);
    result_.stacks.moved = std::move(moved_);
    result_.copies = shareNodes(mesh_, wall_, result_.stacks, result_.boundary);
    return std::move(result_);
  }

private:
  // The mesh's points.
  void move()
  {
    motion_.run(execution_);
    moved_.clear();
    const auto place = [&](Id point, const Vector& to) {
      moved_.push_back({ point, to });
      std::copy(to.begin(), to.end(), points_.begin() + 3 * std::ptrdiff_t(point));
    };
    std::copy(before_.begin(), before_.end(), points_.begin());
    for (std::size_t n = 0; n < wall_.nodes(); ++n)
    {
      if (wall_.parts[n] > 0)
      {
        place(wall_.of.mesh.meshPoint[n], wall_.at(n, wall_.parts[n]));
      }
    }
    for (std::size_t i = 0; i < motion_.moving().size(); ++i)
    {
      const Id p = motion_.moving()[i];
      if (const Vector& way = motion_.way(i); way != Vector{})
      {
        const double* const at = &before_[3 * static_cast<std::size_t>(p)];
        const Vector from{ at[0], at[1], at[2] };
        place(p, plus(from, sides_.within(from, way)));
      }
    }
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

  // Of each of the mesh's points: whether it has moved by more since it was measured last.
  std::vector<std::uint8_t> movedBy(double least) const
  {
    std::vector<std::uint8_t> hasMoved(points_.size() / 3);
    for (std::size_t p = 0; p < hasMoved.size(); ++p)
    {
      const double* const from = &measured_.points[3 * p];
      const double* const to = &points_[3 * p];
      hasMoved[p] = norm(Vector{ to[0] - from[0], to[1] - from[1], to[2] - from[2] }) > least;
    }
    return hasMoved;
  }

  // Also all other nodes of faces with one of these.
  std::vector<std::uint8_t> grown(const std::vector<std::uint8_t>& nodes) const
  {
    std::vector<std::uint8_t> result = nodes;
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      bool any = false;
      for (std::size_t i = 0; i < wall_.corners(f); ++i)
      {
        any = any || nodes[wall_.node(f, i)] != 0;
      }
      for (std::size_t i = 0; any && i < wall_.corners(f); ++i)
      {
        result[wall_.node(f, i)] = 1;
      }
    }
    return result;
  }

  // Nodes above which stacks have changed: sides are divided as the layers on either face require.
  std::vector<std::uint8_t> changedNodes() const
  {
    std::vector<std::uint8_t> nodes(wall_.nodes());
    for (std::size_t n = 0; n < wall_.nodes(); ++n)
    {
      nodes[n] = wall_.parts[n] != measured_.parts[n];
    }
    return grown(nodes);
  }

  // Faces whose stacks have changed, or may have a face in common with what has.
  std::vector<std::uint8_t> facesNear(
    const std::vector<std::uint8_t>& changed, const std::vector<std::uint8_t>& isTouched) const
  {
    std::vector<std::uint8_t> nodes = grown(changed);
    for (std::size_t n = 0; n < wall_.nodes(); ++n)
    {
      nodes[n] |= isTouched[static_cast<std::size_t>(wall_.of.mesh.meshPoint[n])];
    }
    std::vector<std::uint8_t> faces(wall_.layered.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      for (std::size_t i = 0; i < wall_.corners(f); ++i)
      {
        faces[f] |= nodes[wall_.node(f, i)];
      }
    }
    return faces;
  }

  // In all cells.
  std::vector<LayerFault> findFaults()
  {
    result_.stacks = stackPrisms(mesh_, wall_, heights_, {}, execution_);
    return faults_.find(result_.stacks, allPoints(), execution_);
  }

  // In what has changed since it was measured, and beside it; these stacks are made. `hasMoved`: of the mesh's points.
  std::vector<LayerFault> findFaults(const std::vector<std::uint8_t>& hasMoved)
  {
    LayerFaults::Changes changes = faults_.changesBy(hasMoved);
    const std::vector<std::uint8_t> nodes = changedNodes();
    result_.stacks =
      stackPrisms(mesh_, wall_, heights_, facesNear(nodes, changes.isTouched), execution_);
    for (const std::size_t n : result_.stacks.nodeOfPoint)
    {
      changes.ofStacks.push_back(nodes[n]);
    }
    return faults_.find(result_.stacks, allPoints(), changes, execution_);
  }

  std::vector<double> allPoints() const
  {
    std::vector<double> points = points_;
    points.insert(points.end(), result_.stacks.points.begin(), result_.stacks.points.end());
    return points;
  }

  // Whether there are any, of what moved by more than `least`, or of all; the remedy.
  bool mendFaults(const std::optional<double>& least, double factor)
  {
    const std::vector<std::uint8_t> hasMoved =
      least ? movedBy(*least) : std::vector<std::uint8_t>();
    const std::vector<LayerFault> found = least ? findFaults(hasMoved) : findFaults();
    setMeasured(hasMoved);
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

  void setMeasured(const std::vector<std::uint8_t>& hasMoved)
  {
    measured_.parts = wall_.parts;
    if (hasMoved.empty())
    {
      measured_.points = points_;
    }
    for (std::size_t p = 0; p < hasMoved.size(); ++p)
    {
      if (hasMoved[p])
      {
        std::copy_n(points_.begin() + 3 * std::ptrdiff_t(p), 3,
          measured_.points.begin() + 3 * std::ptrdiff_t(p));
      }
    }
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
    const std::vector<double> former = volumesOf(near_.cells, before_, execution_);
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
    std::vector<double> points; // of the mesh
    std::vector<double> parts;  // of the wall
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
  std::vector<double> points_; // ... as they are now
  std::vector<MovedPoint> moved_;
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

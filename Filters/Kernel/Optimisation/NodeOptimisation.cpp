// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/NodeOptimisation.h"

#include "Base/Sorting.h"
#include "Optimisation/MeshEnergy.h"
#include "Optimisation/NodePaths.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace cartesian
{

namespace
{

// After so many rounds a step more changes hardly anything (measured on cubes, spheres and CAD).
constexpr int Rounds = 8;

// Steps, as parts of the box's edge, and of the node's shortest edge: two nodes that move towards each other do not meet.
constexpr double FirstStep = 0.04;
constexpr double LongestStep = 0.1;
constexpr double StepOfShortestEdge = 0.2;
constexpr double Longer = 1.3;
constexpr double Shorter = 0.5;

// No node goes farther than this part of the box's edge.
constexpr double FarthestWay = 0.5;

// A face may become worse than it was up to this (FaceEnergy::limits).
constexpr double FairLimits = 2;

// A cell may become smaller than it was down to this share of its box.
constexpr double FairShare = 0.1;

class Optimiser
{
public:
  Optimiser(NodeMesh& mesh, double featureAngle, const WallLayerSpec* layers)
    : m_(mesh)
    , paths_(mesh, std::cos(radians(featureAngle)))
    , prisms_(addPrisms(mesh, layers))
    , before_(mesh.nodes.at)
    , edges_(mesh.edgesAtFaces())
    , movingOf_(listMoving())
    , energy_(mesh, prisms_, edges_, listFaces())
  {
  }

  bool run(Execution& execution)
  {
    if (moving_.empty())
    {
      return false;
    }
    prisms_.follow(m_.nodes.at);
    energy_.evaluate();
    energy_.keepStars();
    const State first{ energy_.ofFaces(), m_.cells.measures };
    for (int round = 0; round < Rounds; ++round)
    {
      execution.reach(double(round) / Rounds);
      differentiate();
      findShortest();
      step();
      evaluate();
    }
    takeBackSteps();
    for (const Moving& node : moving_)
    {
      round(m_.nodes.at[node.at]);
    }
    evaluate();
    for (std::vector<std::uint32_t> back = worsened(first); !back.empty(); back = worsened(first))
    {
      execution.poll();
      takeBack(back);
    }
    return true;
  }

private:
  struct Moving
  {
    std::uint32_t at;
    std::uint32_t firstFace; // in facesOf_, up to the next one's
    double edge;             // of the smallest box around it
    double shortest;         // of its edges, squared
    double step;
    double energy; // before its last step, or infinite: none to compare with
    Vector before; // its last step
    Vector gradient;
  };

  // In the beginning.
  struct State
  {
    std::vector<FaceEnergy> energies;
    std::vector<CellGeometry> cells;
  };

  // Returns their numbers, of nodes, or None.
  std::vector<std::uint32_t> listMoving()
  {
    std::vector<std::uint32_t> movingOf(m_.nodes.at.size(), None);
    for (std::uint32_t n = 0; n < m_.nodes.at.size(); ++n)
    {
      if (m_.nodes.mayMove[n] && paths_[n].kind != NodePath::Kind::Fixed)
      {
        movingOf[n] = static_cast<std::uint32_t>(moving_.size());
        moving_.push_back({ n, 0, std::numeric_limits<double>::infinity(), 0, 0,
          std::numeric_limits<double>::infinity(), {}, {} });
      }
    }
    for (std::size_t i = 0; i < prisms_.below.size(); ++i)
    {
      movingOf[prisms_.firstNode + i] = movingOf[prisms_.below[i]];
    }
    return movingOf;
  }

  // Calls visit(node) for the corners of a face that move.
  template <class Visitor>
  void forEachMovingOf(std::uint32_t f, Visitor&& visit)
  {
    for (std::uint32_t i = m_.faces.start[f]; i < m_.faces.start[f + 1]; ++i)
    {
      if (const std::uint32_t n = movingOf_[m_.faces.corners[i]]; n != None)
      {
        visit(moving_[n]);
      }
    }
  }

  // Those of each node. Returns of each face whether it has a moving corner.
  std::vector<std::uint8_t> listFaces()
  {
    std::vector<std::uint8_t> isMoving(m_.faces.size());
    const auto count = static_cast<std::uint32_t>(m_.faces.size());
    for (std::uint32_t f = 0; f < count; ++f)
    {
      forEachMovingOf(f, [&](Moving& node) {
        isMoving[f] = 1;
        ++node.firstFace;
        node.edge = std::min(node.edge, edges_[f]);
      });
    }
    std::uint32_t sum = 0;
    for (Moving& node : moving_)
    {
      sum += node.firstFace;
      node.firstFace = sum;
      node.step = FirstStep * node.edge;
    }
    facesOf_.resize(sum);
    for (std::uint32_t f = count; f-- > 0;)
    {
      forEachMovingOf(f, [&](Moving& node) { facesOf_[--node.firstFace] = f; });
    }
    return isMoving;
  }

  template <class Visitor>
  void forEachFaceOf(std::size_t node, Visitor&& visit) const
  {
    const std::size_t end =
      node + 1 < moving_.size() ? moving_[node + 1].firstFace : facesOf_.size();
    for (std::size_t i = moving_[node].firstFace; i < end; ++i)
    {
      visit(facesOf_[i]);
    }
  }

  void evaluate()
  {
    prisms_.follow(m_.nodes.at);
    energy_.evaluate();
  }

  // From the derivatives by measures those by places of nodes.
  void differentiate()
  {
    energy_.differentiate();
    for (Moving& node : moving_)
    {
      node.gradient = {};
    }
    for (std::size_t f = 0; f < m_.faces.size(); ++f)
    {
      if (energy_.isMoving(f))
      {
        energy_.forEachDerivative(f, [&](std::size_t i, const Vector& gradient) {
          if (const std::uint32_t n = movingOf_[m_.faces.corners[m_.faces.start[f] + i]]; n != None)
          {
            moving_[n].gradient = plus(moving_[n].gradient, gradient);
          }
        });
      }
    }
  }

  void findShortest()
  {
    for (Moving& node : moving_)
    {
      node.shortest = std::numeric_limits<double>::infinity();
    }
    for (std::size_t f = 0; f < m_.faces.size(); ++f)
    {
      std::uint32_t from = m_.faces.corners[m_.faces.start[f + 1] - 1];
      for (std::uint32_t i = m_.faces.start[f]; energy_.isMoving(f) && i < m_.faces.start[f + 1];
           ++i)
      {
        const std::uint32_t to = m_.faces.corners[i];
        const Vector edge = minus(m_.nodes.at[to], m_.nodes.at[from]);
        const double square = dot(edge, edge);
        for (const std::uint32_t n : { movingOf_[from], movingOf_[to] })
        {
          if (n != None)
          {
            moving_[n].shortest = std::min(moving_[n].shortest, square);
          }
        }
        from = to;
      }
    }
  }

  // --- steps

  // The sum over the cells around a node.
  double energyAround(std::size_t node) const
  {
    double sum = 0;
    forEachFaceOf(node, [&](std::uint32_t f) {
      for (const std::uint32_t c : m_.faces.cells[f])
      {
        sum += energy_.ofCell(c);
      }
    });
    return sum;
  }

  // Each node along its path. One whose last step did not help goes back and waits.
  void step()
  {
    for (std::size_t n = 0; n < moving_.size(); ++n)
    {
      Moving& node = moving_[n];
      const double energy = energyAround(n);
      if (energy > node.energy)
      {
        m_.nodes.at[node.at] = node.before;
        node.step *= Shorter;
        node.energy = std::numeric_limits<double>::infinity();
        continue;
      }
      if (std::isfinite(node.energy))
      {
        node.step = std::min(node.step * Longer, LongestStep * node.edge);
      }
      node.energy = energy;
      node.before = m_.nodes.at[node.at];
      move(node);
    }
  }

  void move(Moving& node)
  {
    const NodePath& path = paths_[node.at];
    Vector down = scaled(node.gradient, -1);
    if (path.kind != NodePath::Kind::Free)
    {
      const Vector along = scaled(path.direction, dot(down, path.direction));
      down = path.kind == NodePath::Kind::Line ? along : minus(down, along);
    }
    const double length = norm(down);
    if (!(length > 0))
    {
      return;
    }
    node.step = std::min(node.step, StepOfShortestEdge * std::sqrt(node.shortest));
    const Vector to = plus(m_.nodes.at[node.at], scaled(down, node.step / length));
    const Vector& from = before_[node.at];
    if (isInGrid(to) && norm(minus(to, from)) <= FarthestWay * node.edge &&
      paths_.allows(node.at, from, to, node.edge))
    {
      m_.nodes.at[node.at] = to;
    }
    else
    {
      node.step *= Shorter;
    }
  }

  bool isInGrid(const Vector& at) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (!(at[axis] > m_.ends[0][axis] && at[axis] < m_.ends[1][axis]))
      {
        return false;
      }
    }
    return true;
  }

  void takeBackSteps()
  {
    for (std::size_t n = 0; n < moving_.size(); ++n)
    {
      if (energyAround(n) > moving_[n].energy)
      {
        m_.nodes.at[moving_[n].at] = moving_[n].before;
      }
    }
  }

  static void round(Vector& at)
  {
    at = { std::round(at[0]), std::round(at[1]), std::round(at[2]) };
  }

  // The nodes that have moved, of faces and cells that are worse than they were.
  std::vector<std::uint32_t> worsened(const State& first) const
  {
    std::vector<std::uint32_t> nodes;
    for (std::size_t f = 0; f < m_.faces.size(); ++f)
    {
      const double limits = energy_.ofFaces()[f].limits;
      const bool isWorse = limits > FairLimits && limits > first.energies[f].limits;
      if ((isWorse || energy_.isFolded(f)) && !listMoved(f, nodes))
      {
        for (const std::uint32_t c : m_.faces.cells[f])
        {
          listMovedOf(c, nodes);
        }
      }
    }
    for (std::uint32_t c = 0; c < prisms_.firstCell; ++c)
    {
      const double volume = m_.cells.measures[c].volume;
      if (volume < FairShare * m_.cells.volumeOfBox[c] && volume < first.cells[c].volume)
      {
        listMovedOf(c, nodes);
      }
    }
    return sortedUnique(std::move(nodes));
  }

  // All steps of these nodes; then measures what that changes, and its limits.
  void takeBack(const std::vector<std::uint32_t>& nodes)
  {
    std::vector<std::uint32_t> faces;
    for (const std::uint32_t n : nodes)
    {
      const std::uint32_t at = n < prisms_.firstNode ? n : prisms_.below[n - prisms_.firstNode];
      m_.nodes.at[at] = before_[at];
      forEachFaceOf(movingOf_[n], [&](std::uint32_t f) { faces.push_back(f); });
    }
    prisms_.follow(m_.nodes.at);
    energy_.evaluate(sortedUnique(std::move(faces)));
  }

  // Appends the corners of a face that have moved; whether there are any.
  bool listMoved(std::size_t f, std::vector<std::uint32_t>& moved) const
  {
    const std::size_t before = moved.size();
    std::copy_if(m_.faces.corners.begin() + std::ptrdiff_t(m_.faces.start[f]),
      m_.faces.corners.begin() + std::ptrdiff_t(m_.faces.start[f + 1]), std::back_inserter(moved),
      [&](std::uint32_t n) { return movingOf_[n] != None && m_.nodes.at[n] != before_[n]; });
    return moved.size() > before;
  }

  void listMovedOf(std::uint32_t c, std::vector<std::uint32_t>& moved) const
  {
    for (std::uint32_t i = c < m_.cells.changing ? m_.cells.firstUse[c] : 0;
         c < m_.cells.changing && i < m_.cells.firstUse[c + 1]; ++i)
    {
      listMoved(m_.cells.uses[i], moved);
    }
  }

  NodeMesh& m_;
  NodePaths paths_;
  const LayerPrisms prisms_;
  const std::vector<Vector> before_; // where nodes were
  const std::vector<double> edges_;  // of boxes, of each face
  std::vector<Moving> moving_;
  const std::vector<std::uint32_t> movingOf_; // of each node, or None
  std::vector<std::uint32_t> facesOf_;        // of moving nodes
  MeshEnergy energy_;
};

// Enclosed by the star triangles of a cell's faces.
double volumeOf(const NodeMesh& mesh, std::uint32_t c)
{
  const Vector& origin =
    mesh.nodes.at[mesh.faces.corners[mesh.faces.start[mesh.cells.uses[mesh.cells.firstUse[c]]]]];
  double volume = 0;
  for (std::uint32_t i = mesh.cells.firstUse[c]; i < mesh.cells.firstUse[c + 1]; ++i)
  {
    const std::uint32_t f = mesh.cells.uses[i];
    Vector area{};
    const Vector mean = forEachStarTriangle(
      mesh.faces.start[f + 1] - mesh.faces.start[f],
      [&](std::size_t k) -> const Vector& {
        return mesh.nodes.at[mesh.faces.corners[mesh.faces.start[f] + k]];
      },
      [&](const Vector&, const Vector&, const Vector& triangle) { area = plus(area, triangle); });
    volume += (mesh.faces.cells[f][0] == c ? 1 : -1) * dot(minus(mean, origin), area) / 3;
  }
  return volume;
}

// Gives the mesh the places of a slab's nodes, and the volumes of its cells.
void write(const NodeMesh& mesh, Nodes& nodes, WallMesh& wall)
{
  for (std::size_t n = 0; n < mesh.nodes.at.size(); ++n)
  {
    for (std::size_t axis = 0; mesh.nodes.mayMove[n] && axis < 3; ++axis)
    {
      nodes.at[mesh.nodes.number[n]][axis] =
        static_cast<Level>(mesh.nodes.at[n][axis] + mesh.origin[axis]);
    }
  }
  for (std::uint32_t c = 0; c < mesh.cells.changing; ++c)
  {
    if (mesh.cells.number[c] != None)
    {
      wall.cells[mesh.cells.number[c]].volumeFraction =
        volumeOf(mesh, c) / mesh.cells.volumeOfBox[c];
    }
  }
}

}

std::vector<std::uint32_t> optimiseNodes(const Boxes& boxes, const Sides& sides,
  const std::vector<Slab>& slabs, double featureAngle, const WallLayerSpec* layers, Nodes& nodes,
  WallMesh& wall, Execution& execution)
{
  std::vector<std::vector<std::uint32_t>> changed(slabs.size());
  execution.forEach(slabs.size(), 1, [&](std::size_t s, std::size_t) {
    const auto count = static_cast<double>(slabs.size());
    Execution alone = execution.alone(double(s) / count, double(s + 1) / count);
    NodeMesh mesh = nodeMesh(boxes, sides, nodes, wall, slabs[s]);
    if (Optimiser(mesh, featureAngle, layers).run(alone))
    {
      write(mesh, nodes, wall);
      const auto end = mesh.cells.number.begin() + std::ptrdiff_t(mesh.cells.changing);
      std::copy_if(mesh.cells.number.begin(), end, std::back_inserter(changed[s]),
        [](std::uint32_t c) { return c != None; });
    }
  });
  std::vector<std::uint32_t> all;
  for (const std::vector<std::uint32_t>& ofSlab : changed)
  {
    all.insert(all.end(), ofSlab.begin(), ofSlab.end());
  }
  return all;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/NodeOptimisation.h"

#include "Base/Sorting.h"
#include "Optimisation/MeshEnergy.h"
#include "Optimisation/NodePaths.h"
#include "Optimisation/WorstFaces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

namespace cartesian
{

namespace
{

// More rounds do not improve smooth walls, and remaining poor faces are repaired one by one (WorstFaces.h).
constexpr int Rounds = 4;

// Steps, as parts of the box's edge, and of the node's shortest edge: two nodes that move towards each other do not meet.
constexpr double FirstStep = 0.04;
constexpr double LongestStep = 0.1;
constexpr double StepOfShortestEdge = 0.2;
constexpr double Longer = 1.3;
constexpr double Shorter = 0.5;

// FaceEnergy::limits up to which a face may become worse than it was: a skewness of 3.1. Anything worse is too
// costly.
constexpr double FairLimits = 15;

class Optimiser
{
public:
  Optimiser(NodeMesh& mesh, double featureAngle, const WallLayerSpec* layers)
    : m_(mesh)
    , featureCosine_(std::cos(radians(featureAngle)))
    , paths_(mesh, featureCosine_)
    , prisms_(addPrisms(mesh, layers))
    , before_(mesh.nodes.at)
    , edges_(mesh.edgesAtFaces())
    , movingOf_(listMoving())
    , energy_(mesh, prisms_, edges_, listFaces())
  {
    if (movesAny())
    {
      evaluate();
      energy_.keepStars();
      first_ = energy_.ofFaces();
    }
  }

  bool movesAny() const { return !moving_.empty(); }

  // All nodes together.
  void move(Execution& execution)
  {
    for (int round = 0; round < Rounds; ++round)
    {
      execution.reach(double(round) / (Rounds + 1));
      differentiate();
      findShortest();
      step();
      evaluate();
    }
    takeBackSteps();
    for (const Moving& node : moving_)
    {
      m_.nodes.at[node.at] = rounded(m_.nodes.at[node.at]);
    }
  }

  // Face by face. Returns the edits, to be made in the wall mesh.
  std::vector<FaceEdit> mend(Execution& execution)
  {
    evaluate();
    energy_.keepLimits(first_, FairLimits);
    return mendWorstFaces({ m_, paths_, before_, edges_, featureCosine_ }, energy_, execution);
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
    for (std::uint32_t i = m_.faces.start[f]; i < m_.faces.stop[f]; ++i)
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
      std::uint32_t from = m_.faces.corners[m_.faces.stop[f] - 1];
      for (std::uint32_t i = m_.faces.start[f]; energy_.isMoving(f) && i < m_.faces.stop[f]; ++i)
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

  // Each node along its path. A node whose last step did not help moves back and waits.
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
    const Vector down = paths_[node.at].along(scaled(node.gradient, -1));
    const double length = norm(down);
    if (!(length > 0))
    {
      return;
    }
    node.step = std::min(node.step, StepOfShortestEdge * std::sqrt(node.shortest));
    const Vector to = plus(m_.nodes.at[node.at], scaled(down, node.step / length));
    if (paths_.allows(node.at, before_[node.at], to, node.edge))
    {
      m_.nodes.at[node.at] = to;
    }
    else
    {
      node.step *= Shorter;
    }
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

  NodeMesh& m_;
  double featureCosine_;
  NodePaths paths_;
  const LayerPrisms prisms_;
  const std::vector<Vector> before_; // where nodes were
  const std::vector<double> edges_;  // of boxes, of each face
  std::vector<Moving> moving_;
  const std::vector<std::uint32_t> movingOf_; // of each node, or None
  std::vector<std::uint32_t> facesOf_;        // of moving nodes
  MeshEnergy energy_;
  std::vector<FaceEnergy> first_; // of the faces, before anything moves
};

// Enclosed by the star triangles of a cell's faces.
double volumeOf(const NodeMesh& mesh, std::uint32_t c)
{
  const Vector& origin =
    mesh.nodes.at[mesh.faces.corners[mesh.faces.start[mesh.cells.uses[mesh.cells.firstUse[c]]]]];
  double volume = 0;
  for (std::uint32_t i = mesh.cells.firstUse[c]; i < mesh.cells.endUse[c]; ++i)
  {
    const std::uint32_t f = mesh.cells.uses[i];
    Vector area{};
    const Vector mean = forEachStarTriangle(
      mesh.faces.stop[f] - mesh.faces.start[f],
      [&](std::size_t k) -> const Vector& {
        return mesh.nodes.at[mesh.faces.corners[mesh.faces.start[f] + k]];
      },
      [&](const Vector&, const Vector&, const Vector& triangle) { area = plus(area, triangle); });
    volume += (mesh.faces.cells[f][0] == c ? 1 : -1) * dot(minus(mean, origin), area) / 3;
  }
  return volume;
}

// Of a node of a NodeMesh, on the lattice.
struct NodePlace
{
  Point at;
  std::uint32_t node;

  bool operator<(const NodePlace& other) const
  {
    return std::tie(at, node) < std::tie(other.at, other.node);
  }
};

std::vector<NodePlace> roundedPlaces(const NodeMesh& mesh, const Nodes& nodes)
{
  std::vector<NodePlace> places;
  places.reserve(mesh.nodes.at.size());
  for (std::uint32_t n = 0; n < mesh.nodes.at.size(); ++n)
  {
    if (mesh.nodes.number[n] == None)
    {
      continue;
    }
    Point at = nodes.at[mesh.nodes.number[n]];
    for (std::size_t axis = 0; mesh.nodes.mayMove[n] && axis < 3; ++axis)
    {
      at[axis] = static_cast<Level>(mesh.nodes.at[n][axis] + mesh.origin[axis]);
    }
    places.push_back({ at, n });
  }
  return places;
}

// Nodes that came to be at one place go back to where they were, each to its own.
void keepApart(const Nodes& nodes, NodeMesh& mesh, std::vector<NodePlace>& places)
{
  for (bool isAnyBack = true; isAnyBack;)
  {
    isAnyBack = false;
    std::sort(places.begin(), places.end());
    for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end)
    {
      while (end < places.size() && areSame(places[end].at, places[begin].at))
      {
        ++end;
      }
      for (std::size_t i = begin; end - begin > 1 && i < end; ++i)
      {
        auto& [at, n] = places[i];
        const Point& before = nodes.at[mesh.nodes.number[n]];
        isAnyBack = isAnyBack || !areSame(at, before);
        at = before;
        mesh.nodes.at[n] = minus(before, mesh.origin);
      }
    }
  }
}

// Gives the mesh the places of a slab's nodes, and the volumes of its cells.
void write(NodeMesh& mesh, Nodes& nodes, WallMesh& wall)
{
  std::vector<NodePlace> places = roundedPlaces(mesh, nodes);
  keepApart(nodes, mesh, places);
  for (const auto& [at, n] : places)
  {
    if (mesh.nodes.mayMove[n])
    {
      nodes.at[mesh.nodes.number[n]] = at;
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

// All nodes, for the cells and for the layers requested on the wall. Faces that are still poor are repaired without
// layers.
void moveWithPrisms(NodeMesh mesh, double featureAngle, const WallLayerSpec& layers, Nodes& nodes,
  WallMesh& wall, Execution& execution)
{
  Optimiser optimiser(mesh, featureAngle, &layers);
  if (optimiser.movesAny())
  {
    optimiser.move(execution);
    write(mesh, nodes, wall);
  }
}

std::vector<MovedHexahedron> hexahedraOf(const NodeMesh& mesh, const Boxes& boxes)
{
  std::vector<MovedHexahedron> hexahedra;
  for (std::uint32_t c = 0; c < mesh.cells.changing; ++c)
  {
    if (const std::uint32_t box = mesh.cells.box[c]; box != None)
    {
      CellGeometry geometry = mesh.cells.measures[c];
      geometry.centre = minus(geometry.centre, minus(boxes.lowOf(box), mesh.origin));
      hexahedra.push_back({ box, geometry });
    }
  }
  return hexahedra;
}

}

Optimised optimiseNodes(const Boxes& boxes, const Sides& sides, const std::vector<Slab>& slabs,
  double featureAngle, const WallLayerSpec* layers, NodesMove move, Nodes& nodes, WallMesh& wall,
  Execution& execution)
{
  Optimised result;
  result.edits.resize(slabs.size());
  std::vector<std::vector<std::uint32_t>> changed(slabs.size());
  std::vector<std::vector<MovedHexahedron>> hexahedra(slabs.size());
  execution.forEach(slabs.size(), 1, [&](std::size_t s, std::size_t) {
    const auto count = static_cast<double>(slabs.size());
    Execution alone = execution.alone(double(s) / count, double(s + 1) / count);
    if (layers && move == NodesMove::All)
    {
      moveWithPrisms(
        nodeMesh(boxes, sides, nodes, wall, slabs[s]), featureAngle, *layers, nodes, wall, alone);
    }
    NodeMesh mesh = nodeMesh(boxes, sides, nodes, wall, slabs[s]);
    Optimiser optimiser(mesh, featureAngle, nullptr);
    if (optimiser.movesAny())
    {
      if (move == NodesMove::All && !layers)
      {
        optimiser.move(alone);
      }
      result.edits[s] = optimiser.mend(alone);
      write(mesh, nodes, wall);
      const auto end = mesh.cells.number.begin() + std::ptrdiff_t(mesh.cells.changing);
      std::copy_if(mesh.cells.number.begin(), end, std::back_inserter(changed[s]),
        [](std::uint32_t c) { return c != None; });
      hexahedra[s] = hexahedraOf(mesh, boxes);
    }
  });
  for (std::size_t s = 0; s < slabs.size(); ++s)
  {
    result.changed.insert(result.changed.end(), changed[s].begin(), changed[s].end());
    result.hexahedra.insert(result.hexahedra.end(), hexahedra[s].begin(), hexahedra[s].end());
  }
  return result;
}

}

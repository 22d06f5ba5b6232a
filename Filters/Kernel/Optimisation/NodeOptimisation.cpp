// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/NodeOptimisation.h"

#include "Acceptance/FaceEnergy.h"
#include "Optimisation/LayerPrisms.h"
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

// The smallest triangle of a face's star, relative to the mean one, unless it was smaller.
constexpr double LeastOfStar = 0.02;

// ... and a cell smaller than it was down to this share of its box.
constexpr double FairShare = 0.1;

constexpr double OfFoldedFace = 1e9;

class Optimiser
{
public:
  Optimiser(WallMesh& mesh, double featureAngle, const WallLayerSpec* layers)
    : m_(mesh)
    , paths_(mesh, std::cos(radians(featureAngle)))
    , prisms_(addPrisms(mesh, layers))
    , before_(mesh.at)
    , faces_(mesh.faces())
    , stars_(mesh.faces())
    , energies_(mesh.faces())
    , ofFaces_(mesh.faces())
    , ofCells_(mesh.measures.size())
    , energyOfCell_(mesh.changing)
  {
    listMoving();
  }

  bool run(Execution& execution)
  {
    if (moving_.empty())
    {
      return false;
    }
    measure();
    leastStars_ = stars_;
    evaluate();
    const State first{ energies_, m_.measures };
    for (int round = 0; round < Rounds; ++round)
    {
      execution.reach(double(round) / Rounds);
      differentiate();
      step();
      measure();
      evaluate();
    }
    takeBackSteps();
    for (const Moving& node : moving_)
    {
      round(m_.at[node.at]);
    }
    measure();
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

  static double edgeOf(double volume) { return std::cbrt(volume); }

  void listMoving()
  {
    std::vector<std::uint32_t> movingOf(m_.at.size(), None);
    for (std::uint32_t n = 0; n < m_.at.size(); ++n)
    {
      if (m_.mayMove[n] && paths_[n].kind != NodePath::Kind::Fixed)
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
    movingOf_ = std::move(movingOf);
    edgeOfFace_.resize(m_.faces());
    isMoving_.resize(m_.faces());
    for (std::size_t f = 0; f < m_.faces(); ++f)
    {
      double edge = std::numeric_limits<double>::infinity();
      for (const std::uint32_t c : m_.cells[f])
      {
        edge = c == None ? edge : std::min(edge, edgeOf(m_.volumeOfBox[c]));
      }
      edgeOfFace_[f] = edge;
      for (std::uint32_t i = m_.start[f]; i < m_.start[f + 1]; ++i)
      {
        if (const std::uint32_t n = movingOf_[m_.corners[i]]; n != None)
        {
          isMoving_[f] = 1;
          ++moving_[n].firstFace;
          moving_[n].edge = std::min(moving_[n].edge, edge);
        }
      }
    }
    std::uint32_t sum = 0;
    for (Moving& node : moving_)
    {
      sum += node.firstFace;
      node.firstFace = sum;
      node.step = FirstStep * node.edge;
    }
    facesOf_.resize(sum);
    for (auto f = static_cast<std::uint32_t>(m_.faces()); f-- > 0;)
    {
      for (std::uint32_t i = m_.start[f]; i < m_.start[f + 1]; ++i)
      {
        if (const std::uint32_t n = movingOf_[m_.corners[i]]; n != None)
        {
          facesOf_[--moving_[n].firstFace] = f;
        }
      }
    }
  }

  const Vector& corner(std::size_t f, std::size_t i) const
  {
    return m_.at[m_.corners[m_.start[f] + i]];
  }
  std::size_t cornersOf(std::size_t f) const { return m_.start[f + 1] - m_.start[f]; }

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

  // --- measures

  void measure()
  {
    prisms_.follow(m_.at);
    for (Moving& node : moving_)
    {
      node.shortest = std::numeric_limits<double>::infinity();
    }
    for (std::size_t f = 0; f < m_.faces(); ++f)
    {
      if (isMoving_[f] || !measured_)
      {
        measureOne(f);
      }
    }
    measured_ = true;
    for (std::uint32_t c = 0; c < m_.changing; ++c)
    {
      m_.measures[c] = measureOf(c);
    }
  }

  void measureOne(std::size_t f)
  {
    const std::size_t size = cornersOf(f);
    const auto at = [&](std::size_t i) -> const Vector& { return corner(f, i); };
    faces_[f] = measureFace(size, at);
    stars_[f] = smallestOfStar(size, at, faces_[f].area);
    std::uint32_t from = m_.corners[m_.start[f + 1] - 1];
    for (std::uint32_t i = m_.start[f]; i < m_.start[f + 1]; ++i)
    {
      const std::uint32_t to = m_.corners[i];
      const Vector edge = minus(m_.at[to], m_.at[from]);
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

  CellGeometry measureOf(std::uint32_t c) const
  {
    const std::uint32_t* const begin = m_.cellFaces.data() + m_.cellStart[c];
    return measureCell(m_.cellStart[c + 1] - m_.cellStart[c], [&](std::size_t i) {
      FaceGeometry face = faces_[begin[i]];
      face.area = m_.cells[begin[i]][0] == c ? face.area : scaled(face.area, -1);
      return face;
    });
  }

  // --- energies

  // Of faces and cells, and their derivatives by the measures.
  void evaluate()
  {
    std::fill(ofFaces_.begin(), ofFaces_.end(), FaceGradient{});
    std::fill(ofCells_.begin(), ofCells_.end(), CellGradient{});
    std::fill(energyOfCell_.begin(), energyOfCell_.end(), 0);
    for (std::size_t f = 0; f < m_.faces(); ++f)
    {
      evaluateFace(f);
      for (const std::uint32_t c : m_.cells[f])
      {
        if (c < m_.changing)
        {
          energyOfCell_[c] += energies_[f].all;
        }
      }
    }
    for (std::uint32_t c = 0; c < prisms_.firstCell; ++c)
    {
      double byShare = 0;
      energyOfCell_[c] += energyOfShare(m_.measures[c].volume / m_.volumeOfBox[c], byShare);
      ofCells_[c].volume += byShare / m_.volumeOfBox[c];
    }
  }

  void evaluateFace(std::size_t f)
  {
    if (!prisms_.counts[f])
    {
      return;
    }
    const auto& cells = m_.cells[f];
    const Ring ring{ m_.at.data(), m_.corners.data() + m_.start[f], cornersOf(f) };
    energies_[f] = m_.isWall(f)
      ? energyOfWall(f, ring)
      : energyOfInnerFace(faces_[f], ring, edgeOfFace_[f], m_.measures[cells[0]],
          m_.measures[cells[1]], ofFaces_[f], ofCells_[cells[0]], ofCells_[cells[1]]);
    if (isFolded(f))
    {
      energies_[f].all += OfFoldedFace;
    }
  }

  // Between two regions it is a boundary face for the solvers of both.
  FaceEnergy energyOfWall(std::size_t f, const Ring& ring)
  {
    const auto& cells = m_.cells[f];
    FaceEnergy energy = energyOfBoundaryFace(
      faces_[f], ring, edgeOfFace_[f], m_.measures[cells[0]], ofFaces_[f], ofCells_[cells[0]]);
    if (cells[1] != None)
    {
      FaceGeometry turned = faces_[f];
      turned.area = scaled(turned.area, -1);
      FaceGradient ofTurned;
      const FaceEnergy other = energyOfBoundaryFace(
        turned, ring, edgeOfFace_[f], m_.measures[cells[1]], ofTurned, ofCells_[cells[1]]);
      energy.limits += other.limits;
      energy.all += other.all;
      ofFaces_[f].centre = plus(ofFaces_[f].centre, ofTurned.centre);
      ofFaces_[f].area = minus(ofFaces_[f].area, ofTurned.area);
    }
    return energy;
  }

  bool isFolded(std::size_t f) const
  {
    return isMoving_[f] && measured_ && !leastStars_.empty() &&
      stars_[f] < std::min(LeastOfStar, leastStars_[f]);
  }

  // From the derivatives by measures those by places of nodes.
  void differentiate()
  {
    for (std::uint32_t c = 0; c < m_.changing; ++c)
    {
      passOn(c);
    }
    for (Moving& node : moving_)
    {
      node.gradient = {};
    }
    for (std::size_t f = 0; f < m_.faces(); ++f)
    {
      if (isMoving_[f])
      {
        passOnToNodes(f);
      }
    }
  }

  // From a cell to its faces: its centre is that of the pyramids over the faces, around the mean of their centres.
  void passOn(std::uint32_t c)
  {
    const std::uint32_t* const begin = m_.cellFaces.data() + m_.cellStart[c];
    const std::size_t size = m_.cellStart[c + 1] - m_.cellStart[c];
    Vector mean{};
    for (std::size_t i = 0; i < size; ++i)
    {
      mean = plus(mean, faces_[begin[i]].centre);
    }
    mean = scaled(mean, 1.0 / static_cast<double>(size));
    const double volume = std::max(m_.measures[c].volume, Tiny);
    const Vector centre = minus(m_.measures[c].centre, mean);
    const CellGradient& own = ofCells_[c];
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::uint32_t f = begin[i];
      const double sign = m_.cells[f][0] == c ? 1 : -1;
      const Vector height = minus(faces_[f].centre, mean);
      const double pyramid = sign * dot(height, faces_[f].area) / 3;
      const double byPyramid =
        dot(minus(scaled(height, 0.75), centre), own.centre) / volume + own.volume;
      ofFaces_[f].centre = plus(ofFaces_[f].centre,
        plus(scaled(own.centre, 0.75 * pyramid / volume),
          scaled(faces_[f].area, sign * byPyramid / 3)));
      ofFaces_[f].area = plus(ofFaces_[f].area, scaled(height, sign * byPyramid / 3));
    }
  }

  // From a face to its corners, by the triangles of its star.
  void passOnToNodes(std::size_t f)
  {
    const FaceGeometry& face = faces_[f];
    const Vector normal = unit(face.area);
    const double size = std::max(norm(face.area), Tiny);
    const std::size_t count = cornersOf(f);
    Vector ofMean{};
    Vector mean{};
    for (std::size_t i = 0; i < count; ++i)
    {
      mean = plus(mean, corner(f, i));
    }
    mean = scaled(mean, 1.0 / static_cast<double>(count));
    const auto add = [&](std::size_t i, const Vector& gradient) {
      if (const std::uint32_t n = movingOf_[m_.corners[m_.start[f] + i]]; n != None)
      {
        moving_[n].gradient = plus(moving_[n].gradient, gradient);
      }
    };
    const FaceGradient& own = ofFaces_[f];
    const Vector fromCentre = minus(mean, face.centre);
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t k = i + 1 < count ? i + 1 : 0;
      const Vector p = minus(corner(f, i), mean);
      const Vector q = minus(corner(f, k), mean);
      const double area = dot(cross(p, q), normal) / 2;
      const Vector shift = scaled(own.centre, area / (3 * size));
      const Vector offset = plus(scaled(plus(p, q), 1.0 / 3), fromCentre);
      const Vector byArea =
        scaled(plus(own.area, scaled(normal, dot(offset, own.centre) / size)), 0.5);
      const Vector ofP = cross(q, byArea);
      const Vector ofQ = cross(byArea, p);
      add(i, plus(shift, ofP));
      add(k, plus(shift, ofQ));
      ofMean = plus(ofMean, minus(shift, plus(ofP, ofQ)));
    }
    ofMean = scaled(ofMean, 1.0 / static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i)
    {
      add(i, ofMean);
    }
  }

  // --- steps

  // The sum over the cells around a node.
  double energyAround(std::size_t node) const
  {
    double sum = 0;
    forEachFaceOf(node, [&](std::uint32_t f) {
      for (const std::uint32_t c : m_.cells[f])
      {
        sum += c < m_.changing ? energyOfCell_[c] : 0;
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
        m_.at[node.at] = node.before;
        node.step *= Shorter;
        node.energy = std::numeric_limits<double>::infinity();
        continue;
      }
      if (std::isfinite(node.energy))
      {
        node.step = std::min(node.step * Longer, LongestStep * node.edge);
      }
      node.energy = energy;
      node.before = m_.at[node.at];
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
    const Vector to = plus(m_.at[node.at], scaled(down, node.step / length));
    const Vector& from = before_[node.at];
    if (isInGrid(to) && norm(minus(to, from)) <= FarthestWay * node.edge &&
      paths_.allows(node.at, from, to, node.edge))
    {
      m_.at[node.at] = to;
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
        m_.at[moving_[n].at] = moving_[n].before;
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
    for (std::size_t f = 0; f < m_.faces(); ++f)
    {
      const double limits = energies_[f].limits;
      const bool isWorse = limits > FairLimits && limits > first.energies[f].limits;
      if ((isWorse || isFolded(f)) && !listMoved(f, nodes))
      {
        for (const std::uint32_t c : m_.cells[f])
        {
          listMovedOf(c, nodes);
        }
      }
    }
    for (std::uint32_t c = 0; c < prisms_.firstCell; ++c)
    {
      const double volume = m_.measures[c].volume;
      if (volume < FairShare * m_.volumeOfBox[c] && volume < first.cells[c].volume)
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
      m_.at[at] = before_[at];
      forEachFaceOf(movingOf_[n], [&](std::uint32_t f) { faces.push_back(f); });
    }
    prisms_.follow(m_.at);
    std::vector<std::uint32_t> cells;
    for (const std::uint32_t f : faces = sortedUnique(std::move(faces)))
    {
      measureOne(f);
      std::copy_if(m_.cells[f].begin(), m_.cells[f].end(), std::back_inserter(cells),
        [&](std::uint32_t c) { return c < m_.changing; });
    }
    for (const std::uint32_t c : cells = sortedUnique(std::move(cells)))
    {
      m_.measures[c] = measureOf(c);
      faces.insert(faces.end(), m_.cellFaces.begin() + std::ptrdiff_t(m_.cellStart[c]),
        m_.cellFaces.begin() + std::ptrdiff_t(m_.cellStart[c + 1]));
    }
    for (const std::uint32_t f : sortedUnique(std::move(faces)))
    {
      evaluateFace(f);
    }
  }

  static std::vector<std::uint32_t> sortedUnique(std::vector<std::uint32_t> list)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

  // Appends the corners of a face that have moved; whether there are any.
  bool listMoved(std::size_t f, std::vector<std::uint32_t>& moved) const
  {
    const std::size_t before = moved.size();
    std::copy_if(m_.corners.begin() + std::ptrdiff_t(m_.start[f]),
      m_.corners.begin() + std::ptrdiff_t(m_.start[f + 1]), std::back_inserter(moved),
      [&](std::uint32_t n) { return movingOf_[n] != None && m_.at[n] != before_[n]; });
    return moved.size() > before;
  }

  void listMovedOf(std::uint32_t c, std::vector<std::uint32_t>& moved) const
  {
    for (std::uint32_t i = c < m_.changing ? m_.cellStart[c] : 0;
         c < m_.changing && i < m_.cellStart[c + 1]; ++i)
    {
      listMoved(m_.cellFaces[i], moved);
    }
  }

  WallMesh& m_;
  NodePaths paths_;
  const LayerPrisms prisms_;
  const std::vector<Vector> before_; // where nodes were
  std::vector<Moving> moving_;
  std::vector<std::uint32_t> movingOf_; // of each node, or None
  std::vector<std::uint32_t> facesOf_;  // of moving nodes
  std::vector<double> edgeOfFace_;      // of the smaller of its boxes
  std::vector<std::uint8_t> isMoving_;  // 1 for faces with a moving corner
  bool measured_ = false;               // all faces have been

  std::vector<FaceGeometry> faces_;
  std::vector<double> stars_;      // smallest triangles of stars
  std::vector<double> leastStars_; // ... before
  std::vector<FaceEnergy> energies_;
  std::vector<FaceGradient> ofFaces_;
  std::vector<CellGradient> ofCells_;
  std::vector<double> energyOfCell_;
};

// Enclosed by the star triangles of a cell's faces.
double volumeOf(const WallMesh& mesh, std::uint32_t c)
{
  const Vector& origin = mesh.at[mesh.corners[mesh.start[mesh.cellFaces[mesh.cellStart[c]]]]];
  double volume = 0;
  for (std::uint32_t i = mesh.cellStart[c]; i < mesh.cellStart[c + 1]; ++i)
  {
    const std::uint32_t f = mesh.cellFaces[i];
    Vector area{};
    const Vector mean = forEachStarTriangle(
      mesh.start[f + 1] - mesh.start[f],
      [&](std::size_t k) -> const Vector& { return mesh.at[mesh.corners[mesh.start[f] + k]]; },
      [&](const Vector&, const Vector&, const Vector& triangle) { area = plus(area, triangle); });
    volume += (mesh.cells[f][0] == c ? 1 : -1) * dot(minus(mean, origin), area) / 3;
  }
  return volume;
}

// Gives the mesh the places of a slab's nodes, and the volumes of its cells.
void write(const WallMesh& mesh, Nodes& nodes, Cells& cells)
{
  for (std::size_t n = 0; n < mesh.at.size(); ++n)
  {
    for (std::size_t axis = 0; mesh.mayMove[n] && axis < 3; ++axis)
    {
      nodes.at[mesh.number[n]][axis] = static_cast<Level>(mesh.at[n][axis] + mesh.origin[axis]);
    }
  }
  for (std::uint32_t c = 0; c < mesh.changing; ++c)
  {
    if (mesh.cell[c] != None)
    {
      cells.all[mesh.cell[c]].volumeFraction = volumeOf(mesh, c) / mesh.volumeOfBox[c];
    }
  }
}

}

std::vector<std::uint32_t> optimiseNodes(const WallParts& parts, const std::vector<Slab>& slabs,
  double featureAngle, const WallLayerSpec* layers, Nodes& nodes, Cells& cells,
  Execution& execution)
{
  std::vector<std::vector<std::uint32_t>> changed(slabs.size());
  execution.forEach(slabs.size(), 1, [&](std::size_t s, std::size_t) {
    const auto count = static_cast<double>(slabs.size());
    Execution alone = execution.alone(double(s) / count, double(s + 1) / count);
    WallMesh mesh = wallMesh(parts, slabs[s]);
    if (Optimiser(mesh, featureAngle, layers).run(alone))
    {
      write(mesh, nodes, cells);
      const auto end = mesh.cell.begin() + std::ptrdiff_t(mesh.changing);
      std::copy_if(mesh.cell.begin(), end, std::back_inserter(changed[s]),
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

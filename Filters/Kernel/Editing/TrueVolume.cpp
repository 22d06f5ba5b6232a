// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/TrueVolume.h"

#include "Editing/EditMeasures.h"
#include "Editing/PrimitiveEdits.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr int Steps = 4;          // of Jacobi's method
constexpr double MostMoved = 0.1; // in boxes
constexpr double MostSlope = 0.1; // ... by the length of the walls around
constexpr double LeastMoved = 1e-6;
constexpr double FlatCosine = 1 - 1e-6; // between walls: 0.08 degrees
constexpr double MostCost = 3;          // that a face may cost more than before
constexpr int RoundsOfHalving = 2; // then nodes of poor faces go back, and those of their cells
constexpr int Rounds = 16;

constexpr std::size_t ItemsAChunk = 1024;

class TrueVolume
{
public:
  TrueVolume(EditStore& store, const ObjectiveSpec& spec, Execution& execution)
    : store_(store)
    , mesh_(store, 0, 0, {})
    , spec_(spec)
    , execution_(execution)
    , nodes_(store.nodes.size())
  {
    forEach(nodes_.size(), [&](std::uint32_t n) {
      nodes_[n] = {};
      nodes_[n].mayMove = mayMove(n);
      nodes_[n].before = mesh_.node(n).at;
      nodes_[n].normal = nodes_[n].mayMove ? normalAt(n) : Vector{};
      nodes_[n].mayMove = nodes_[n].mayMove && !isFlatAt(n);
    });
  }

  void run()
  {
    findHeights();
    find(near_, [&](std::uint32_t n) { return nodes_[n].height != 0; });
    forEach(nodes_.size(), [&](std::uint32_t n) { place(n); });
    measure(near_);
    isPoor_.assign(store_.faces.size(), 0);
    findPoor(near_);
    for (int round = 0; round < Rounds && takeBack(round); ++round)
    {
      find(now_, [&](std::uint32_t n) { return nodes_[n].isTakenBack; });
      measure(now_);
      findPoor(now_);
    }
    settle();
  }

private:
  struct Mover
  {
    Vector before{}; // where the node was
    Vector normal{}; // of its walls, there
    double height = 0;
    double rise = 0; // in this step
    bool mayMove = false;
    bool isTakenBack = false; // in this round
  };

  // Faces with a node that moved, cells with such a face.
  struct Reach
  {
    std::vector<std::uint8_t> faces;
    std::vector<std::uint8_t> cells;
  };

  template <class Visitor>
  void forEach(std::size_t count, Visitor&& visit)
  {
    execution_.forEach(count, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i)
      {
        visit(i);
      }
    });
  }

  bool isWall(std::uint32_t f) const
  {
    return !mesh_.face(f).gone && mesh_.isSurface(f) && mesh_.isFree(mesh_.face(f).below);
  }

  // Smooth walls only, and nothing that another cell than free ones has.
  bool mayMove(std::uint32_t n) const
  {
    const EditNode& node = mesh_.node(n);
    if (node.gone || !node.atWall || node.kind != NodeKind::OnSurface || node.held != 0)
    {
      return false;
    }
    const Items faces = mesh_.facesAround(n);
    return std::all_of(faces.begin(), faces.end(),
             [&](std::uint32_t f) {
               const EditFace& face = mesh_.face(f);
               return mesh_.isFree(face.below) && (face.above == None || mesh_.isFree(face.above));
             }) &&
      !(isAny(faces, true) && isAny(faces, false));
  }

  // Whether any is a wall, or between regions.
  bool isAny(Items faces, bool wall) const
  {
    return std::any_of(faces.begin(), faces.end(),
      [&](std::uint32_t f) { return mesh_.isSurface(f) && mesh_.isWall(f) == wall; });
  }

  Vector normalAt(std::uint32_t n) const
  {
    Vector sum{};
    for (const std::uint32_t f : mesh_.facesAround(n))
    {
      sum = isWall(f) ? plus(sum, scaled(mesh_.face(f).area, mesh_.signOf(f))) : sum;
    }
    return unit(sum);
  }

  // What flat walls owe was lost at their edges.
  bool isFlatAt(std::uint32_t n) const
  {
    const Items faces = mesh_.facesAround(n);
    return std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
      const Vector& area = mesh_.face(f).area;
      return !isWall(f) || mesh_.signOf(f) * dot(area, nodes_[n].normal) >= FlatCosine * norm(area);
    });
  }

  double edgeAt(std::uint32_t n) const
  {
    return mesh_.cell(mesh_.face(mesh_.facesAround(n)[0]).below).edge;
  }

  // Each step, nodes rise by the mean of what the walls around them still owe.
  void findHeights()
  {
    std::vector<double> owed(store_.faces.size(), 0);
    forEach(owed.size(), [&](std::uint32_t f) { owed[f] = isWall(f) ? mesh_.face(f).debt : 0; });
    for (int step = 0; step < Steps; ++step)
    {
      forEach(nodes_.size(), [&](std::uint32_t n) {
        if (nodes_[n].mayMove)
        {
          raise(n, owed);
        }
      });
      forEach(owed.size(), [&](std::uint32_t f) {
        if (isWall(f))
        {
          owed[f] -= mesh_.signOf(f) * norm(mesh_.face(f).area) * meanOfCorners(f, &Mover::rise);
        }
      });
    }
  }

  void raise(std::uint32_t n, const std::vector<double>& owed)
  {
    double debt = 0;
    double area = 0;
    for (const std::uint32_t f : mesh_.facesAround(n))
    {
      if (isWall(f))
      {
        debt += mesh_.signOf(f) * owed[f];
        area += norm(mesh_.face(f).area);
      }
    }
    Mover& node = nodes_[n];
    const double most = std::min(MostMoved * edgeAt(n), MostSlope * std::sqrt(area));
    const double height = std::clamp(node.height + (area > 0 ? debt / area : 0), -most, most);
    node.rise = height - node.height;
    node.height = height;
  }

  double meanOfCorners(std::uint32_t f, double Mover::*value) const
  {
    double sum = 0;
    for (const std::uint32_t n : mesh_.cornersOf(f))
    {
      sum += nodes_[n].*value;
    }
    return sum / double(mesh_.face(f).corners.size);
  }

  void place(std::uint32_t n)
  {
    Mover& mover = nodes_[n];
    if (!mover.mayMove)
    {
      return;
    }
    EditNode& node = store_.nodes[n];
    if (std::abs(mover.height) < LeastMoved * edgeAt(n))
    {
      mover.height = 0;
      node.at = mover.before;
      return;
    }
    node.at = onLattice(mesh_, plus(mover.before, scaled(mover.normal, mover.height)), node.held);
  }

  // Nothing else has changed.
  void measure(const Reach& reach)
  {
    forEach(reach.faces.size(), [&](std::uint32_t f) {
      if (reach.faces[f] != 0)
      {
        EditMesh mesh(store_, 0, 0, {});
        measureFace(mesh, f);
      }
    });
    forEach(reach.cells.size(), [&](std::uint32_t c) {
      if (reach.cells[c] != 0)
      {
        EditMesh mesh(store_, 0, 0, {});
        measureCell(mesh, c);
      }
    });
  }

  template <class HasMoved>
  void find(Reach& reach, HasMoved&& hasMoved)
  {
    reach.faces.assign(store_.faces.size(), 0);
    forEach(reach.faces.size(), [&](std::uint32_t f) {
      const Items ring = mesh_.cornersOf(f);
      reach.faces[f] =
        !mesh_.face(f).gone && std::any_of(ring.begin(), ring.end(), hasMoved) ? 1 : 0;
    });
    reach.cells.assign(store_.cells.size(), 0);
    forEach(reach.cells.size(), [&](std::uint32_t c) {
      const Items faces = mesh_.facesOf(c);
      reach.cells[c] = mesh_.isFree(c) &&
          std::any_of(
            faces.begin(), faces.end(), [&](std::uint32_t f) { return reach.faces[f] != 0; })
        ? 1
        : 0;
    });
  }

  // Whether what a face costs may have changed.
  bool dependsOn(const Reach& reach, std::uint32_t f) const
  {
    const EditFace& face = mesh_.face(f);
    return !face.gone &&
      (reach.cells[face.below] != 0 || (face.above != None && reach.cells[face.above] != 0));
  }

  void findPoor(const Reach& reach)
  {
    forEach(isPoor_.size(), [&](std::uint32_t f) {
      if (dependsOn(reach, f))
      {
        isPoor_[f] = isWorse(f) ? 1 : 0;
      }
    });
  }

  bool isWorse(std::uint32_t f) const
  {
    const EditFace& face = mesh_.face(f);
    const Cost<double> cost = costOfFace(mesh_, f, spec_);
    return cost.fails > int(face.fails) || cost.value > face.cost + MostCost;
  }

  // Halves what nodes of faces that became poor have moved; later takes it back. False: there are none.
  bool takeBack(int round)
  {
    if (std::find(isPoor_.begin(), isPoor_.end(), 1) == isPoor_.end())
    {
      return false;
    }
    forEach(nodes_.size(), [&](std::uint32_t n) {
      Mover& mover = nodes_[n];
      mover.isTakenBack = mover.height != 0 && isAnyPoor(n, round >= RoundsOfHalving);
      if (mover.isTakenBack)
      {
        mover.height = round < RoundsOfHalving ? mover.height / 2 : 0;
        place(n);
      }
    });
    return true;
  }

  // Of the faces around a node, or also of their cells.
  bool isAnyPoor(std::uint32_t n, bool ofCells) const
  {
    const auto is = [&](std::uint32_t f) { return isPoor_[f] != 0; };
    const Items faces = mesh_.facesAround(n);
    bool isAny = std::any_of(faces.begin(), faces.end(), is);
    for (std::size_t i = 0; ofCells && i < faces.size() && !isAny; ++i)
    {
      for (const std::uint32_t c : { mesh_.face(faces[i]).below, mesh_.face(faces[i]).above })
      {
        const Items others = c == None ? faces : mesh_.facesOf(c);
        isAny = isAny || std::any_of(others.begin(), others.end(), is);
      }
    }
    return isAny;
  }

  void settle()
  {
    forEach(store_.faces.size(), [&](std::uint32_t f) {
      if (isWall(f))
      {
        store_.faces[f].debt -= sweptBy(f);
      }
    });
    forEach(nodes_.size(), [&](std::uint32_t n) {
      EditNode& node = store_.nodes[n];
      node.home = nodes_[n].height != 0 ? node.at : node.home;
    });
    cost();
  }

  void cost()
  {
    forEach(near_.cells.size(), [&](std::uint32_t c) {
      if (near_.cells[c] != 0)
      {
        EditMesh mesh(store_, 0, 0, {});
        setCostOfCell(mesh, c);
      }
    });
    forEach(near_.faces.size(), [&](std::uint32_t f) {
      if (dependsOn(near_, f))
      {
        EditMesh mesh(store_, 0, 0, {});
        setCostOfFace(mesh, f, spec_);
      }
    });
  }

  // The volume that a wall has passed over, as the triangles around the mean of its corners enclose it. Their areas are
  // of second degree in time: Simpson's rule is exact.
  double sweptBy(std::uint32_t f) const
  {
    const Items ring = mesh_.cornersOf(f);
    const auto at = [&](std::uint32_t n, double time) {
      return plus(scaled(nodes_[n].before, 1 - time), scaled(mesh_.node(n).at, time));
    };
    const auto moved = [&](std::uint32_t n) { return minus(mesh_.node(n).at, nodes_[n].before); };
    const double share = 1 / double(ring.size());
    double volume = 0;
    for (const auto& [time, weight] : { std::pair{ 0.0, 1.0 }, { 0.5, 4.0 }, { 1.0, 1.0 } })
    {
      Vector mean{};
      Vector meanMoved{};
      for (const std::uint32_t n : ring)
      {
        mean = plus(mean, scaled(at(n, time), share));
        meanMoved = plus(meanMoved, scaled(moved(n), share));
      }
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        const std::uint32_t p = ring[i];
        const std::uint32_t q = ring[(i + 1) % ring.size()];
        const Vector area = cross(minus(at(p, time), mean), minus(at(q, time), mean));
        volume += weight * dot(plus(plus(moved(p), moved(q)), meanMoved), area);
      }
    }
    return volume / 36; // 6 of the rule, 3 of the mean, 2 of areas
  }

  EditStore& store_;
  const EditMesh mesh_; // to read from
  const ObjectiveSpec& spec_;
  Execution& execution_;
  RecordVector<Mover> nodes_;
  Reach near_;                       // of all that moved
  Reach now_;                        // of what was taken back in this round
  std::vector<std::uint8_t> isPoor_; // faces
};

}

void payDebts(EditStore& store, const ObjectiveSpec& spec, Execution& execution)
{
  TrueVolume(store, spec, execution).run();
}

}

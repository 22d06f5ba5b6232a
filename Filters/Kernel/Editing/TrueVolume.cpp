// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/TrueVolume.h"

#include "Editing/EditMeasures.h"
#include "Editing/PrimitiveEdits.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr int Steps = 4;          // of Jacobi's method
constexpr double MostMoved = 0.1; // in boxes
constexpr double LeastMoved = 1e-6;
constexpr double MostCost = 3;     // that a face may cost more than before
constexpr int RoundsOfHalving = 2; // then nodes of poor faces go back, and those of their cells
constexpr int Rounds = 5;

class TrueVolume
{
public:
  TrueVolume(EditMesh& mesh, const ObjectiveSpec& spec)
    : mesh_(mesh)
    , spec_(spec)
    , heights_(mesh.nodeCount(), 0)
    , before_(mesh.nodeCount())
    , normals_(mesh.nodeCount())
  {
    for (std::uint32_t f = 0; f < mesh_.faceCount(); ++f)
    {
      if (isWall(f) && mesh_.isFree(mesh_.face(f).below))
      {
        walls_.push_back(f);
        debts_.push_back(mesh_.face(f).debt);
      }
    }
    for (const std::uint32_t f : walls_)
    {
      for (const std::uint32_t n : mesh_.cornersOf(f))
      {
        if (mayMove(n))
        {
          nodes_.push_back(n);
        }
      }
    }
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  }

  void run()
  {
    findHeights();
    for (const std::uint32_t n : nodes_)
    {
      before_[n] = mesh_.node(n).at;
      normals_[n] = normalAt(n);
    }
    for (const std::uint32_t n : nodes_)
    {
      place(n);
    }
    measure();
    for (int round = 0; round < Rounds && takeBack(round); ++round)
    {
      measure();
    }
    settle();
  }

private:
  bool isWall(std::uint32_t f) const { return !mesh_.face(f).gone && mesh_.isWall(f); }

  // Smooth walls only, and nothing that another cell than free ones has.
  bool mayMove(std::uint32_t n) const
  {
    const EditNode& node = mesh_.node(n);
    const Items faces = mesh_.facesAround(n);
    return !node.gone && node.atWall && node.kind == NodeKind::OnSurface && node.held == 0 &&
      std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
        const EditFace& face = mesh_.face(f);
        return mesh_.isFree(face.below) && (face.above == None || mesh_.isFree(face.above));
      });
  }

  double edgeAt(std::uint32_t n) const
  {
    return mesh_.cell(mesh_.face(mesh_.facesAround(n)[0]).below).edge;
  }

  // Each step, nodes rise by the mean of what the walls around them still owe.
  void findHeights()
  {
    std::vector<double> owed(mesh_.faceCount(), 0);
    for (std::size_t i = 0; i < walls_.size(); ++i)
    {
      owed[walls_[i]] = debts_[i];
    }
    std::vector<double> rise(mesh_.nodeCount(), 0);
    for (int step = 0; step < Steps; ++step)
    {
      for (const std::uint32_t n : nodes_)
      {
        double debt = 0;
        double area = 0;
        for (const std::uint32_t f : mesh_.facesAround(n))
        {
          if (isWall(f))
          {
            debt += owed[f];
            area += norm(mesh_.face(f).area);
          }
        }
        const double most = MostMoved * edgeAt(n);
        const double height = std::clamp(heights_[n] + (area > 0 ? debt / area : 0), -most, most);
        rise[n] = height - heights_[n];
        heights_[n] = height;
      }
      for (const std::uint32_t f : walls_)
      {
        owed[f] -= norm(mesh_.face(f).area) * meanOfCorners(f, rise);
      }
    }
  }

  double meanOfCorners(std::uint32_t f, const std::vector<double>& values) const
  {
    double sum = 0;
    for (const std::uint32_t n : mesh_.cornersOf(f))
    {
      sum += values[n];
    }
    return sum / double(mesh_.face(f).corners.size);
  }

  Vector normalAt(std::uint32_t n) const
  {
    Vector sum{};
    for (const std::uint32_t f : mesh_.facesAround(n))
    {
      sum = isWall(f) ? plus(sum, mesh_.face(f).area) : sum;
    }
    return unit(sum);
  }

  void place(std::uint32_t n)
  {
    EditNode& node = mesh_.rawNode(n);
    if (std::abs(heights_[n]) < LeastMoved * edgeAt(n))
    {
      heights_[n] = 0;
      node.at = before_[n];
      return;
    }
    node.at = onLattice(mesh_, plus(before_[n], scaled(normals_[n], heights_[n])), node.held);
  }

  void measure()
  {
    for (std::uint32_t f = 0; f < mesh_.faceCount(); ++f)
    {
      if (!mesh_.face(f).gone)
      {
        measureFace(mesh_, f);
      }
    }
    for (std::uint32_t c = 0; c < mesh_.cellCount(); ++c)
    {
      if (!mesh_.cell(c).gone && !mesh_.isGhost(c))
      {
        measureCell(mesh_, c);
      }
    }
  }

  // Halves what nodes of faces that became poor have moved; later takes it back. False: there are none.
  bool takeBack(int round)
  {
    std::vector<std::uint8_t> isPoor(mesh_.nodeCount(), 0);
    const auto add = [&](std::uint32_t f) {
      for (const std::uint32_t n : mesh_.cornersOf(f))
      {
        isPoor[n] = 1;
      }
    };
    bool isAny = false;
    for (std::uint32_t f = 0; f < mesh_.faceCount(); ++f)
    {
      const EditFace& face = mesh_.face(f);
      if (face.gone)
      {
        continue;
      }
      const Cost<double> cost = costOfFace(mesh_, f, spec_);
      if ((!cost.fails || face.fails) && cost.value <= face.cost + MostCost)
      {
        continue;
      }
      isAny = true;
      add(f);
      for (const std::uint32_t c : { face.below, face.above })
      {
        if (round >= RoundsOfHalving && c != None && !mesh_.isGhost(c))
        {
          const Items faces = mesh_.facesOf(c);
          std::for_each(faces.begin(), faces.end(), add);
        }
      }
    }
    for (const std::uint32_t n : nodes_)
    {
      if (isPoor[n] != 0)
      {
        heights_[n] = round < RoundsOfHalving ? heights_[n] / 2 : 0;
        place(n);
      }
    }
    return isAny;
  }

  void settle()
  {
    for (const std::uint32_t f : walls_)
    {
      EditFace& face = mesh_.rawFace(f);
      face.debt -= norm(face.area) * meanOfCorners(f, heights_);
    }
    for (const std::uint32_t n : nodes_)
    {
      EditNode& node = mesh_.rawNode(n);
      node.home = heights_[n] != 0 ? node.at : node.home;
    }
    costAll(mesh_, spec_);
  }

  EditMesh& mesh_;
  const ObjectiveSpec& spec_;
  std::vector<std::uint32_t> walls_; // of free cells
  std::vector<double> debts_;        // of these
  std::vector<std::uint32_t> nodes_; // that may move
  std::vector<double> heights_;      // of all nodes, along their normals
  std::vector<Vector> before_;       // where nodes were
  std::vector<Vector> normals_;      // of their walls, there
};

}

void payDebts(EditMesh& mesh, const ObjectiveSpec& spec)
{
  TrueVolume(mesh, spec).run();
}

}

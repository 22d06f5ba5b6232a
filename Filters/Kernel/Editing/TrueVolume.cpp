// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/TrueVolume.h"

#include "Editing/NodeShifts.h"
#include "Editing/WallOpening.h"

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
constexpr double LeastAcross = 0.25; // square of the cosine between a wall and a plane that ends it
constexpr double FlatCosine = 1 - 1e-6; // between walls: 0.08 degrees
constexpr double MostCost = 3;          // that a face may cost more than before

constexpr std::size_t ItemsAChunk = 1024;

// How high nodes rise along the normals of their walls.
class Heights
{
public:
  Heights(EditMesh& mesh, Execution& execution)
    : mesh_(mesh, 0, 0, {})
    , execution_(execution)
    , nodes_(mesh.nodes.size())
    , deficit_(mesh.faces.size(), 0)
  {
    forEach(nodes_.size(), [&](std::uint32_t n) {
      nodes_[n] = {};
      if (maySlide(mesh_, n) || maySlideInPlane(mesh_, n))
      {
        nodes_[n].normal = normalOfWalls(mesh_, n);
        nodes_[n].mayMove = !isFlatAt(n);
        nodes_[n].way = upright(n);
      }
    });
  }

  // Each step, nodes rise by the mean of what the walls around them still owe.
  void find()
  {
    forEach(deficit_.size(),
      [&](std::uint32_t f) { deficit_[f] = isWall(f) ? mesh_.face(f).volumeDeficit : 0; });
    for (int step = 0; step < Steps; ++step)
    {
      forEach(nodes_.size(), [&](std::uint32_t n) {
        if (nodes_[n].mayMove)
        {
          raise(n);
        }
      });
      forEach(deficit_.size(), [&](std::uint32_t f) {
        if (isWall(f))
        {
          deficit_[f] -= mesh_.signOf(f) * norm(mesh_.face(f).area) * meanRise(f);
        }
      });
    }
  }

  Vector wayOf(std::uint32_t n) const
  {
    const bool isAny =
      nodes_[n].mayMove && std::abs(nodes_[n].height) >= LeastMoved * mesh_.edgeAt(n);
    return isAny ? scaled(nodes_[n].way, nodes_[n].height) : Vector{};
  }

private:
  struct Riser
  {
    Vector normal{};
    Vector way{}; // by height
    double height = 0;
    double rise = 0; // in this step
    bool mayMove = false;
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
    return isFreeWall(mesh_, f) && !isWallOfEnd(mesh_.face(f).wall);
  }

  // Along the normal, or in the plane that holds the node; 0 where that is nearly along the wall.
  Vector upright(std::uint32_t n) const
  {
    Vector way = nodes_[n].normal;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      way[axis] = (mesh_.node(n).constrainedAxes >> axis & 1) != 0 ? 0 : way[axis];
    }
    const double square = dot(way, way);
    return square > LeastAcross ? scaled(way, 1 / square) : Vector{};
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

  void raise(std::uint32_t n)
  {
    double deficit = 0;
    double area = 0;
    for (const std::uint32_t f : mesh_.facesAround(n))
    {
      if (isWall(f))
      {
        deficit += mesh_.signOf(f) * deficit_[f];
        area += norm(mesh_.face(f).area);
      }
    }
    Riser& node = nodes_[n];
    const double most = std::min(MostMoved * mesh_.edgeAt(n), MostSlope * std::sqrt(area));
    const double height = std::clamp(node.height + (area > 0 ? deficit / area : 0), -most, most);
    node.rise = height - node.height;
    node.height = height;
  }

  double meanRise(std::uint32_t f) const
  {
    double sum = 0;
    for (const std::uint32_t n : mesh_.cornersOf(f))
    {
      sum += nodes_[n].rise;
    }
    return sum / double(mesh_.face(f).corners.size);
  }

  const MeshEditor mesh_; // to read from
  Execution& execution_;
  RecordVector<Riser> nodes_;
  std::vector<double> deficit_;
};

}

void redistributeVolume(EditMesh& mesh, const ObjectiveSpec& spec, Execution& execution)
{
  Heights heights(mesh, execution);
  heights.find();
  NodeShifts shifts(mesh, spec, MostCost, execution);
  shifts.plan([&](std::uint32_t n) { return heights.wayOf(n); });
  shifts.make();
  shifts.forEachMoved([&](std::uint32_t n) { mesh.nodes[n].referencePosition = mesh.nodes[n].at; });
}

}

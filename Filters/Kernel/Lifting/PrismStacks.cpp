// SPDX-License-Identifier: BSD-3-Clause
#include "Lifting/PrismStacks.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::size_t NodesAChunk = 256;
constexpr double LeastHeight = 4; // levels: what is lifted by less, stays

Vector asVector(const Point& p)
{
  return { double(p[0]), double(p[1]), double(p[2]) };
}

// A point of a triangle by its weights of the corners.
struct Place
{
  Vector weights{};
  double distance = std::numeric_limits<double>::infinity(); // from the point that was asked for
  std::uint32_t triangle = None;

  bool operator<(const Place& other) const
  {
    return distance != other.distance ? distance < other.distance : triangle < other.triangle;
  }
};

Vector weighted(const std::array<Vector, 3>& c, const Vector& w)
{
  return plus(plus(scaled(c[0], w[0]), scaled(c[1], w[1])), scaled(c[2], w[2]));
}

Vector onEdge(const std::array<Vector, 3>& c, std::size_t i, const Vector& p)
{
  const std::size_t j = (i + 1) % 3;
  const Vector along = minus(c[j], c[i]);
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(minus(p, c[i]), along) / square, 0.0, 1.0) : 0.0;
  Vector weights{};
  weights[i] = 1 - t;
  weights[j] = t;
  return weights;
}

Place nearestPlace(const std::array<Vector, 3>& c, const Vector& p, std::uint32_t triangle)
{
  Place best;
  const auto consider = [&](const Vector& weights) {
    const Place place{ weights, norm(minus(weighted(c, weights), p)), triangle };
    best = place.distance < best.distance ? place : best;
  };
  const Vector normal = cross(minus(c[1], c[0]), minus(c[2], c[0]));
  const double square = dot(normal, normal);
  Vector inside{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector& next = c[(i + 1) % 3];
    inside[i] = dot(cross(minus(c[(i + 2) % 3], next), minus(p, next)), normal) / square;
    consider(onEdge(c, i, p));
  }
  if (inside[0] >= 0 && inside[1] >= 0 && inside[2] >= 0)
  {
    consider(inside);
  }
  return best;
}

class Lifter
{
public:
  Lifter(const OutputMesh& mesh, const Surface& displaced, const Displacement& displacement,
    Execution& execution)
    : mesh_(mesh)
    , surface_(displaced)
    , displacement_(displacement)
    , execution_(execution)
    , heights_(heightsOfLayers(displacement.spec))
    , faces_(mesh.boundaryMesh(execution))
    , points_(3 * static_cast<std::size_t>(mesh.pointCount()))
  {
    mesh.writePoints(points_.data(), execution);
  }

  PrismStacks run()
  {
    findLayered();
    liftNodes();
    numberNodes();
    listEdges();
    keepOldBoundary();
    for (std::size_t f = 0; f < layered_.size(); ++f)
    {
      if (hasStack(f))
      {
        addStack(f);
      }
    }
    result_.offsets.push_back(static_cast<Id>(result_.connectivity.size()));
    listBoundaryPoints();
    return std::move(result_);
  }

private:
  struct EdgeOfFace
  {
    Id lower;
    Id upper;
    std::size_t face;

    bool operator<(const EdgeOfFace& other) const
    {
      return std::tie(lower, upper, face) < std::tie(other.lower, other.upper, other.face);
    }
  };

  std::size_t layers() const { return heights_.size() - 1; }
  std::size_t corners(std::size_t f) const
  {
    return static_cast<std::size_t>(faces_.start[f + 1] - faces_.start[f]);
  }

  // Index in faces_.meshPoint.
  std::size_t node(std::size_t f, std::size_t i) const
  {
    return static_cast<std::size_t>(
      faces_.corners[static_cast<std::size_t>(faces_.start[f]) + i % corners(f)]);
  }

  void findLayered()
  {
    layered_.resize(mesh_.boundary().size());
    isOnWall_.assign(faces_.meshPoint.size(), 0);
    for (std::size_t f = 0; f < layered_.size(); ++f)
    {
      layered_[f] = displacement_.hasLayers(mesh_.boundary()[f].boundary);
      for (std::size_t i = 0; layered_[f] && i < corners(f); ++i)
      {
        isOnWall_[node(f, i)] = 1;
      }
    }
  }

  Place find(const TriangleTree& tree, const Vector& at) const
  {
    Place best;
    for (double reach = LeastHeight; best.distance > reach && reach < LevelsOfTheDomain; reach *= 8)
    {
      const Vector r{ reach, reach, reach };
      tree.forEachWithin(minus(at, r), plus(at, r), [&](std::uint32_t t) {
        if (displacement_.hasLayers(surface_.boundary[t]))
        {
          const Corners c = surface_.corners(t);
          const Place place =
            nearestPlace({ asVector(c[0]), asVector(c[1]), asVector(c[2]) }, at, t);
          best = place < best ? place : best;
        }
      });
    }
    return best;
  }

  void liftNodes()
  {
    const TriangleTree tree(surface_, execution_);
    const Lattice& lattice = surface_.lattice;
    lifted_.resize(faces_.meshPoint.size());
    isLifted_.assign(lifted_.size(), 0);
    execution_.forEach(lifted_.size(), NodesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        if (!isOnWall_[n])
        {
          continue;
        }
        Vector at{};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          at[axis] = (base(n)[axis] - lattice.origin()[axis]) / lattice.step();
        }
        const Place place = find(tree, at);
        if (place.triangle == None)
        {
          continue;
        }
        const auto& t = surface_.triangles[place.triangle];
        const auto& original = displacement_.original;
        const Vector to = weighted({ asVector(original[t[0]]), asVector(original[t[1]]),
                                     asVector(original[t[2]]) },
          place.weights);
        isLifted_[n] = norm(minus(to, at)) > LeastHeight;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          lifted_[n][axis] = lattice.origin()[axis] + lattice.step() * to[axis];
        }
      }
    });
  }

  const double* base(std::size_t n) const
  {
    return &points_[3 * static_cast<std::size_t>(faces_.meshPoint[n])];
  }

  // Edges of other than two faces tell no neighbour: their nodes stay.
  void listEdges()
  {
    for (std::size_t f = 0; f < layered_.size(); ++f)
    {
      for (std::size_t i = 0; i < corners(f); ++i)
      {
        const auto a = static_cast<Id>(node(f, i));
        const auto b = static_cast<Id>(node(f, i + 1));
        edges_.push_back({ std::min(a, b), std::max(a, b), f });
      }
    }
    std::sort(edges_.begin(), edges_.end());
    for (auto begin = edges_.begin(); begin != edges_.end();)
    {
      const auto end = std::find_if(begin, edges_.end(), [&](const EdgeOfFace& edge) {
        return edge.lower != begin->lower || edge.upper != begin->upper;
      });
      if (end - begin != 2)
      {
        isLifted_[static_cast<std::size_t>(begin->lower)] = 0;
        isLifted_[static_cast<std::size_t>(begin->upper)] = 0;
      }
      begin = end;
    }
    numberNodes();
  }

  void numberNodes()
  {
    first_.assign(lifted_.size(), -1);
    result_.points.clear();
    for (std::size_t n = 0; n < lifted_.size(); ++n)
    {
      if (!isLifted_[n])
      {
        continue;
      }
      first_[n] = mesh_.pointCount() + static_cast<Id>(result_.points.size() / 3);
      for (std::size_t k = 1; k <= layers(); ++k)
      {
        const double h = heights_[layers() - k];
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          result_.points.push_back(lifted_[n][axis] + h * (base(n)[axis] - lifted_[n][axis]));
        }
      }
    }
  }

  // The mesh's point above a node, so many layers from the mesh.
  Id above(std::size_t n, std::size_t k) const
  {
    return k == 0 || first_[n] < 0 ? faces_.meshPoint[n] : first_[n] + static_cast<Id>(k) - 1;
  }

  bool hasStack(std::size_t f) const
  {
    bool any = false;
    for (std::size_t i = 0; i < corners(f); ++i)
    {
      any = any || isLifted_[node(f, i)];
    }
    return layered_[f] && any;
  }

  std::size_t beyond(std::size_t f, std::size_t a, std::size_t b) const
  {
    const EdgeOfFace edge{ static_cast<Id>(std::min(a, b)), static_cast<Id>(std::max(a, b)), 0 };
    const auto first = std::lower_bound(edges_.begin(), edges_.end(), edge);
    return first->face == f ? first[1].face : first->face;
  }

  void addBoundary(Id cell, std::int32_t boundary, BoundaryFace::Kind kind, std::size_t index,
    const std::vector<Id>& face)
  {
    result_.boundary.push_back({ cell, index, boundary, kind });
    result_.boundaryMesh.start.push_back(
      static_cast<Id>(result_.boundaryMesh.corners.size())); // the end comes last
    result_.boundaryMesh.corners.insert(
      result_.boundaryMesh.corners.end(), face.begin(), face.end());
  }

  void keepOldBoundary()
  {
    for (std::size_t f = 0; f < layered_.size(); ++f)
    {
      if (!hasStack(f))
      {
        std::vector<Id> face;
        for (std::size_t i = 0; i < corners(f); ++i)
        {
          face.push_back(above(node(f, i), 0));
        }
        const BoundaryFace& old = mesh_.boundary()[f];
        addBoundary(old.cell, old.boundary, old.kind, old.index, face);
      }
    }
  }

  void addStack(std::size_t f)
  {
    const BoundaryFace& base = mesh_.boundary()[f];
    for (std::size_t k = 0; k < layers(); ++k)
    {
      const Id cell = mesh_.cellCount() + static_cast<Id>(result_.cells());
      std::vector<std::vector<Id>> cellFaces(2);
      for (std::size_t i = 0; i < corners(f); ++i)
      {
        cellFaces[0].push_back(above(node(f, corners(f) - 1 - i), k));
        cellFaces[1].push_back(above(node(f, i), k + 1));
      }
      if (k + 1 == layers())
      {
        addBoundary(cell, base.boundary, BoundaryFace::Kind::Patch, base.index, cellFaces[1]);
      }
      for (std::size_t i = 0; i < corners(f); ++i)
      {
        addSide(f, i, k, cell, cellFaces);
      }
      addCell(cellFaces);
      result_.layer.push_back(static_cast<unsigned char>(layers() - k));
      result_.below.push_back(base.cell);
    }
  }

  void addSide(
    std::size_t f, std::size_t i, std::size_t k, Id cell, std::vector<std::vector<Id>>& cellFaces)
  {
    const std::size_t a = node(f, i);
    const std::size_t b = node(f, i + 1);
    std::vector<Id> side{ above(a, k), above(b, k), above(b, k + 1), above(a, k + 1) };
    if (side[2] == side[1])
    {
      side.erase(side.begin() + 2);
    }
    if (side.back() == side.front())
    {
      side.pop_back();
    }
    if (side.size() < 3)
    {
      return;
    }
    const std::size_t other = beyond(f, a, b);
    if (!layered_[other])
    {
      const BoundaryFace& there = mesh_.boundary()[other];
      addBoundary(cell, there.boundary, BoundaryFace::Kind::Patch, there.index, side);
    }
    cellFaces.push_back(std::move(side));
  }

  void addCell(const std::vector<std::vector<Id>>& cellFaces)
  {
    result_.offsets.push_back(static_cast<Id>(result_.connectivity.size()));
    result_.faceStart.push_back(static_cast<Id>(result_.faceStream.size()));
    result_.faceStream.push_back(static_cast<Id>(cellFaces.size()));
    std::vector<Id> points;
    for (const std::vector<Id>& face : cellFaces)
    {
      result_.faceStream.push_back(static_cast<Id>(face.size()));
      result_.faceStream.insert(result_.faceStream.end(), face.begin(), face.end());
      points.insert(points.end(), face.begin(), face.end());
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    result_.connectivity.insert(result_.connectivity.end(), points.begin(), points.end());
  }

  // Corners are the mesh's points so far.
  void listBoundaryPoints()
  {
    BoundaryMesh& mesh = result_.boundaryMesh;
    mesh.start.push_back(static_cast<Id>(mesh.corners.size()));
    mesh.meshPoint = mesh.corners;
    std::sort(mesh.meshPoint.begin(), mesh.meshPoint.end());
    mesh.meshPoint.erase(
      std::unique(mesh.meshPoint.begin(), mesh.meshPoint.end()), mesh.meshPoint.end());
    for (Id& corner : mesh.corners)
    {
      corner = std::lower_bound(mesh.meshPoint.begin(), mesh.meshPoint.end(), corner) -
        mesh.meshPoint.begin();
    }
  }

  const OutputMesh& mesh_;
  const Surface& surface_;
  const Displacement& displacement_;
  Execution& execution_;
  const std::vector<double> heights_; // above the wall, as parts of all
  const BoundaryMesh faces_;
  std::vector<double> points_;
  std::vector<std::uint8_t> layered_;  // of each face
  std::vector<std::uint8_t> isOnWall_; // of each node of faces_
  std::vector<std::uint8_t> isLifted_;
  std::vector<Vector> lifted_;
  std::vector<Id> first_; // of its points, or -1
  std::vector<EdgeOfFace> edges_;
  PrismStacks result_;
};

}

PrismStacks liftBoundary(const OutputMesh& mesh, const Surface& displaced,
  const Displacement& displacement, Execution& execution)
{
  return Lifter(mesh, displaced, displacement, execution).run();
}

}

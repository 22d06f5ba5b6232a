// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/PrismStacks.h"

#include "Polyhedra/CellGeometry.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

namespace
{

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

std::vector<EdgeOfFace> edgesOf(const LayeredWall& wall)
{
  std::vector<EdgeOfFace> edges;
  for (std::size_t f = 0; f < wall.layered.size(); ++f)
  {
    for (std::size_t i = 0; i < wall.corners(f); ++i)
    {
      const auto a = static_cast<Id>(wall.node(f, i));
      const auto b = static_cast<Id>(wall.node(f, i + 1));
      edges.push_back({ std::min(a, b), std::max(a, b), f });
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

class Stacker
{
public:
  Stacker(const OutputMesh& mesh, const LayeredWall& wall, const std::vector<double>& heights)
    : mesh_(mesh)
    , wall_(wall)
    , heights_(heights)
    , edges_(edgesOf(wall))
  {
  }

  PrismStacks run()
  {
    moveNodes();
    numberNodes();
    keepOldBoundary();
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      if (wall_.hasStack(f))
      {
        addStack(f);
      }
    }
    result_.offsets.push_back(static_cast<Id>(result_.connectivity.size()));
    listBoundaryPoints();
    return std::move(result_);
  }

private:
  std::size_t layers() const { return heights_.size() - 1; }
  std::size_t corners(std::size_t f) const { return wall_.corners(f); }
  std::size_t node(std::size_t f, std::size_t i) const { return wall_.node(f, i); }

  void moveNodes()
  {
    for (std::size_t n = 0; n < wall_.nodes(); ++n)
    {
      if (wall_.parts[n] > 0)
      {
        result_.moved.push_back({ wall_.faces.meshPoint[n], wall_.at(n, 1) });
      }
    }
  }

  void numberNodes()
  {
    first_.assign(wall_.parts.size(), -1);
    for (std::size_t n = 0; n < wall_.parts.size(); ++n)
    {
      if (wall_.parts[n] == 0)
      {
        continue;
      }
      first_[n] = mesh_.pointCount() + static_cast<Id>(result_.points.size() / 3);
      for (std::size_t k = 1; k <= layers(); ++k)
      {
        const Vector at = wall_.at(n, heights_[layers() - k]);
        result_.points.insert(result_.points.end(), at.begin(), at.end());
        result_.nodeOfPoint.push_back(n);
      }
    }
  }

  // The mesh's point above a node, so many layers from the mesh.
  Id above(std::size_t n, std::size_t k) const
  {
    return k == 0 || first_[n] < 0 ? wall_.faces.meshPoint[n] : first_[n] + static_cast<Id>(k) - 1;
  }

  std::size_t beyond(std::size_t f, std::size_t a, std::size_t b) const
  {
    const EdgeOfFace edge{ static_cast<Id>(std::min(a, b)), static_cast<Id>(std::max(a, b)), 0 };
    const auto first = std::lower_bound(edges_.begin(), edges_.end(), edge);
    return first->face == f ? first[1].face : first->face;
  }

  void addBoundary(Id cell, std::int32_t boundary, BoundaryFace::Kind kind, std::size_t index,
    const std::vector<Id>& face, double thickness = 0)
  {
    result_.thickness.push_back(thickness);
    result_.boundary.push_back({ cell, index, boundary, kind });
    result_.boundaryMesh.start.push_back(
      static_cast<Id>(result_.boundaryMesh.corners.size())); // the end comes last
    result_.boundaryMesh.corners.insert(
      result_.boundaryMesh.corners.end(), face.begin(), face.end());
  }

  void keepOldBoundary()
  {
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      if (!wall_.hasStack(f))
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

  // The mean of its nodes, along the normal of the wall.
  double thicknessOf(std::size_t f) const
  {
    const FaceGeometry face =
      measureFace(corners(f), [&](std::size_t i) { return wall_.place[node(f, i)]; });
    double sum = 0;
    for (std::size_t i = 0; i < corners(f); ++i)
    {
      const std::size_t n = node(f, i);
      sum += dot(minus(wall_.place[n], wall_.at(n, 1)), unit(face.area));
    }
    return sum / static_cast<double>(corners(f));
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
        addBoundary(
          cell, base.boundary, BoundaryFace::Kind::Patch, base.index, cellFaces[1], thicknessOf(f));
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
    if (!wall_.layered[other])
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
  const LayeredWall& wall_;
  const std::vector<double>& heights_; // above the wall, as parts of all
  const std::vector<EdgeOfFace> edges_;
  std::vector<Id> first_; // of each node's points, or -1
  PrismStacks result_;
};

}

PrismStacks stackPrisms(
  const OutputMesh& mesh, const LayeredWall& wall, const std::vector<double>& heights)
{
  return Stacker(mesh, wall, heights).run();
}

std::vector<std::size_t> nodesWithoutLayers(const LayeredWall& wall)
{
  const std::vector<EdgeOfFace> edges = edgesOf(wall);
  std::vector<std::size_t> nodes;
  for (auto begin = edges.begin(); begin != edges.end();)
  {
    const auto end = std::find_if(begin, edges.end(), [&](const EdgeOfFace& edge) {
      return edge.lower != begin->lower || edge.upper != begin->upper;
    });
    if (end - begin != 2)
    {
      nodes.push_back(static_cast<std::size_t>(begin->lower));
      nodes.push_back(static_cast<std::size_t>(begin->upper));
    }
    begin = end;
  }
  return nodes;
}

}

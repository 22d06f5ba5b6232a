// SPDX-License-Identifier: BSD-3-Clause
// Where nodes along the wall may go: those inside anywhere, those of the surface along it; its edges and corners stay.
#pragma once

#include "Optimisation/WallMesh.h"

namespace cartesian
{

struct NodePath
{
  enum class Kind : std::uint8_t
  {
    Fixed,
    Line,  // along an edge of the surface, or a border between two of its boundaries
    Plane, // along the surface
    Free,
  };

  Kind kind = Kind::Fixed;
  Vector direction{}; // of the line, or normal to the plane
};

// What nodes may do, as the mesh is now.
class NodePaths
{
public:
  // `leastCosine`: of normals of boundary faces between which there is no edge.
  NodePaths(const WallMesh& mesh, double leastCosine);

  const NodePath& operator[](std::size_t node) const { return paths_[node]; }

  // Whether a node that was at `from` in the beginning and is at `to` shows the same surface: it has not left the planes of
  // its boundary faces, or its edge, by more than a small part of `edge`.
  bool allows(std::size_t node, const Vector& from, const Vector& to, double edge) const;

private:
  struct Use // of a node by a boundary face
  {
    std::uint32_t before; // corners of the face on either side
    std::uint32_t after;
    Vector normal;
    std::int32_t boundary;
  };

  NodePath pathOf(const WallMesh& mesh, std::uint32_t node, double leastCosine);

  std::vector<NodePath> paths_;
  std::vector<std::uint32_t> start_; // of the uses of each node, and the end
  std::vector<Use> uses_;
  std::vector<std::array<Vector, 2>>
    legs_;                            // of nodes on lines: unit vectors to the two next nodes on it
  std::vector<std::uint32_t> legsOf_; // of each node, or None
};

}

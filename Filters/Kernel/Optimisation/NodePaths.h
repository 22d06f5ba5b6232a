// SPDX-License-Identifier: BSD-3-Clause
// Where nodes along the wall may move: inner ones anywhere, surface nodes along the surface; its edges and corners
// stay.
#pragma once

#include "Optimisation/NodeMesh.h"

#include <limits>

namespace cartesian
{

struct NodePath
{
  enum class Kind : std::uint8_t
  {
    Fixed,
    Line,  // along an edge of the surface, or a border between two of its boundaries or regions
    Plane, // along the surface, or the interface of two regions
    Free,
  };

  Kind kind = Kind::Fixed;
  Vector direction{}; // of the line, or normal to the plane

  // What is left of a way along the line, or in the plane.
  Vector along(const Vector& way) const
  {
    if (kind == Kind::Free)
    {
      return way;
    }
    const Vector part = scaled(direction, dot(way, direction));
    return kind == Kind::Line ? part : minus(way, part);
  }
};

// Allowed motions of nodes in the current mesh.
class NodePaths
{
public:
  // `leastCosine`: of normals of walls between which there is no edge.
  NodePaths(const NodeMesh& mesh, double leastCosine);

  const NodePath& operator[](std::size_t node) const { return paths_[node]; }

  // Whether a node that was at `from` in the beginning may be at `to`: in the grid, not too far away, and where it shows
  // the same surface: it has not left the planes of its walls, or its edge, by more than a small part of `edge`.
  bool allows(std::size_t node, const Vector& from, const Vector& to, double edge) const;

private:
  // Of a node by a wall of a region; an interface is a wall of two. Those of a node come in order of regions.
  struct Use
  {
    std::uint32_t before; // corners of the face on either side
    std::uint32_t after;
    Vector normal; // out of the region
    std::int32_t boundary;
    std::int32_t region;
    bool isInterface;
    double edge; // of the smaller box at the face
  };

  // All walls of one region at a node.
  struct Sheet
  {
    bool closes = true; // each edge at the node is between two of them
    bool isSmooth = true;
    bool isFlat = true;
    bool isInterface = true;          // all of it
    std::vector<std::uint32_t> sharp; // the other ends of edges and borders at the node
    Vector mean{};                    // of the normals
    double edge = std::numeric_limits<double>::infinity(); // of the smallest box around it
  };

  void listUses(const NodeMesh& mesh);
  static Sheet sheetOf(const Use* begin, const Use* end, double leastCosine);

  // Whether two regions have the same sheet between them, or theirs meet in the same edges.
  static bool areTheSame(const Sheet& a, const Sheet& b);

  // Whether the line to both next nodes on it has one at a node; from there.
  static bool hasCorner(const Sheet& sheet, const Vector& ahead, const Vector& back);

  NodePath pathOf(const NodeMesh& mesh, std::uint32_t node, double leastCosine);

  std::array<Vector, 2> ends_; // of the grid
  std::vector<NodePath> paths_;
  std::vector<std::uint32_t> start_; // of the uses of each node, and the end
  std::vector<Use> uses_;
  std::vector<std::array<Vector, 2>>
    legs_;                            // of nodes on lines: unit vectors to the two next nodes on it
  std::vector<std::uint32_t> legsOf_; // of each node, or None
};

}

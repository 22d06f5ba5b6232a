// SPDX-License-Identifier: BSD-3-Clause
// Divides one triangle along points and edges in it, in the plane that it covers most of. All decisions are exact.
//
// The result is the constrained Delaunay triangulation there; of points on one circle, the lowest has all the
// diagonals. So the area between edges is divided alike in all coplanar triangles with the same edges.
#pragma once

#include "Repair/PointTree.h"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace cartesian
{

class TriangleDivision
{
public:
  using Triple = std::array<std::uint32_t, 3>;

  struct Spec
  {
    double reach = 0; // edges run through points that are nearer to them, in levels
    bool keepsEdges =
      false; // no triangle of three points of one edge is made for the sake of angles
  };

  // `vertices`: all places, by number; `axis`: along which they are seen, so that the triangle has an area.
  TriangleDivision(
    const std::vector<Point>& vertices, const Triple& triangle, int axis, const Spec& spec);

  // Puts vertices on the edge that starts at the i-th corner, in their order from there. Before all else.
  void divideEdge(std::size_t i, const std::vector<std::uint32_t>& vertices);

  // Adds a vertex to the triangle, unless it is present. Before all edges.
  void addPoint(std::uint32_t vertex);

  // Lets an edge run between two vertices, through others that lie on it. Does nothing where one of them is not there,
  // or both are on the same edge of the triangle, or where it would cross an edge that was added before.
  void addEdge(std::uint32_t from, std::uint32_t to);

  // Once all is there.
  std::vector<Triple> finish();

private:
  using Edge = std::array<std::uint32_t, 2>;

  static std::uint64_t keyOf(std::uint32_t from, std::uint32_t to)
  {
    return (static_cast<std::uint64_t>(from) << 32) | to;
  }
  static std::uint64_t keyOfEither(std::uint32_t p, std::uint32_t q)
  {
    return p < q ? keyOf(p, q) : keyOf(q, p);
  }

  std::uint32_t add(std::uint32_t vertex);
  int turnOf(std::uint32_t p, std::uint32_t q, std::uint32_t r) const;
  bool hasEdge(std::uint32_t from, std::uint32_t to) const;
  bool isFixed(std::uint32_t p, std::uint32_t q) const
  {
    return fixed_.count(keyOfEither(p, q)) != 0;
  }
  void set(std::size_t triangle, const Triple& corners);
  std::uint32_t across(std::uint32_t from, std::uint32_t to) const;
  void divideAt(std::uint32_t from, std::uint32_t to, std::uint32_t point);
  bool isIn(std::uint32_t triangle, const PlanePoint& place) const;
  std::uint32_t triangleAround(const PlanePoint& place) const;
  void addInside(std::uint32_t triangle, std::uint32_t point);
  bool areOnOneEdge(std::uint32_t p, std::uint32_t q) const
  {
    return (edgesOf_[p] & edgesOf_[q]) != 0;
  }
  bool areOnOneEdge(std::uint32_t p, std::uint32_t q, std::uint32_t r) const
  {
    return (edgesOf_[p] & edgesOf_[q] & edgesOf_[r]) != 0;
  }
  std::uint32_t pointBetween(std::uint32_t from, std::uint32_t to) const;
  bool addPiece(std::uint32_t from, std::uint32_t to);
  Edge firstAcross(std::uint32_t at, std::uint32_t from, std::uint32_t to) const;
  bool findAcross(std::uint32_t from, std::uint32_t to, std::deque<Edge>& crossing) const;
  bool crosses(std::uint32_t p, std::uint32_t q, std::uint32_t from, std::uint32_t to) const;
  bool flip(Edge& edge);
  bool isBetterFlipped(std::uint32_t from, std::uint32_t to) const;
  void improve(std::deque<Edge>& edges, std::size_t most);

  static constexpr std::uint32_t None = ~0u;

  const std::vector<Point>& vertices_;
  int axis_;
  Spec spec_;
  int way_ = 1;                        // 1 if the triangle is counter-clockwise as it is seen
  std::vector<std::uint32_t> points_;  // vertices; what follows has numbers of points
  std::vector<PlanePoint> at_;         // where they are seen
  std::vector<std::uint8_t> edgesOf_;  // on which edges of the triangle each is, as bits
  std::vector<std::uint32_t> besides_; // of each, another at the end of an edge from it
  std::unordered_map<std::uint32_t, std::uint32_t> numberOf_; // by vertex
  std::vector<Triple> triangles_;
  std::unordered_map<std::uint64_t, std::uint32_t> triangleAt_; // by an edge as it runs around it
  std::unordered_set<std::uint64_t> fixed_;                     // edges that were added
  std::unique_ptr<PointTree> tree_;                             // once edges are added
};

}

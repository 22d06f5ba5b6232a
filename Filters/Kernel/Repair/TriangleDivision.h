// SPDX-License-Identifier: BSD-3-Clause
// Divides one triangle along points and edges in it, exactly, in the plane that it covers most of.
#pragma once

#include "Lattice/Plane.h"

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

namespace cartesian
{

class TriangleDivision
{
public:
  using Triple = std::array<std::uint32_t, 3>;

  // `vertices`: all places, by number; `axis`: along which they are seen, so that the triangle has an area.
  TriangleDivision(const std::vector<Point>& vertices, const Triple& triangle, int axis);

  // Puts points on the edge that starts at the i-th corner, in their order from there.
  void divideEdge(std::size_t i, const std::vector<std::uint32_t>& points);

  // Puts a point into the triangle, unless it is there.
  void addPoint(std::uint32_t point);

  // Lets an edge run between two points that are there, through others that lie on it. Does nothing where both
  // are on the same edge of the triangle.
  void addEdge(std::uint32_t from, std::uint32_t to);

  const std::vector<Triple>& triangles() const { return triangles_; }

private:
  struct EdgeAt
  {
    std::size_t triangle;
    std::size_t corner; // the edge runs from there to the next
  };

  PlanePoint at(std::uint32_t point) const;
  int turnOf(std::uint32_t p, std::uint32_t q, std::uint32_t r) const;
  bool hasEdge(std::uint32_t from, std::uint32_t to) const;
  bool find(std::uint32_t from, std::uint32_t to, EdgeAt& at) const;
  bool areOnOneEdge(std::uint32_t p, std::uint32_t q) const;
  std::uint32_t pointBetween(std::uint32_t from, std::uint32_t to) const;
  bool crosses(std::uint32_t p, std::uint32_t q, std::uint32_t from, std::uint32_t to) const;
  std::deque<std::array<std::uint32_t, 2>> edgesAcross(std::uint32_t from, std::uint32_t to) const;
  bool flip(std::array<std::uint32_t, 2>& edge);

  static constexpr std::uint32_t None = ~0u;

  const std::vector<Point>& vertices_;
  int axis_;
  int way_ = 1; // 1 if the triangle is counter-clockwise as it is seen
  std::vector<Triple> triangles_;
  std::array<std::vector<std::uint32_t>, 3> onEdge_; // with both ends
  std::vector<std::uint32_t> points_;
};

}

// SPDX-License-Identifier: BSD-3-Clause
// Two divisions of the same part of a plane, united: each polygon lies in one of the first and in one of the second, as faces on
// either side of a periodic pair of boundaries must be.
//
// The first stays where it is. The second's outline moves onto the first's (OutlineFitting.h). Points of the
// second that are near to a point or an edge of the first move there; its edges bend through points of the first that are near:
// so there are few slivers. Where edges still cross, both get a point.
#pragma once

#include "Sections/PlanePolygons.h"

namespace cartesian
{

struct PlaneOverlay
{
  // What is nearer to a point or an edge than this part of the shortest distance in its polygons is on it.
  static constexpr double Nearby = 0.25;

  static constexpr std::uint32_t NoPoint = ~std::uint32_t(0);

  struct Vertex
  {
    PlanePlace at;
    std::array<std::uint32_t, 2> point; // of the first and the second division, or NoPoint
  };
  struct Polygon
  {
    std::size_t firstCorner;
    std::array<std::uint32_t, 2> of; // of the first and of the second
  };

  // An edge of a division that has got vertices, in order from its first to its second end, which is the higher.
  struct Chain
  {
    std::array<std::uint32_t, 2> ends; // points
    std::vector<std::uint32_t> vertices;
  };

  std::vector<Vertex> vertices;
  std::vector<Polygon> polygons;
  std::vector<std::uint32_t> corners;       // vertices, counter-clockwise; up to the next polygon's
  std::array<std::vector<Chain>, 2> chains; // by their ends

  // What only one of the divisions has, or has lost: its area, and a place in the largest part.
  double unmatched = 0;
  PlanePlace unmatchedAt{};
};

PlaneOverlay overlay(const PlanePolygons& first, const PlanePolygons& second);

}

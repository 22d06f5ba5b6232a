// SPDX-License-Identifier: BSD-3-Clause
// The polygons of one box while they are simplified, with the normals of what each came from.
#pragma once

#include "Patches/BoxSurface.h"

namespace cartesian
{

// Holds the normals of several triangles.
struct NormalCone
{
  Vector axis;   // of length 1, or 0: there are no normals
  double spread; // half angle, radians
};

// A cone that holds two.
NormalCone around(const NormalCone& a, const NormalCone& b);

double angleBetween(const Vector& a, const Vector& b);

struct Polygon
{
  std::size_t first; // in corners
  std::uint32_t size;
  std::uint32_t triangle; // of the surface
  double area;            // of the part of that triangle that the polygon comes from
  NormalCone cone;        // of all that it comes from
  bool alive;
};

struct PolygonEdge
{
  std::uint32_t lower; // points
  std::uint32_t upper;
  std::uint32_t polygon;
  bool down; // the polygon runs from upper to lower

  bool sameEdge(const PolygonEdge& other) const
  {
    return lower == other.lower && upper == other.upper;
  }
};

// Polygons that were replaced stay in their places, not alive. Keeps its storage from box to box.
struct BoxPolygons
{
  std::vector<Vector> at;                     // each point, from the box's low corner
  std::vector<PointKind> kinds;               // of points, or empty (BoxSurface)
  std::vector<unsigned> planes;               // of the box, that each point lies on (planesOf)
  std::vector<std::vector<std::uint32_t>> of; // polygons of each point, dead ones too
  std::vector<Polygon> polygons;
  std::vector<std::uint32_t> corners;
  double shortest = 0;     // edge length that a mesh may have, levels
  double shortestSide = 0; // of the box, levels

  void begin(const Box& box, const BoxSurface& piece, double shortestEdge);

  // Appends a polygon like another except for its corners and its cone.
  void append(const std::uint32_t* begin, const std::uint32_t* end, const Polygon& like,
    const NormalCone& cone);

  const std::uint32_t* cornersOf(const Polygon& p) const { return corners.data() + p.first; }

  // Edges of the living polygons; equal ones follow each other.
  void listEdges(std::vector<PolygonEdge>& edges) const;

  // Whether a polygon is thinner than the shortest edge.
  bool isSliver(const Polygon& p) const;

  // Whether an edge between two polygons is sharp. Where the surface knows its sharp edges, so do its points
  // (BoxSurface), and no angle is asked.
  bool isSharp(const Surface& surface, const Polygon& p, const Polygon& q, std::uint32_t from,
    std::uint32_t to, double featureCosine) const;

  double edgeLength(std::uint32_t p, std::uint32_t q) const { return norm(minus(at[p], at[q])); }
  Vector areaVector(const std::uint32_t* begin, const std::uint32_t* end) const;
};

// The first edge beyond those that equal edges[i].
std::size_t endOfEqual(const std::vector<PolygonEdge>& edges, std::size_t i);

}
